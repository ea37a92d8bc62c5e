// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunParallel.h"

#include "gatunError.h"
#include "gatunThreads.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

namespace gatun
{
namespace
{
// Whether this thread executes a body of ParallelFor.
thread_local bool IsWithinBody = false;

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
}

//------------------------------------------------------------------------------
void WithNumberOfThreads(int count, const std::function<void()>& work)
{
  const int before = SetNumberOfThreads(count);
  std::exception_ptr failure;
  try
  {
    work();
  }
  catch (...)
  {
    failure = std::current_exception();
  }
  SetNumberOfThreads(before);
  if (failure)
  {
    std::rethrow_exception(failure);
  }
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
    RunOnThreads(takers, [&work] { work.Take(); });
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
