// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Compiled as C++17, see CMakeLists.txt.

#include "gtnThreads.h"

#include "vtkSMPTools.h"

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
  vtkSMPTools::Initialize(Limited(count));
}

//------------------------------------------------------------------------------
void WithThreads(int count, const std::function<void()>& work)
{
  vtkSMPTools::LocalScope(vtkSMPTools::Config(Limited(count)), [&work] { work(); });
}

//------------------------------------------------------------------------------
std::string ThreadBackend()
{
  return vtkSMPTools::GetBackend();
}
}
