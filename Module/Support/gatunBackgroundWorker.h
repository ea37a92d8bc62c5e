// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunBackgroundWorker_h
#define gatunBackgroundWorker_h

#include "gatunExport.h" // For export macro

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

namespace gatun
{
/**
 * A background thread that carries out the latest task of its owner. It starts with the first task
 * and ends with this object, which stops the task at hand.
 *
 * A task that waits is replaced by a later one. The task at hand ends by itself, when it finds that
 * it is replaced, or stopped. While the thread rests as long as it works, other threads have their
 * share of the processor. A ParallelFor of a task runs on this thread.
 *
 * The owner calls all methods from one thread, except those for tasks. It must outlive this object,
 * so this is its last member. One lock guards all that owner and tasks share.
 */
class GATUN_EXPORT BackgroundWorker
{
public:
  using Task = std::function<void()>;
  using Clock = std::chrono::steady_clock;

  BackgroundWorker() = default;
  ~BackgroundWorker();
  BackgroundWorker(const BackgroundWorker&) = delete;
  BackgroundWorker& operator=(const BackgroundWorker&) = delete;

  /** Requests a task. It takes the place of one that waits, and the task at hand is replaced. An
   * empty function requests nothing else. Throws std::system_error if there can be no thread. */
  void Request(Task task);

  /** Stops the task at hand, and forgets one that waits. Does not wait. */
  void Stop();

  /** Stops the task at hand, and waits until it ends. */
  void StopAndWait();

  /** Waits until all tasks are carried out. */
  void Wait();

  /** Waits until a condition holds, which is evaluated with the lock held, or all tasks are carried
   * out. Returns false if that takes too long. */
  bool WaitFor(Clock::duration most, const std::function<bool()>& condition);

  /** Whether a task waits or is at hand. */
  bool IsBusy();

  /** Throws the exception that ended the last task, if there was one. */
  void Rethrow();

  /** Whether the thread rests as long as it works; it does by default. */
  void SetResting(bool rests);

  /** Locks what owner and tasks share. */
  std::unique_lock<std::mutex> Lock() { return std::unique_lock<std::mutex>(this->Guard); }

  //@{
  /** For tasks: whether the one at hand has to stop, or to end soon as another one waits or nothing
   * is requested any more. */
  bool MustStop() const { return this->IsStopped; }
  bool IsReplaced() const { return this->IsStopped || this->IsOutdated; }
  //@}

  /** For tasks: rests as long as the thread has worked since the last rest, at most 200 ms. Returns
   * false if the task has to stop. */
  bool GoOn();

  /** For tasks: calls a function with the lock held, unless the task has to stop. */
  void Publish(const std::function<void()>& store);

private:
  void Run();
  void Rest(std::unique_lock<std::mutex>& lock);

  std::mutex Guard; // of all that follows
  std::condition_variable Changed;
  std::optional<Task> Waiting;
  std::exception_ptr Failure;
  std::atomic<bool> IsStopped{ false };  // written with the lock held only
  std::atomic<bool> IsOutdated{ false }; // likewise
  bool IsWorking = false;
  bool IsResting = true;
  bool IsEnding = false;

  Clock::time_point LastRest; // of the thread alone
  std::thread Thread;
};
}

#endif
