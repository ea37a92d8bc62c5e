// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunBackgroundWorker.h"

#include "gatunParallel.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace gatun
{
namespace
{
// So that a long step is not followed by a rest that a user would notice.
constexpr std::chrono::milliseconds MostRest{ 200 };
}

//------------------------------------------------------------------------------
BackgroundWorker::~BackgroundWorker()
{
  {
    const auto lock = this->Lock();
    this->IsEnding = true;
  }
  this->Stop();
  if (this->Thread.joinable())
  {
    this->Thread.join();
  }
}

//------------------------------------------------------------------------------
void BackgroundWorker::Request(Task task)
{
  std::optional<Task> next;
  if (task)
  {
    if (!this->Thread.joinable())
    {
      this->Thread = std::thread([this] { this->Run(); });
    }
    next = std::move(task);
  }
  {
    const auto lock = this->Lock();
    this->Waiting.swap(next); // The task before is destroyed without the lock.
    this->IsOutdated = true;
    this->Failure = nullptr;
  }
  this->Changed.notify_all();
}

//------------------------------------------------------------------------------
void BackgroundWorker::Stop()
{
  std::optional<Task> forgotten; // destroyed without the lock
  {
    const auto lock = this->Lock();
    this->Waiting.swap(forgotten);
    this->IsStopped = true;
  }
  this->Changed.notify_all();
}

//------------------------------------------------------------------------------
void BackgroundWorker::StopAndWait()
{
  this->Stop();
  this->Wait();
}

//------------------------------------------------------------------------------
void BackgroundWorker::Wait()
{
  auto lock = this->Lock();
  this->Changed.wait(lock, [this] { return !this->Waiting && !this->IsWorking; });
}

//------------------------------------------------------------------------------
bool BackgroundWorker::WaitFor(Clock::duration most, const std::function<bool()>& condition)
{
  auto lock = this->Lock();
  return this->Changed.wait_for(
    lock, most, [&] { return condition() || (!this->Waiting && !this->IsWorking); });
}

//------------------------------------------------------------------------------
bool BackgroundWorker::IsBusy()
{
  const auto lock = this->Lock();
  return this->Waiting || this->IsWorking;
}

//------------------------------------------------------------------------------
void BackgroundWorker::Rethrow()
{
  const auto lock = this->Lock();
  if (this->Failure)
  {
    std::rethrow_exception(this->Failure);
  }
}

//------------------------------------------------------------------------------
void BackgroundWorker::SetResting(bool rests)
{
  {
    const auto lock = this->Lock();
    this->IsResting = rests;
  }
  this->Changed.notify_all();
}

//------------------------------------------------------------------------------
void BackgroundWorker::Publish(const std::function<void()>& store)
{
  {
    const auto lock = this->Lock();
    if (!this->IsStopped)
    {
      store();
    }
  }
  this->Changed.notify_all();
}

//------------------------------------------------------------------------------
bool BackgroundWorker::GoOn()
{
  auto lock = this->Lock();
  this->Rest(lock);
  return !this->IsStopped;
}

//------------------------------------------------------------------------------
void BackgroundWorker::Rest(std::unique_lock<std::mutex>& lock)
{
  if (this->IsResting)
  {
    const auto rest = std::min<Clock::duration>(Clock::now() - this->LastRest, MostRest);
    this->Changed.wait_for(lock, rest, [this] { return this->IsStopped || !this->IsResting; });
  }
  this->LastRest = Clock::now();
}

//------------------------------------------------------------------------------
void BackgroundWorker::Run()
{
  auto lock = this->Lock();
  for (;;)
  {
    this->Changed.wait(lock, [this] { return this->IsEnding || this->Waiting; });
    if (this->IsEnding)
    {
      return;
    }
    std::optional<Task> task;
    this->Waiting.swap(task);
    this->IsWorking = true;
    this->IsStopped = false;
    this->IsOutdated = false;
    lock.unlock();

    this->LastRest = Clock::now();
    std::exception_ptr failure;
    try
    {
      ParallelFor(1, [&](std::size_t) { (*task)(); });
    }
    catch (...)
    {
      failure = std::current_exception();
    }
    task.reset(); // with all that it keeps alive, before others believe that it has ended

    lock.lock();
    this->IsWorking = false;
    if (!this->IsOutdated)
    {
      this->Failure = failure;
    }
    this->Changed.notify_all();
    this->Rest(lock);
  }
}
}
