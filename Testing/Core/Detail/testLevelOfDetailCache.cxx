// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Levels of detail of a mesh, some of them made in the background.

#include "gatunError.h"
#include "gatunLevelOfDetailCache.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <latch>
#include <map>
#include <mutex>
#include <thread>

namespace gatun::test
{
namespace
{
constexpr std::uint64_t Points = 100000;

/** Counts the work of all threads. */
struct Record
{
  std::atomic<int> Sources{ 0 };
  std::atomic<int> Blocks{ 0 };
  std::atomic<int> Clashes{ 0 }; // two threads where only one may be
  RaySource::Progress Progress;  // given to whom makes the levels; false when the cache ends
  std::function<void()> OnBlock = [] {}; // called for each block that is made
};

/** Notices another thread in the same place. */
class Alone
{
public:
  Alone(std::atomic<bool>& flag, Record& record)
    : Flag(flag)
  {
    record.Clashes += this->Flag.exchange(true) ? 1 : 0;
  }
  ~Alone() { this->Flag = false; }
  Alone(const Alone&) = delete;
  Alone& operator=(const Alone&) = delete;

private:
  std::atomic<bool>& Flag;
};

class FakeSource final : public RaySource
{
public:
  explicit FakeSource(std::shared_ptr<Record> record)
    : Reported(std::move(record))
  {
  }

  std::size_t GetNumberOfBlocks() const override { return 10; }
  const Bounds& GetBounds(std::size_t) const override { return this->Box; }
  Range GetRange(std::size_t) const override { return {}; }
  Blocks GetBlocks(std::span<const std::size_t> blocks, const Progress&) override
  {
    const Alone alone(this->InUse, *this->Reported);
    for (const auto block : blocks)
    {
      if (!this->Made[block])
      {
        this->Reported->OnBlock();
        this->Made[block] = true;
        ++this->Reported->Blocks;
      }
    }
    return Blocks(blocks.size());
  }

  std::map<std::size_t, bool> Made;

private:
  std::shared_ptr<Record> Reported;
  std::atomic<bool> InUse{ false };
  Bounds Box;
};

class FakeLevels final : public LevelsOfDetail
{
public:
  explicit FakeLevels(std::shared_ptr<Record> record)
    : Reported(std::move(record))
  {
  }

  std::uint64_t GetNumberOfPoints() const override { return Points; }
  std::uint64_t GetFewestPoints() const override { return 10; }
  /** With an error in pixels, a tenth of the points is enough. */
  DetailLevel MakeLevel(const DetailRequest& request, const RaySource::Progress&) override
  {
    const Alone alone(this->InUse, *this->Reported);
    ++this->Reported->Sources;
    const bool isRough = request.View && request.View->PixelError > 0;
    return { std::make_shared<FakeSource>(this->Reported), request.Points / (isRough ? 10 : 1) };
  }
  std::uint64_t EstimateTets(std::uint64_t points) const override { return 5 * points; }

private:
  std::shared_ptr<Record> Reported;
  std::atomic<bool> InUse{ false };
};

std::vector<DetailRequest> Uniform(const std::vector<std::uint64_t>& points)
{
  std::vector<DetailRequest> requests;
  for (const auto number : points)
  {
    requests.push_back({ number, {} });
  }
  return requests;
}

struct Sample
{
  std::shared_ptr<Record> Reported = std::make_shared<Record>();
  LevelOfDetailCache::Limits Limits{ std::uint64_t{ 1 } << 30, std::uint64_t{ 1 } << 30 };

  std::unique_ptr<LevelOfDetailCache> Make()
  {
    auto levels = std::make_unique<LevelOfDetailCache>(
      [told = this->Reported](const RaySource::Progress& progress)
      {
        told->Progress = progress;
        return std::make_shared<FakeLevels>(told);
      },
      std::make_shared<FakeSource>(this->Reported), this->Limits);
    levels->WaitForLevels();
    levels->Wait();
    // As if nothing had been made yet.
    this->Reported->Sources = 0;
    this->Reported->Blocks = 0;
    return levels;
  }
};

void Draw(RaySource& source)
{
  for (std::size_t block = 0; block < source.GetNumberOfBlocks(); ++block)
  {
    source.GetBlocks({ &block, 1 }, {});
  }
}

//------------------------------------------------------------------------------
TEST(LevelOfDetailCache, WhatIsWantedBecomesReady)
{
  Sample sample;
  const auto levels = sample.Make();
  EXPECT_EQ(levels->FindReady({ 1, {} }).Points, Points / 8); // nobody had to ask
  levels->Prepare(Uniform({ 500, 2000, Points }));
  levels->Wait();
  EXPECT_EQ(sample.Reported->Sources, 2);
  EXPECT_EQ(sample.Reported->Blocks, 30);
  EXPECT_EQ(levels->FindReady({ 500, {} }).Points, 500u);
  EXPECT_EQ(levels->FindReady({ 400, {} }).Points, 500u);
  EXPECT_EQ(levels->FindReady({ 1100, {} }).Points, 500u); // 1.1 halvings away against twice 0.9
  EXPECT_EQ(levels->FindReady({ 1900, {} }).Points, 2000u);
  EXPECT_EQ(levels->FindReady({ Points, {} }).Points, Points / 8);
  Draw(*levels->Get({ 500, {} }).Source);
  Draw(*levels->GetWhole());
  EXPECT_EQ(sample.Reported->Blocks, 30); // nothing was left to be made
  EXPECT_EQ(levels->Get({ Points, {} }).Source, levels->GetWhole());
}

//------------------------------------------------------------------------------
TEST(LevelOfDetailCache, LevelsWithFewerPointsThanWantedAreReady)
{
  const auto look = [](double x, double error)
  {
    const RayView view(
      { { { 1, 0, 0, x }, { 0, 1, 0, 0 }, { 0, 0, 1, -4 } } }, RayFrustum{}, 8, 8, 1);
    return std::make_shared<DetailView>(DetailView{ view, error, nullptr });
  };
  Sample sample;
  const auto levels = sample.Make();
  const DetailRequest rough{ 20000, look(0, 5) };
  levels->Prepare({ rough, { 20000, {} } });
  levels->Wait();
  EXPECT_EQ(levels->FindReady(rough), rough);
  // Levels of the view before, too, if they are as rough.
  const DetailRequest next{ 20000, look(1, 5) };
  EXPECT_EQ(levels->FindReady(next), rough);
  EXPECT_EQ(levels->FindReady({ 20000, look(0, 0) }), (DetailRequest{ 20000, {} }));
}

//------------------------------------------------------------------------------
TEST(LevelOfDetailCache, WhatIsNotReadyIsMadeAtOnce)
{
  Sample sample;
  const auto levels = sample.Make();
  const auto source = levels->Get({ 777, {} }).Source;
  EXPECT_EQ(sample.Reported->Sources, 1);
  EXPECT_EQ(levels->Get({ 777, {} }).Source, source);
  EXPECT_EQ(levels->Get({ 1, {} }).Source, levels->Get({ 10, {} }).Source); // as few as can be
  EXPECT_EQ(sample.Reported->Sources, 2);
}

//------------------------------------------------------------------------------
TEST(LevelOfDetailCache, NoSourceIsUsedByTwoThreads)
{
  Sample sample;
  sample.Reported->OnBlock = [] { std::this_thread::sleep_for(std::chrono::microseconds(300)); };
  const auto levels = sample.Make();
  for (int frame = 0; frame < 200; ++frame)
  {
    const std::uint64_t wanted = 1000 + 100 * static_cast<std::uint64_t>(frame % 13);
    levels->SetDrawing(true);
    levels->Prepare(Uniform({ wanted, wanted + 500, Points }));
    const auto ready = levels->FindReady({ wanted, {} }).Points;
    Draw(*(frame % 11 == 0 ? levels->GetWhole()
                           : levels->Get({ ready == 0 ? wanted : ready, {} }).Source));
    levels->SetDrawing(false);
    if (frame % 17 == 0)
    {
      levels->Get({ 5000 + static_cast<std::uint64_t>(frame), {} });
    }
  }
  EXPECT_EQ(sample.Reported->Clashes, 0);
}

//------------------------------------------------------------------------------
TEST(LevelOfDetailCache, WhatWasBegunIsGoneOnWith)
{
  Sample sample;
  const auto levels = sample.Make();
  std::latch begun(1);
  std::latch goOn(1);
  sample.Reported->OnBlock = [&]
  {
    if (sample.Reported->Blocks == 4)
    {
      begun.count_down();
      goOn.wait();
    }
  };
  levels->Prepare(Uniform({ 500 }));
  begun.wait();
  levels->Prepare({}); // stops the background after the block that it is at
  goOn.count_down();
  levels->Wait();
  EXPECT_EQ(sample.Reported->Blocks, 5);
  EXPECT_NE(levels->FindReady({ 500, {} }).Points, 500u);
  Draw(*levels->Get({ 500, {} }).Source);
  EXPECT_EQ(sample.Reported->Sources, 1);
  EXPECT_EQ(sample.Reported->Blocks, 10);
}

//------------------------------------------------------------------------------
TEST(LevelOfDetailCache, TheEndDoesNotWaitForWhatIsWanted)
{
  Sample sample;
  std::latch begun(1);
  {
    const auto levels = sample.Make();
    sample.Reported->OnBlock = [&]
    {
      begun.count_down();
      while (sample.Reported->Progress(0)) // until the cache ends
      {
        std::this_thread::yield();
      }
    };
    levels->Prepare(Uniform({ 500, 600, 700, 800, 900, 1000, Points }));
    begun.wait();
  }
  EXPECT_EQ(sample.Reported->Sources, 1);
  EXPECT_EQ(sample.Reported->Blocks, 1);
}

//------------------------------------------------------------------------------
TEST(LevelOfDetailCache, TheLeastRecentlyUsedAreRemovedFirst)
{
  Sample sample;
  sample.Limits.Simpler = 64 * 5 * 3000; // 3000 points
  const auto levels = sample.Make();
  const auto first = levels->Get({ 1000, {} }).Source;
  const auto second = levels->Get({ 1001, {} }).Source;
  levels->Get({ 1000, {} });
  levels->Get({ 900, {} });
  levels->Get({ 800, {} }); // 1001 has to go
  EXPECT_EQ(levels->Get({ 1000, {} }).Source, first);
  EXPECT_NE(levels->Get({ 1001, {} }).Source, second);
  // What does not fit is never made ready, but is made when it is needed.
  levels->Prepare(Uniform({ 3500 }));
  levels->Wait();
  EXPECT_LT(levels->FindReady({ 3500, {} }).Points, 3500u);
  EXPECT_NE(levels->Get({ 3500, {} }).Source, nullptr);
}

//------------------------------------------------------------------------------
TEST(LevelOfDetailCache, FailuresAreReported)
{
  const auto told = std::make_shared<Record>();
  const auto fail = [](const RaySource::Progress&) -> std::shared_ptr<LevelsOfDetail>
  { throw Error(ErrorCode::InvalidInput, "no way"); };
  LevelOfDetailCache levels(fail, std::make_shared<FakeSource>(told), {});
  EXPECT_THROW(levels.WaitForLevels(), Error);
  EXPECT_THROW(levels.FindLevels(), Error);
  levels.Prepare(Uniform({ 5 }));
  levels.Wait();
  Draw(*levels.GetWhole());
}

//------------------------------------------------------------------------------
TEST(LevelOfDetailCache, WaitingCanBeStoppedWhileTheWorkGoesOn)
{
  const auto told = std::make_shared<Record>();
  std::atomic<bool> hasBegun{ false };
  std::atomic<bool> mayEnd{ false };
  std::atomic<bool> wasStopped{ false };
  const auto make = [&](const RaySource::Progress& progress) -> std::shared_ptr<LevelsOfDetail>
  {
    hasBegun = true;
    hasBegun.notify_all();
    while (!mayEnd && progress(0.5))
    {
      std::this_thread::yield();
    }
    wasStopped = !mayEnd;
    return std::make_shared<FakeLevels>(told);
  };
  {
    LevelOfDetailCache levels(make, std::make_shared<FakeSource>(told), {});
    EXPECT_THROW(levels.WaitForLevels([](double) { return false; }), Error);
    EXPECT_EQ(levels.FindLevels(), nullptr);
    levels.Prepare(Uniform({ 5 })); // nothing is known yet
    mayEnd = true;
    EXPECT_EQ(levels.WaitForLevels().GetNumberOfPoints(), Points);
  }
  EXPECT_FALSE(wasStopped);
  hasBegun = false;
  mayEnd = false;
  {
    const LevelOfDetailCache levels(make, std::make_shared<FakeSource>(told), {});
    hasBegun.wait(false);
    // Ends although nothing is known.
  }
  EXPECT_TRUE(wasStopped);
}
}
}
