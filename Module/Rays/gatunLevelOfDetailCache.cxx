// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunLevelOfDetailCache.h"

#include "gatunError.h"
#include "gatunParallel.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>

namespace gatun
{
namespace
{
using Clock = std::chrono::steady_clock;

// Approximate memory of a prepared block and of the data that it is made from.
constexpr std::uint64_t BytesPerTet = 64;

// Maximum number of points of the first level: few enough to be drawn at once, enough to show
// something.
constexpr std::uint64_t FirstPoints = 20000;

/** A level of detail. */
struct Level
{
  std::uint64_t Points = 0;
  std::shared_ptr<RaySource> Source;
  bool IsComplete = false; // all of its blocks were made, or it is in use
  std::uint64_t Used = 0;  // when
};
}

//------------------------------------------------------------------------------
class LevelOfDetailCache::Internals
{
public:
  Internals(MakeLevels makeLevels, std::shared_ptr<RaySource> whole, const Room& room)
    : Maker(std::move(makeLevels))
    , Whole(std::move(whole))
    , Space(room)
  {
  }

  const MakeLevels Maker;
  const std::shared_ptr<RaySource> Whole;
  const Room Space;
  std::atomic<double> Done{ 0 }; // fraction, of finding the levels of detail

  mutable std::mutex Guard; // of all that follows
  std::condition_variable Changed;
  std::shared_ptr<LevelsOfDetail> Detail;
  std::exception_ptr Failure; // the reason why there are none
  std::vector<Level> Levels;  // coarser than the whole mesh
  bool IsWholeComplete = false;
  std::uint64_t Uses = 0;
  std::deque<std::uint64_t> Wanted;
  std::uint64_t Now = 0; // the level in work; 0: none
  bool MustStop = false; // working on that level
  bool IsHeld = false;   // the worker must not begin another level
  bool IsDrawing = false;
  bool IsEnding = false;

  std::thread Worker;

  // With the guard locked:
  bool IsWhole(std::uint64_t points) const { return points == this->Detail->GetNumberOfPoints(); }
  std::uint64_t Clamp(std::uint64_t points) const
  {
    return std::clamp(points, this->Detail->GetFewestPoints(), this->Detail->GetNumberOfPoints());
  }
  std::uint64_t GetBytes(std::uint64_t points) const
  {
    return BytesPerTet * this->Detail->EstimateTets(points);
  }
  Level* Find(std::uint64_t points);
  void Add(Level level);
  bool IsReady(std::uint64_t points);
  bool IsWorthwhile(std::uint64_t points);

  // Without:
  void Work();
  void FindLevels();
  void Complete(Level& level);
  bool Rest(Clock::duration worked);
};

namespace
{
/** Stops the worker during its life. */
template <typename Internals>
class Hold
{
public:
  Hold(Internals& self, std::unique_lock<std::mutex>& lock)
    : Self(self)
  {
    self.IsHeld = true;
    self.MustStop = true;
    self.Changed.notify_all();
    self.Changed.wait(lock, [&] { return self.Now == 0; });
  }
  ~Hold()
  {
    this->Self.IsHeld = false;
    this->Self.Changed.notify_all();
  }
  Hold(const Hold&) = delete;
  Hold& operator=(const Hold&) = delete;

private:
  Internals& Self;
};
}

//------------------------------------------------------------------------------
Level* LevelOfDetailCache::Internals::Find(std::uint64_t points)
{
  const auto found = std::find_if(this->Levels.begin(), this->Levels.end(),
    [&](const Level& level) { return level.Points == points; });
  return found == this->Levels.end() ? nullptr : &*found;
}

//------------------------------------------------------------------------------
void LevelOfDetailCache::Internals::Add(Level level)
{
  level.Used = ++this->Uses;
  std::uint64_t bytes = this->GetBytes(level.Points);
  for (const Level& other : this->Levels)
  {
    bytes += this->GetBytes(other.Points);
  }
  while (!this->Levels.empty() && bytes > this->Space.Simpler)
  {
    const auto oldest = std::min_element(this->Levels.begin(), this->Levels.end(),
      [](const Level& a, const Level& b) { return a.Used < b.Used; });
    bytes -= this->GetBytes(oldest->Points);
    this->Levels.erase(oldest);
  }
  this->Levels.push_back(std::move(level));
}

//------------------------------------------------------------------------------
bool LevelOfDetailCache::Internals::IsReady(std::uint64_t points)
{
  if (this->IsWhole(points))
  {
    return this->IsWholeComplete;
  }
  const Level* const level = this->Find(points);
  return level && level->IsComplete;
}

//------------------------------------------------------------------------------
bool LevelOfDetailCache::Internals::IsWorthwhile(std::uint64_t points)
{
  return !this->IsReady(points) &&
    this->GetBytes(points) <= (this->IsWhole(points) ? this->Space.Whole : this->Space.Simpler);
}

//------------------------------------------------------------------------------
void LevelOfDetailCache::Internals::FindLevels()
{
  std::shared_ptr<LevelsOfDetail> detail;
  std::exception_ptr failure;
  try
  {
    detail = this->Maker(
      [this](double done)
      {
        this->Done = done;
        const std::lock_guard<std::mutex> lock(this->Guard);
        return !this->IsEnding;
      });
    if (!detail)
    {
      throw Error(ErrorCode::InvalidInput, "the mesh cannot be simplified");
    }
  }
  catch (...)
  {
    failure = std::current_exception();
  }
  const std::lock_guard<std::mutex> lock(this->Guard);
  this->Detail = std::move(detail);
  this->Failure = failure;
  if (this->Detail)
  {
    // There can be no requests yet.
    auto points = this->Detail->GetNumberOfPoints();
    while (points > FirstPoints)
    {
      points /= 2;
    }
    this->Wanted.push_back(this->Clamp(points));
  }
  this->Changed.notify_all();
}

//------------------------------------------------------------------------------
/** Leaves a share of the processor to frames. Returns false to stop. */
bool LevelOfDetailCache::Internals::Rest(Clock::duration worked)
{
  std::unique_lock<std::mutex> lock(this->Guard);
  if (this->IsDrawing)
  {
    this->Changed.wait_for(lock, worked, [&] { return this->MustStop || !this->IsDrawing; });
  }
  return !this->MustStop;
}

//------------------------------------------------------------------------------
/** Makes the blocks of a level until it must stop. */
void LevelOfDetailCache::Internals::Complete(Level& level)
{
  auto before = Clock::now();
  if (!level.Source)
  {
    level.Source = this->Detail->MakeSource(level.Points, this->Space.Simpler);
  }
  const auto blocks = level.Source->GetNumberOfBlocks();
  for (std::size_t block = 0; this->Rest(Clock::now() - before); ++block)
  {
    if (block == blocks)
    {
      level.IsComplete = true;
      return;
    }
    before = Clock::now();
    level.Source->GetBlocks({ &block, 1 }, {});
  }
}

//------------------------------------------------------------------------------
void LevelOfDetailCache::Internals::Work()
{
  this->FindLevels();
  std::unique_lock<std::mutex> lock(this->Guard);
  for (;;)
  {
    this->Changed.wait(
      lock, [&] { return this->IsEnding || (!this->IsHeld && !this->Wanted.empty()); });
    if (this->IsEnding)
    {
      return;
    }
    Level level;
    level.Points = this->Wanted.front();
    this->Wanted.pop_front();
    if (this->IsWorthwhile(level.Points))
    {
      const bool isWhole = this->IsWhole(level.Points);
      if (isWhole)
      {
        level.Source = this->Whole;
      }
      else if (Level* const begun = this->Find(level.Points))
      {
        level = std::move(*begun);
        this->Levels.erase(this->Levels.begin() + (begun - this->Levels.data()));
      }
      this->Now = level.Points;
      this->MustStop = false;
      lock.unlock();
      try
      {
        this->Complete(level);
      }
      catch (...)
      {
        // Get will meet the same failure and report it.
        level.Source = nullptr;
      }
      lock.lock();
      if (isWhole)
      {
        this->IsWholeComplete = level.IsComplete;
      }
      else if (level.Source)
      {
        this->Add(std::move(level));
      }
      this->Now = 0;
    }
    this->Changed.notify_all();
  }
}

//------------------------------------------------------------------------------
LevelOfDetailCache::LevelOfDetailCache(
  MakeLevels makeLevels, std::shared_ptr<RaySource> whole, const Room& room)
  : Self(std::make_unique<Internals>(std::move(makeLevels), std::move(whole), room))
{
  Internals* const self = this->Self.get();
  self->Worker = std::thread(
    [self]
    {
      // Within a body of ParallelFor, everything runs on this thread.
      ParallelFor(1, [self](std::size_t) { self->Work(); });
    });
}

//------------------------------------------------------------------------------
LevelOfDetailCache::~LevelOfDetailCache()
{
  {
    const std::lock_guard<std::mutex> lock(this->Self->Guard);
    this->Self->IsEnding = true;
    this->Self->MustStop = true;
    this->Self->Changed.notify_all();
  }
  this->Self->Worker.join();
}

//------------------------------------------------------------------------------
LevelsOfDetail* LevelOfDetailCache::FindLevels() const
{
  const std::lock_guard<std::mutex> lock(this->Self->Guard);
  if (this->Self->Failure)
  {
    std::rethrow_exception(this->Self->Failure);
  }
  return this->Self->Detail.get();
}

//------------------------------------------------------------------------------
LevelsOfDetail& LevelOfDetailCache::WaitForLevels(const Progress& progress)
{
  auto& self = *this->Self;
  constexpr std::chrono::milliseconds between(50);
  std::unique_lock<std::mutex> lock(self.Guard);
  while (!self.Changed.wait_for(lock, between, [&] { return self.Detail || self.Failure; }))
  {
    lock.unlock();
    if (progress && !progress(self.Done))
    {
      throw Error(ErrorCode::Aborted, "aborted");
    }
    lock.lock();
  }
  lock.unlock();
  return *this->FindLevels();
}

//------------------------------------------------------------------------------
std::shared_ptr<RaySource> LevelOfDetailCache::GetWhole()
{
  auto& self = *this->Self;
  std::unique_lock<std::mutex> lock(self.Guard);
  if (self.Now != 0 && self.IsWhole(self.Now))
  {
    const Hold hold(self, lock);
  }
  // A source in use is not prepared in the background.
  self.IsWholeComplete = true;
  return self.Whole;
}

//------------------------------------------------------------------------------
std::shared_ptr<RaySource> LevelOfDetailCache::Get(std::uint64_t points)
{
  auto& self = *this->Self;
  std::unique_lock<std::mutex> lock(self.Guard);
  points = self.Clamp(points);
  if (self.IsWhole(points))
  {
    lock.unlock();
    return this->GetWhole();
  }
  if (!self.IsReady(points))
  {
    const Hold hold(self, lock);
    // The worker may have begun this level.
    if (!self.Find(points))
    {
      Level level;
      level.Points = points;
      level.Source = self.Detail->MakeSource(points, self.Space.Simpler);
      self.Add(std::move(level));
    }
  }
  Level* const level = self.Find(points);
  level->IsComplete = true;
  level->Used = ++self.Uses;
  return level->Source;
}

//------------------------------------------------------------------------------
std::uint64_t LevelOfDetailCache::FindReady(std::uint64_t wanted) const
{
  const auto& self = *this->Self;
  const std::lock_guard<std::mutex> lock(self.Guard);
  std::uint64_t best = 0;
  double least = 0;
  for (const Level& level : self.Levels)
  {
    const double halvings = std::log2(
      static_cast<double>(level.Points) / static_cast<double>(std::max<std::uint64_t>(wanted, 1)));
    const double away = halvings > 0 ? 2 * halvings : -halvings;
    if (level.IsComplete && (best == 0 || away < least))
    {
      best = level.Points;
      least = away;
    }
  }
  return best;
}

//------------------------------------------------------------------------------
void LevelOfDetailCache::Prepare(const std::vector<std::uint64_t>& points)
{
  auto& self = *this->Self;
  const std::lock_guard<std::mutex> lock(self.Guard);
  if (!self.Detail)
  {
    return;
  }
  self.Wanted.clear();
  bool isAtIt = false;
  for (const auto wanted : points)
  {
    const auto clamped = self.Clamp(wanted);
    isAtIt = isAtIt || clamped == self.Now;
    if (clamped != self.Now && self.IsWorthwhile(clamped))
    {
      self.Wanted.push_back(clamped);
    }
  }
  self.MustStop = self.MustStop || !isAtIt;
  self.Changed.notify_all();
}

//------------------------------------------------------------------------------
void LevelOfDetailCache::SetDrawing(bool drawing)
{
  auto& self = *this->Self;
  const std::lock_guard<std::mutex> lock(self.Guard);
  self.IsDrawing = drawing;
  self.Changed.notify_all();
}

//------------------------------------------------------------------------------
void LevelOfDetailCache::Wait()
{
  auto& self = *this->Self;
  std::unique_lock<std::mutex> lock(self.Guard);
  self.Changed.wait(lock, [&] { return self.Wanted.empty() && self.Now == 0; });
}
}
