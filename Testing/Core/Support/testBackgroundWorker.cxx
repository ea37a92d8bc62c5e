// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunBackgroundWorker.h"

#include "gatunError.h"
#include "gatunParallel.h"

#include <gtest/gtest.h>

#include <chrono>
#include <latch>
#include <memory>
#include <thread>
#include <vector>

namespace
{
using namespace gatun;

/** A task that waits until it is released. */
struct Blocker
{
  std::latch Begun{ 1 };
  std::latch Released{ 1 };

  void Block()
  {
    this->Begun.count_down();
    this->Released.wait();
  }
};

void WorkUntilStopped(BackgroundWorker& worker)
{
  while (worker.GoOn())
  {
    std::this_thread::yield();
  }
}

//------------------------------------------------------------------------------
TEST(BackgroundWorker, TasksRunOneAfterTheOtherOnOneThread)
{
  std::vector<int> done;
  std::vector<std::thread::id> threads;
  BackgroundWorker worker;
  EXPECT_FALSE(worker.IsBusy());
  worker.Wait(); // for nothing
  for (const int number : { 1, 2, 3 })
  {
    worker.Request(
      [&, number]
      {
        done.push_back(number);
        std::vector<std::thread::id> inner(8);
        ParallelFor(inner.size(), [&](std::size_t i) { inner[i] = std::this_thread::get_id(); });
        threads.push_back(std::this_thread::get_id());
        threads.insert(threads.end(), inner.begin(), inner.end());
      });
    worker.Wait();
    EXPECT_FALSE(worker.IsBusy());
  }
  EXPECT_EQ(done, (std::vector{ 1, 2, 3 }));
  EXPECT_EQ(threads, std::vector<std::thread::id>(27, threads[0]));
  EXPECT_NE(threads[0], std::this_thread::get_id());
}

//------------------------------------------------------------------------------
TEST(BackgroundWorker, TheLatestTaskWins)
{
  std::vector<int> done;
  Blocker first;
  bool wasReplaced = false;
  bool hadToStop = true;
  BackgroundWorker worker;
  worker.Request(
    [&]
    {
      wasReplaced = worker.IsReplaced();
      first.Block();
      wasReplaced = !wasReplaced && worker.IsReplaced();
      hadToStop = worker.MustStop();
      worker.Publish([&] { done.push_back(1); });
    });
  first.Begun.wait();
  for (const int number : { 2, 3, 4 })
  {
    worker.Request([&, number] { done.push_back(worker.IsReplaced() ? 0 : number); });
  }
  EXPECT_TRUE(worker.IsBusy());
  first.Released.count_down();
  worker.Wait();
  EXPECT_EQ(done, (std::vector{ 1, 4 }));
  EXPECT_TRUE(wasReplaced);
  EXPECT_FALSE(hadToStop);
}

//------------------------------------------------------------------------------
TEST(BackgroundWorker, AnEmptyTaskReplacesTheOthers)
{
  bool wasReplaced = false;
  bool isSecondDone = false;
  Blocker first;
  BackgroundWorker worker;
  worker.Request({}); // needs no thread
  EXPECT_FALSE(worker.IsBusy());
  worker.Request(
    [&]
    {
      first.Block();
      wasReplaced = worker.IsReplaced();
    });
  first.Begun.wait();
  worker.Request([&] { isSecondDone = true; });
  worker.Request({});
  first.Released.count_down();
  worker.Wait();
  EXPECT_TRUE(wasReplaced);
  EXPECT_FALSE(isSecondDone);
}

//------------------------------------------------------------------------------
TEST(BackgroundWorker, WhatIsStoppedPublishesNothing)
{
  int published = 0;
  bool isSecondDone = false;
  Blocker first;
  BackgroundWorker worker;
  worker.Request(
    [&]
    {
      worker.Publish([&] { ++published; });
      first.Begun.count_down();
      WorkUntilStopped(worker);
      worker.Publish([&] { published += 100; });
    });
  first.Begun.wait();
  worker.Request([&] { isSecondDone = true; });
  worker.StopAndWait();
  EXPECT_EQ(published, 1);
  EXPECT_FALSE(isSecondDone);
  // What comes later is not stopped.
  worker.Request(
    [&]
    {
      EXPECT_TRUE(worker.GoOn());
      worker.Publish([&] { ++published; });
    });
  worker.Wait();
  EXPECT_EQ(published, 2);
}

//------------------------------------------------------------------------------
TEST(BackgroundWorker, ItsEndStopsTheTaskAtHand)
{
  bool wasStopped = false;
  bool isSecondDone = false;
  {
    Blocker first;
    BackgroundWorker worker;
    worker.Request(
      [&]
      {
        first.Begun.count_down();
        WorkUntilStopped(worker);
        wasStopped = worker.MustStop();
      });
    first.Begun.wait();
    worker.Request([&] { isSecondDone = true; });
  }
  EXPECT_TRUE(wasStopped);
  EXPECT_FALSE(isSecondDone);
}

//------------------------------------------------------------------------------
TEST(BackgroundWorker, ExceptionsReachTheOwner)
{
  BackgroundWorker worker;
  const auto fail = [] { throw Error(ErrorCode::Corrupt, "no"); };
  worker.Request(fail);
  worker.Wait();
  EXPECT_THROW(worker.Rethrow(), Error);
  EXPECT_THROW(worker.Rethrow(), Error);
  worker.Request([] {});
  worker.Wait();
  EXPECT_NO_THROW(worker.Rethrow());
  // Nobody needs the reason why a task failed that was replaced.
  Blocker first;
  worker.Request(
    [&]
    {
      first.Block();
      fail();
    });
  first.Begun.wait();
  worker.Request({});
  first.Released.count_down();
  worker.Wait();
  EXPECT_NO_THROW(worker.Rethrow());
}

//------------------------------------------------------------------------------
TEST(BackgroundWorker, TasksAreDestroyedWhenTheyEnd)
{
  const auto kept = std::make_shared<int>(1);
  Blocker first;
  BackgroundWorker worker;
  worker.Request([&first, kept] { first.Block(); });
  first.Begun.wait();
  EXPECT_EQ(kept.use_count(), 2);
  worker.Request([kept] {});
  EXPECT_EQ(kept.use_count(), 3);
  worker.Request([] {});
  EXPECT_EQ(kept.use_count(), 2);
  first.Released.count_down();
  worker.Wait();
  EXPECT_EQ(kept.use_count(), 1);
  for (int round = 0; round < 100; ++round)
  {
    worker.Request([kept] {});
    worker.Wait();
    EXPECT_EQ(kept.use_count(), 1);
  }
}

//------------------------------------------------------------------------------
TEST(BackgroundWorker, WaitingForAConditionEndsWithTheTasks)
{
  using namespace std::chrono_literals;
  int published = 0;
  Blocker first, second;
  BackgroundWorker worker;
  const auto isDone = [&] { return published == 1; };
  const auto never = [] { return false; };
  EXPECT_TRUE(worker.WaitFor(0ms, never));
  worker.Request(
    [&]
    {
      first.Block();
      worker.Publish([&] { ++published; });
      second.Block();
    });
  EXPECT_FALSE(worker.WaitFor(0ms, isDone));
  first.Released.count_down();
  EXPECT_TRUE(worker.WaitFor(1h, isDone)); // while the task goes on
  EXPECT_TRUE(worker.IsBusy());
  EXPECT_FALSE(worker.WaitFor(0ms, never));
  second.Released.count_down();
  EXPECT_TRUE(worker.WaitFor(1h, never));
}

//------------------------------------------------------------------------------
TEST(BackgroundWorker, OwnersAndTasksMeetAtAnyTime)
{
  unsigned last = 0;
  unsigned wrong = 0;
  BackgroundWorker worker;
  for (unsigned round = 1; round <= 2000; ++round)
  {
    worker.SetResting(round % 3 == 0);
    worker.Request(
      [&, round]
      {
        for (unsigned i = 0; i < round % 5 && worker.GoOn() && !worker.IsReplaced(); ++i)
        {
          worker.Publish(
            [&]
            {
              wrong += last > round; // orders are carried out in their order
              last = round;
            });
        }
      });
    if (round % 7 == 0)
    {
      worker.Stop();
      const auto lock = worker.Lock();
      last = 0;
    }
    if (round % 11 == 0)
    {
      worker.StopAndWait();
    }
    if (round % 13 == 0)
    {
      worker.Wait();
    }
  }
  worker.Wait();
  EXPECT_EQ(wrong, 0u);
}
}
