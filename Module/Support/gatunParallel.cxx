// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Compiled as C++17, see Module/CMakeLists.txt.

#include "gatunParallel.h"

#include "gatunError.h"
#include "gatunProcessors.h"

#include <vtkSMPTools.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <mutex>
#include <new>
#include <thread>
#include <vector>

namespace gatun
{
namespace
{
// Whether this thread executes a body of ParallelFor.
thread_local bool IsWithinBody = false;

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

/** Distributes bodies one by one, so that threads stay busy if the bodies are uneven. */
class Work
{
public:
  Work(std::size_t count, const std::function<void(std::size_t)>& body,
    const std::function<bool(double)>& progress)
    : Count(count)
    , Body(body)
    , Progress(progress)
    , Caller(std::this_thread::get_id())
  {
  }

  /** Runs bodies until there are none left or one has failed. */
  void Take()
  {
    // Allocates what this thread needs to throw. glibc aborts if it has to do that, in a program
    // that loads libraries at run time, when a body throws because memory is missing.
    static_cast<void>(std::current_exception());
    const bool reports = this->Progress && std::this_thread::get_id() == this->Caller;
    for (;;)
    {
      const auto i = this->Next++;
      if (i >= this->Count || this->Stop)
      {
        return;
      }
      try
      {
        if (reports && !this->Progress(static_cast<double>(i) / static_cast<double>(this->Count)))
        {
          throw Error(ErrorCode::Aborted, "aborted");
        }
        const Within within;
        this->Body(i);
      }
      catch (...)
      {
        const std::lock_guard<std::mutex> lock(this->Guard);
        if (!this->Failure)
        {
          this->Failure = std::current_exception();
        }
        this->Stop = true;
      }
    }
  }

  void Rethrow() const
  {
    if (this->Failure)
    {
      std::rethrow_exception(this->Failure);
    }
  }

private:
  struct Within
  {
    Within() { IsWithinBody = true; }
    ~Within() { IsWithinBody = this->Before; }
    const bool Before = IsWithinBody;
  };

  const std::size_t Count;
  const std::function<void(std::size_t)>& Body;
  const std::function<bool(double)>& Progress;
  const std::thread::id Caller;
  std::atomic<std::size_t> Next{ 0 };
  std::atomic<bool> Stop{ false };
  std::mutex Guard;
  std::exception_ptr Failure;
};

// What SetNumberOfThreads was told, where vtkSMPTools has one thread; 0 for the default.
std::atomic<int> OwnThreads{ 0 };

/** Whether vtkSMPTools has one thread although the user did not choose that. */
bool IsSequentialByDefault()
{
  return std::strcmp(vtkSMPTools::GetBackend(), "Sequential") == 0 &&
    !std::getenv("VTK_SMP_BACKEND_IN_USE");
}

/** What the user has chosen, as the backend STDThread of VTK finds it, or one for each processor
 * that this process may use. */
int GetNumberOfOwnThreads()
{
  int threads = OwnThreads;
  const char* const limit = std::getenv("VTK_SMP_MAX_THREADS");
  if (threads == 0 && limit)
  {
    threads = std::atoi(limit);
  }
  const auto most = static_cast<int>(std::thread::hardware_concurrency());
  return threads > 0 ? std::min(threads, std::max(most, 1)) : GetNumberOfProcessors();
}

/**
 * Calls take on so many threads, one of which is the caller's. vtkSMPTools could use another
 * backend for a while, but all threads of the process would, and a loop of VTK that another one is
 * in at that time would crash.
 */
template <typename Take>
void RunOnOwnThreads(std::size_t count, const Take& take)
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

/** Calls take on so many threads of vtkSMPTools. */
template <typename Take>
void RunOnThreads(std::size_t count, const Take& take)
{
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
}

//------------------------------------------------------------------------------
int GetNumberOfThreads()
{
  const int threads =
    IsSequentialByDefault() ? GetNumberOfOwnThreads() : vtkSMPTools::GetEstimatedNumberOfThreads();
  return threads > 1 ? threads : 1;
}

//------------------------------------------------------------------------------
void SetNumberOfThreads(int count)
{
  CheckMemoryForThreads();
  vtkSMPTools::Initialize(count);
  OwnThreads = count;
}

//------------------------------------------------------------------------------
void WithNumberOfThreads(int count, const std::function<void()>& work)
{
  CheckMemoryForThreads();
  const int before = OwnThreads.exchange(count);
  vtkSMPTools::LocalScope(vtkSMPTools::Config(count), [&work] { work(); });
  OwnThreads = before;
}

//------------------------------------------------------------------------------
std::string GetThreadBackend()
{
  return vtkSMPTools::GetBackend();
}

//------------------------------------------------------------------------------
void ParallelFor(std::size_t count, const std::function<void(std::size_t)>& body,
  const std::function<bool(double)>& progress)
{
  // An abort must be noticed even if other threads execute all bodies.
  if (progress && count > 0 && !progress(0))
  {
    throw Error(ErrorCode::Aborted, "aborted");
  }
  Work work(count, body, progress);
  // All threads are busy within a body, and not every version of VTK supports nesting.
  if (count > 1 && !IsWithinBody)
  {
    const auto takers = std::min(static_cast<std::size_t>(GetNumberOfThreads()), count);
    const auto take = [&work] { work.Take(); };
    if (IsSequentialByDefault())
    {
      RunOnOwnThreads(takers, take);
    }
    else
    {
      RunOnThreads(takers, take);
    }
  }
  work.Take(); // for a single body, and for backends that leave the calling thread idle
  work.Rethrow();
  // The same for an abort while other threads execute the last bodies.
  if (progress && count > 0 && !progress(1))
  {
    throw Error(ErrorCode::Aborted, "aborted");
  }
}
}
