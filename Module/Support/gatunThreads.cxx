// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunThreads.h"

#include <exception>
#include <thread>
#include <vector>

namespace gatun
{
//------------------------------------------------------------------------------
void RunOnStandardThreads(std::size_t count, const std::function<void()>& take)
{
  std::vector<std::thread> threads;
  threads.reserve(count);
  try
  {
    while (threads.size() + 1 < count)
    {
      threads.emplace_back(take);
    }
  }
  catch (const std::exception&)
  {
    // The threads that there are do the work.
  }
  take();
  for (auto& thread : threads)
  {
    thread.join();
  }
}
}
