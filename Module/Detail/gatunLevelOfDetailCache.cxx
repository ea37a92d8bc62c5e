// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunLevelOfDetailCache.h"

#include "gatunDetailWeights.h"
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
#include <optional>
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

// How many times more points a level for the present view is worth, in halvings, than one that is
// the same everywhere, and than that for the view before.
constexpr double HalvingsForView = 3;
constexpr double HalvingsForAge = 0.25;

/** A level of detail. */
struct Level
{
  DetailRequest Request;
  std::uint64_t View = 0; // the number of its view, if it has one
  DetailLevel Made;
  bool IsComplete = false; // all of its blocks were made, or it is in use
  std::uint64_t Used = 0;  // when
};
}

//------------------------------------------------------------------------------
class LevelOfDetailCache::Internals
{
public:
  Internals(MakeLevels makeLevels, std::shared_ptr<RaySource> whole, const Limits& limits)
    : Maker(std::move(makeLevels))
    , Whole(std::move(whole))
    , Space(limits)
  {
  }

  const MakeLevels Maker;
  const std::shared_ptr<RaySource> Whole;
  const Limits Space;
  std::atomic<double> Done{ 0 }; // fraction, of finding the levels of detail

  mutable std::mutex Guard; // of all that follows
  std::condition_variable Changed;
  std::shared_ptr<LevelsOfDetail> Detail;
  std::exception_ptr Failure; // the reason why there are none
  std::vector<Level> Levels;  // coarser than the whole mesh
  bool IsWholeComplete = false;
  std::uint64_t Uses = 0;
  std::deque<DetailRequest> Wanted;
  std::optional<DetailRequest> Now;              // the level in work
  std::shared_ptr<const DetailView> PresentView; // that was requested last
  std::uint64_t Views = 0;                       // that have been requested
  bool MustStop = false;                         // working on that level
  bool IsPaused = false;                         // the worker must not begin another level
  bool IsDrawing = false;
  bool IsEnding = false;

  std::thread Worker;

  // With the guard locked:
  bool IsWhole(const DetailRequest& request) const
  {
    return request.Points == this->Detail->GetNumberOfPoints() && !request.View;
  }
  DetailRequest Clamp(const DetailRequest& request) const;
  std::uint64_t GetBytes(std::uint64_t points) const
  {
    return BytesPerTet * this->Detail->EstimateTets(points);
  }
  std::uint64_t GetBytes(const DetailLevel& level) const
  {
    return level.Bytes + this->GetBytes(level.Points);
  }
  Level* Find(const DetailRequest& request);
  void Add(Level level);
  bool IsReady(const DetailRequest& request);
  bool IsWorthwhile(const DetailRequest& request);
  void SeeView(const DetailRequest& request);

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
    self.IsPaused = true;
    self.MustStop = true;
    self.Changed.notify_all();
    self.Changed.wait(lock, [&] { return !self.Now; });
  }
  ~Hold()
  {
    this->Self.IsPaused = false;
    this->Self.Changed.notify_all();
  }
  Hold(const Hold&) = delete;
  Hold& operator=(const Hold&) = delete;

private:
  Internals& Self;
};
}

//------------------------------------------------------------------------------
DetailRequest LevelOfDetailCache::Internals::Clamp(const DetailRequest& request) const
{
  const auto all = this->Detail->GetNumberOfPoints();
  DetailRequest result = request;
  result.Points = std::clamp(request.Points, this->Detail->GetFewestPoints(), all);
  if (result.Points == all && request.View && !(request.View->PixelError > 0))
  {
    result.View = nullptr;
  }
  return result;
}

//------------------------------------------------------------------------------
Level* LevelOfDetailCache::Internals::Find(const DetailRequest& request)
{
  const auto found = std::find_if(this->Levels.begin(), this->Levels.end(),
    [&](const Level& level) { return level.Request == request; });
  return found == this->Levels.end() ? nullptr : &*found;
}

//------------------------------------------------------------------------------
void LevelOfDetailCache::Internals::Add(Level level)
{
  level.Used = ++this->Uses;
  std::uint64_t bytes = this->GetBytes(level.Made);
  for (const Level& other : this->Levels)
  {
    bytes += this->GetBytes(other.Made);
  }
  while (!this->Levels.empty() && bytes > this->Space.Simpler)
  {
    const auto oldest = std::min_element(this->Levels.begin(), this->Levels.end(),
      [](const Level& a, const Level& b) { return a.Used < b.Used; });
    bytes -= this->GetBytes(oldest->Made);
    this->Levels.erase(oldest);
  }
  this->Levels.push_back(std::move(level));
}

//------------------------------------------------------------------------------
bool LevelOfDetailCache::Internals::IsReady(const DetailRequest& request)
{
  if (this->IsWhole(request))
  {
    return this->IsWholeComplete;
  }
  const Level* const level = this->Find(request);
  return level && level->IsComplete;
}

//------------------------------------------------------------------------------
bool LevelOfDetailCache::Internals::IsWorthwhile(const DetailRequest& request)
{
  return !this->IsReady(request) &&
    this->GetBytes(request.Points) <=
    (this->IsWhole(request) ? this->Space.Whole : this->Space.Simpler);
}

//------------------------------------------------------------------------------
void LevelOfDetailCache::Internals::SeeView(const DetailRequest& request)
{
  if (request.View && !(this->PresentView && *request.View == *this->PresentView))
  {
    this->PresentView = request.View;
    ++this->Views;
  }
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
    this->Wanted.push_back(this->Clamp({ points, nullptr }));
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
/** Makes the blocks of a level that are in its view until it must stop. */
void LevelOfDetailCache::Internals::Complete(Level& level)
{
  auto before = Clock::now();
  const auto rest = [&](double)
  {
    const bool goesOn = this->Rest(Clock::now() - before);
    before = Clock::now();
    return goesOn;
  };
  if (!level.Made.Source)
  {
    level.Made = this->Detail->MakeLevel(level.Request, this->Space.Simpler, rest);
  }
  RaySource& source = *level.Made.Source;
  std::optional<DetailWeights> weights;
  if (level.Request.View)
  {
    weights.emplace(level.Request.View->View, 1);
  }
  const auto blocks = source.GetNumberOfBlocks();
  for (std::size_t block = 0; rest(0); ++block)
  {
    if (block == blocks)
    {
      level.IsComplete = true;
      return;
    }
    if (!weights || weights->Get(source.GetBounds(block)) > 0)
    {
      source.GetBlocks({ &block, 1 }, {});
    }
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
      lock, [&] { return this->IsEnding || (!this->IsPaused && !this->Wanted.empty()); });
    if (this->IsEnding)
    {
      return;
    }
    Level level;
    level.Request = this->Wanted.front();
    level.View = this->Views;
    this->Wanted.pop_front();
    if (this->IsWorthwhile(level.Request))
    {
      const bool isWhole = this->IsWhole(level.Request);
      if (isWhole)
      {
        level.Made = { this->Whole, level.Request.Points };
      }
      else if (Level* const begun = this->Find(level.Request))
      {
        level = std::move(*begun);
        this->Levels.erase(this->Levels.begin() + (begun - this->Levels.data()));
      }
      this->Now = level.Request;
      this->MustStop = false;
      lock.unlock();
      try
      {
        this->Complete(level);
      }
      catch (...)
      {
        // Get will meet the same failure and report it.
        level.Made = {};
      }
      lock.lock();
      if (isWhole)
      {
        this->IsWholeComplete = level.IsComplete;
      }
      else if (level.Made.Source)
      {
        this->Add(std::move(level));
      }
      this->Now.reset();
    }
    this->Changed.notify_all();
  }
}

//------------------------------------------------------------------------------
LevelOfDetailCache::LevelOfDetailCache(
  MakeLevels makeLevels, std::shared_ptr<RaySource> whole, const Limits& limits)
  : Self(std::make_unique<Internals>(std::move(makeLevels), std::move(whole), limits))
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
  if (self.Now && self.IsWhole(*self.Now))
  {
    const Hold hold(self, lock);
  }
  // A source in use is not prepared in the background.
  self.IsWholeComplete = true;
  return self.Whole;
}

//------------------------------------------------------------------------------
DetailLevel LevelOfDetailCache::Get(const DetailRequest& wanted)
{
  auto& self = *this->Self;
  std::unique_lock<std::mutex> lock(self.Guard);
  const DetailRequest request = self.Clamp(wanted);
  if (self.IsWhole(request))
  {
    lock.unlock();
    return { this->GetWhole(), request.Points };
  }
  self.SeeView(request);
  if (!self.IsReady(request))
  {
    const Hold hold(self, lock);
    // The worker may have begun this level.
    if (!self.Find(request))
    {
      Level level;
      level.Request = request;
      level.View = self.Views;
      level.Made = self.Detail->MakeLevel(request, self.Space.Simpler, {});
      self.Add(std::move(level));
    }
  }
  Level* const level = self.Find(request);
  level->IsComplete = true;
  level->Used = ++self.Uses;
  return level->Made;
}

namespace
{
/** The number of points of a level as compared with those of a request. An error in pixels may
 * leave fewer points than were wanted: if it is the same error, that is no difference. */
double GetComparablePoints(const Level& level, const DetailRequest& wanted)
{
  const DetailView* const made = level.Request.View.get();
  const bool isAlike = made && wanted.View && made->PixelError == wanted.View->PixelError;
  return static_cast<double>(isAlike ? level.Request.Points : level.Made.Points);
}
}

//------------------------------------------------------------------------------
DetailRequest LevelOfDetailCache::FindReady(const DetailRequest& wanted) const
{
  const auto& self = *this->Self;
  const std::lock_guard<std::mutex> lock(self.Guard);
  DetailRequest best;
  double least = 0;
  for (const Level& level : self.Levels)
  {
    if (!level.IsComplete || (level.Request.View && !wanted.View))
    {
      continue;
    }
    const double halvings = std::log2(GetComparablePoints(level, wanted) /
      static_cast<double>(std::max<std::uint64_t>(wanted.Points, 1)));
    double away = halvings > 0 ? 2 * halvings : -halvings;
    if (wanted.View && !level.Request.View)
    {
      away += HalvingsForView;
    }
    else if (wanted.View && *level.Request.View != *wanted.View)
    {
      away += HalvingsForAge * (1 + static_cast<double>(self.Views - level.View));
    }
    if (best.Points == 0 || away < least)
    {
      best = level.Request;
      least = away;
    }
  }
  return best;
}

//------------------------------------------------------------------------------
void LevelOfDetailCache::Prepare(const std::vector<DetailRequest>& wanted)
{
  auto& self = *this->Self;
  const std::lock_guard<std::mutex> lock(self.Guard);
  if (!self.Detail)
  {
    return;
  }
  self.Wanted.clear();
  bool isAtIt = false;
  for (const auto& request : wanted)
  {
    const auto clamped = self.Clamp(request);
    self.SeeView(clamped);
    const bool isNow = self.Now && clamped == *self.Now;
    const bool isLike = isNow || (self.Now && self.Now->View && clamped.View);
    isAtIt = isAtIt || (isLike && self.Wanted.empty()); // what comes first is more urgent
    if (!isNow && self.IsWorthwhile(clamped))
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
  self.Changed.wait(lock, [&] { return self.Wanted.empty() && !self.Now; });
}
}
