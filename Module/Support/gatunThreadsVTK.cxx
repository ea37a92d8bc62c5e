// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Threads of VTK's modules: those of vtkSMPTools. Compiled as C++17, because the header of
// vtkSMPTools in VTK 9.1 is not valid C++20.

#include "gatunParallel.h"
#include "gatunProcessors.h"
#include "gatunThreads.h"

#include <vtkSMPTools.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <cstring>
#include <new>
#include <thread>

namespace gatun
{
namespace
{
std::atomic<int> Wanted{ 0 }; // what SetNumberOfThreads was told; 0 for the default

/**
 * Throws std::bad_alloc if there is no memory for a parallel loop. oneTBB 2022 waits forever if
 * memory runs out while it starts one: it then asks whether to throw, with the lock of that setting
 * held. It and its allocator need less than 8 MiB.
 */
void CheckMemoryForThreads()
{
  constexpr std::size_t size = std::size_t{ 8 } << 20;
  auto* memory = static_cast<volatile char*>(::operator new(size));
  memory[0] = 0; // or else a compiler may leave out both calls
  ::operator delete(const_cast<char*>(memory));
}

/** Whether vtkSMPTools has one thread although the user did not choose that. Another backend would
 * be that of all threads of the process, and a loop of VTK that another one is in would crash. */
bool IsSequentialByDefault()
{
  return std::strcmp(vtkSMPTools::GetBackend(), "Sequential") == 0 &&
    !std::getenv("VTK_SMP_BACKEND_IN_USE");
}

/** What the user has chosen, as the backend STDThread of VTK finds it, or one for each processor
 * that this process may use. */
int GetNumberOfStandardThreads()
{
  int threads = Wanted;
  const char* const limit = std::getenv("VTK_SMP_MAX_THREADS");
  if (threads == 0 && limit)
  {
    threads = std::atoi(limit);
  }
  const auto most = static_cast<int>(std::thread::hardware_concurrency());
  return threads > 0 ? std::min(threads, std::max(most, 1)) : GetNumberOfProcessors();
}
}

//------------------------------------------------------------------------------
void RunOnThreads(std::size_t count, const std::function<void()>& take)
{
  if (IsSequentialByDefault())
  {
    RunOnStandardThreads(count, take);
    return;
  }
  CheckMemoryForThreads();
  auto takeSome = [&take](vtkIdType begin, vtkIdType end)
  {
    for (auto i = begin; i < end; ++i)
    {
      take();
    }
  };
  vtkSMPTools::For(0, static_cast<vtkIdType>(count), 1, takeSome);
}

//------------------------------------------------------------------------------
int GetNumberOfThreads()
{
  const int threads = IsSequentialByDefault() ? GetNumberOfStandardThreads()
                                              : vtkSMPTools::GetEstimatedNumberOfThreads();
  return threads > 1 ? threads : 1;
}

//------------------------------------------------------------------------------
int SetNumberOfThreads(int count)
{
  CheckMemoryForThreads();
  vtkSMPTools::Initialize(count);
  return Wanted.exchange(count);
}
}
