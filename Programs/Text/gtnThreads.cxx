// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnThreads.h"

#include "gatunParallel.h"

#include <vtkSMPTools.h>

#include <algorithm>
#include <thread>

namespace gtn
{
namespace
{

// TBB complains about more threads than there are processors, and does not start them.
int Limited(int count)
{
  const int most = static_cast<int>(std::thread::hardware_concurrency());
  return most > 0 ? std::min(count, most) : count;
}

} // anonymous namespace

//------------------------------------------------------------------------------
void SetThreads(int count)
{
  gatun::SetNumberOfThreads(Limited(count));
}

//------------------------------------------------------------------------------
void WithThreads(int count, const std::function<void()>& work)
{
  gatun::WithNumberOfThreads(Limited(count), work);
}

//------------------------------------------------------------------------------
std::string ThreadBackend()
{
  return vtkSMPTools::GetBackend();
}
}
