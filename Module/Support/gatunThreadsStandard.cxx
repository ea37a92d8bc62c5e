// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Threads of a library without VTK.

#include "gatunParallel.h"
#include "gatunProcessors.h"
#include "gatunThreads.h"

#include <algorithm>
#include <atomic>

namespace gatun
{
namespace
{
std::atomic<int> Wanted{ 0 }; // 0 for the default
}

//------------------------------------------------------------------------------
void RunOnThreads(std::size_t count, const std::function<void()>& take)
{
  RunOnStandardThreads(count, take);
}

//------------------------------------------------------------------------------
int GetNumberOfThreads()
{
  const int wanted = Wanted;
  return wanted > 0 ? wanted : GetNumberOfProcessors();
}

//------------------------------------------------------------------------------
int SetNumberOfThreads(int count)
{
  return Wanted.exchange(std::max(count, 0));
}
}
