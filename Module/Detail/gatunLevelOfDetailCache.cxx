// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunLevelOfDetailCache.h"

#include "gatunBackgroundWorker.h"
#include "gatunDetailWeights.h"
#include "gatunError.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <deque>
#include <mutex>
#include <optional>

namespace gatun
{
namespace
{
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
    , Space(limits)
  {
    this->Whole.Made.Source = std::move(whole);
  }

  const MakeLevels Maker;
  const Limits Space;
  std::atomic<double> Done{ 0 }; // fraction, of finding the levels of detail

  // With the lock of the worker:
  std::shared_ptr<LevelsOfDetail> Detail;
  Level Whole;               // the whole mesh, always there
  std::vector<Level> Levels; // coarser ones
  std::uint64_t Uses = 0;
  std::deque<DetailRequest> Wanted;
  std::optional<DetailRequest> Now;              // the level in work
  std::shared_ptr<const DetailView> PresentView; // that was requested last
  std::uint64_t Views = 0;                       // that have been requested

  BackgroundWorker Worker;

  // With the lock of the worker:
  bool IsWhole(const DetailRequest& request) const
  {
    return this->Detail && request == this->Whole.Request;
  }
  std::uint64_t GetBytes(std::uint64_t points) const
  {
    return BytesPerTet * this->Detail->EstimateTets(points);
  }
  std::uint64_t GetBytes(const DetailLevel& level) const
  {
    return level.Bytes + this->GetBytes(level.Points);
  }
  Level* Find(const DetailRequest& request);
  void Put(Level level);
  bool IsReady(const DetailRequest& request);
  bool IsWorthwhile(const DetailRequest& request);
  void SeeView(const DetailRequest& request);

  // Without it, in the background:
  void FindLevels();
  void Work();
  void Complete(Level& level);

  // Without it, elsewhere:
  void GoOn();
};

//------------------------------------------------------------------------------
Level* LevelOfDetailCache::Internals::Find(const DetailRequest& request)
{
  if (this->IsWhole(request))
  {
    return &this->Whole;
  }
  const auto found = std::find_if(this->Levels.begin(), this->Levels.end(),
    [&](const Level& level) { return level.Request == request; });
  return found == this->Levels.end() ? nullptr : &*found;
}

//------------------------------------------------------------------------------
/** Keeps a level, in place of what was known of it. */
void LevelOfDetailCache::Internals::Put(Level level)
{
  level.Used = ++this->Uses;
  if (Level* const known = this->Find(level.Request))
  {
    *known = std::move(level);
    return;
  }
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
  auto detail = this->Maker(
    [this](double done)
    {
      this->Done = done;
      return !this->Worker.MustStop();
    });
  if (!detail)
  {
    throw Error(ErrorCode::InvalidInput, "the mesh cannot be simplified");
  }
  this->Worker.Publish(
    [&]
    {
      this->Detail = std::move(detail);
      this->Whole.Request.Points = this->Whole.Made.Points = this->Detail->GetNumberOfPoints();
      // There can be no requests yet.
      auto points = this->Detail->GetNumberOfPoints();
      while (points > FirstPoints)
      {
        points /= 2;
      }
      this->Wanted.push_back(this->Detail->Clamp({ points, nullptr }));
    });
}

//------------------------------------------------------------------------------
/** Makes the blocks of a level that are in its view until it must stop. */
void LevelOfDetailCache::Internals::Complete(Level& level)
{
  const auto rest = [&](double) { return this->Worker.GoOn(); };
  if (!level.Made.Source)
  {
    level.Made = this->Detail->MakeLevel(level.Request, rest);
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
/** Makes the levels that are wanted. */
void LevelOfDetailCache::Internals::Work()
{
  auto lock = this->Worker.Lock();
  while (!this->Worker.MustStop() && !this->Wanted.empty())
  {
    const DetailRequest request = this->Wanted.front();
    this->Wanted.pop_front();
    if (!this->IsWorthwhile(request))
    {
      continue;
    }
    const Level* const begun = this->Find(request);
    Level level = begun ? *begun : Level{ request, this->Views, {} };
    this->Now = request;
    lock.unlock();
    bool isMade = true;
    try
    {
      this->Complete(level);
    }
    catch (...)
    {
      isMade = false; // Get will meet the same failure and report it.
    }
    lock.lock();
    if (isMade && level.Made.Source)
    {
      this->Put(std::move(level));
    }
    this->Now.reset();
  }
}

//------------------------------------------------------------------------------
/** Goes on with what is wanted. */
void LevelOfDetailCache::Internals::GoOn()
{
  const auto isEmpty = [this]
  {
    const auto lock = this->Worker.Lock();
    return this->Wanted.empty();
  };
  this->Worker.Request(isEmpty() ? BackgroundWorker::Task() : [this] { this->Work(); });
}

namespace
{
/** Stops the worker during its life. */
template <typename Internals>
class Hold
{
public:
  explicit Hold(Internals& self)
    : Self(self)
  {
    self.Worker.StopAndWait();
  }
  ~Hold() { this->Self.GoOn(); }
  Hold(const Hold&) = delete;
  Hold& operator=(const Hold&) = delete;

private:
  Internals& Self;
};
}

//------------------------------------------------------------------------------
LevelOfDetailCache::LevelOfDetailCache(
  MakeLevels makeLevels, std::shared_ptr<RaySource> whole, const Limits& limits)
  : Self(std::make_unique<Internals>(std::move(makeLevels), std::move(whole), limits))
{
  Internals* const self = this->Self.get();
  self->Worker.SetResting(false);
  self->Worker.Request(
    [self]
    {
      self->FindLevels();
      self->Work();
    });
}

//------------------------------------------------------------------------------
LevelOfDetailCache::~LevelOfDetailCache() = default;

//------------------------------------------------------------------------------
LevelsOfDetail* LevelOfDetailCache::FindLevels() const
{
  // Nothing is requested from the worker before it has found them.
  this->Self->Worker.Rethrow();
  const auto lock = this->Self->Worker.Lock();
  return this->Self->Detail.get();
}

//------------------------------------------------------------------------------
LevelsOfDetail& LevelOfDetailCache::WaitForLevels(const Progress& progress)
{
  auto& self = *this->Self;
  constexpr std::chrono::milliseconds between(50);
  while (!self.Worker.WaitFor(between, [&] { return self.Detail != nullptr; }))
  {
    if (progress && !progress(self.Done))
    {
      throw Error(ErrorCode::Aborted, "aborted");
    }
  }
  return *this->FindLevels();
}

//------------------------------------------------------------------------------
std::shared_ptr<RaySource> LevelOfDetailCache::GetWhole()
{
  auto& self = *this->Self;
  std::optional<Hold<Internals>> hold; // ends without the lock
  auto lock = self.Worker.Lock();
  if (self.Now && self.IsWhole(*self.Now))
  {
    lock.unlock();
    hold.emplace(self);
    lock.lock();
  }
  // A source in use is not prepared in the background.
  self.Whole.IsComplete = true;
  return self.Whole.Made.Source;
}

//------------------------------------------------------------------------------
DetailLevel LevelOfDetailCache::Get(const DetailRequest& wanted)
{
  auto& self = *this->Self;
  std::optional<Hold<Internals>> hold; // ends without the lock
  auto lock = self.Worker.Lock();
  const DetailRequest request = self.Detail->Clamp(wanted);
  if (self.IsWhole(request))
  {
    lock.unlock();
    return { this->GetWhole(), request.Points };
  }
  self.SeeView(request);
  if (!self.IsReady(request))
  {
    lock.unlock();
    hold.emplace(self);
    lock.lock();
  }
  // The worker may have begun this level.
  if (!self.Find(request))
  {
    self.Put({ request, self.Views, self.Detail->MakeLevel(request, {}) });
  }
  Level& level = *self.Find(request);
  level.IsComplete = true;
  level.Used = ++self.Uses;
  return level.Made;
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
  const auto lock = this->Self->Worker.Lock();
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
  std::deque<DetailRequest> worthwhile;
  bool isAtIt = false;
  {
    const auto lock = self.Worker.Lock();
    if (!self.Detail)
    {
      return;
    }
    self.Wanted.clear();
    for (const auto& request : wanted)
    {
      const auto clamped = self.Detail->Clamp(request);
      self.SeeView(clamped);
      const bool isNow = self.Now && clamped == *self.Now;
      const bool isLike = isNow || (self.Now && self.Now->View && clamped.View);
      isAtIt = isAtIt || (isLike && worthwhile.empty()); // what comes first is more urgent
      if (!isNow && self.IsWorthwhile(clamped))
      {
        worthwhile.push_back(clamped);
      }
    }
  }
  if (!isAtIt)
  {
    self.Worker.Stop();
  }
  {
    const auto lock = self.Worker.Lock();
    self.Wanted = std::move(worthwhile);
  }
  self.GoOn();
}

//------------------------------------------------------------------------------
void LevelOfDetailCache::SetDrawing(bool drawing)
{
  this->Self->Worker.SetResting(drawing);
}

//------------------------------------------------------------------------------
void LevelOfDetailCache::Wait()
{
  this->Self->Worker.Wait();
}
}
