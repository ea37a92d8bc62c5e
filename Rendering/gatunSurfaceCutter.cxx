// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunSurfaceCutter.h"

#include "gatunDetailWeights.h"
#include "gatunFileReader.h"
#include "gatunParallel.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

namespace gatun
{
namespace
{
// Points of a base mesh for each one that may be left.
constexpr std::uint64_t BasePoints = 8;

// The longest rest of the thread.
constexpr std::chrono::milliseconds MostRest{ 200 };
}

//------------------------------------------------------------------------------
SurfaceCutter::~SurfaceCutter()
{
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    this->IsEnding = true;
    ++this->Version;
  }
  this->Changed.notify_all();
  if (this->Worker.joinable())
  {
    this->Worker.join();
  }
}

//------------------------------------------------------------------------------
void SurfaceCutter::Clear()
{
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    this->Wanted.reset();
    this->Ready.reset();
    ++this->Version;
  }
  this->Changed.notify_all();
  const std::lock_guard<std::mutex> working(this->Working);
  this->Bases.clear();
  this->Coarsest = nullptr;
  this->FirstErrors.clear();
  this->Last = nullptr;
}

//------------------------------------------------------------------------------
void SurfaceCutter::Request(SurfaceCutOrder order)
{
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    this->Wanted = std::move(order);
    this->Ready.reset();
    if (!this->Worker.joinable())
    {
      this->Worker = std::thread([this] { this->Run(); });
    }
  }
  this->Changed.notify_all();
}

//------------------------------------------------------------------------------
bool SurfaceCutter::IsBusy()
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  return this->Wanted || this->IsWorking;
}

//------------------------------------------------------------------------------
std::optional<SurfaceCutResult> SurfaceCutter::Take()
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  return std::exchange(this->Ready, std::nullopt);
}

//------------------------------------------------------------------------------
void SurfaceCutter::Wait()
{
  std::unique_lock<std::mutex> lock(this->Guard);
  this->Changed.wait(lock, [this] { return !this->Wanted && !this->IsWorking; });
}

//------------------------------------------------------------------------------
SurfaceCutResult SurfaceCutter::Make(const SurfaceCutOrder& order, const Progress& progress)
{
  {
    // What the thread is about takes the place of nothing any more.
    const std::lock_guard<std::mutex> lock(this->Guard);
    this->Wanted.reset();
    this->Ready.reset();
    ++this->Version;
  }
  this->Changed.notify_all();
  const std::lock_guard<std::mutex> working(this->Working);
  return this->CarryOut(order, progress);
}

//------------------------------------------------------------------------------
void SurfaceCutter::Run()
{
  using Clock = std::chrono::steady_clock;
  std::unique_lock<std::mutex> lock(this->Guard);
  while (!this->IsEnding)
  {
    if (!this->Wanted)
    {
      this->Changed.wait(lock);
      continue;
    }
    const SurfaceCutOrder order = std::move(*this->Wanted);
    this->Wanted.reset();
    const auto version = this->Version;
    this->IsWorking = true;
    lock.unlock();
    const auto begin = Clock::now();
    SurfaceCutResult result;
    {
      const std::lock_guard<std::mutex> working(this->Working);
      // As one body, so that it takes this thread only.
      ParallelFor(1,
        [&](std::size_t)
        {
          auto last = begin;
          result = this->CarryOut(order,
            [&](double)
            {
              std::unique_lock<std::mutex> brief(this->Guard);
              // Rests in between, too.
              const auto rest = std::min<Clock::duration>(Clock::now() - last, MostRest);
              this->Changed.wait_for(brief, rest, [&] { return this->Version != version; });
              last = Clock::now();
              return this->Version == version;
            });
        });
    }
    const auto taken = std::min<Clock::duration>(Clock::now() - begin, MostRest);
    lock.lock();
    this->IsWorking = false;
    if (this->Version == version)
    {
      this->Ready = std::move(result);
    }
    this->Changed.notify_all();
    if (this->Version == version)
    {
      this->Changed.wait_for(lock, taken, [&] { return this->Version != version; });
    }
  }
}

//------------------------------------------------------------------------------
SurfaceCutResult SurfaceCutter::CarryOut(const SurfaceCutOrder& order, const Progress& progress)
{
  SurfaceCutResult result;
  try
  {
    const auto base = this->FindBase(order, progress);
    if (!base)
    {
      return result;
    }
    const std::size_t first = order.Merges - std::min(order.Merges, base->GetMerges());
    result.Cut = std::make_shared<const SurfaceCut>(
      base, base->GetDetail().Choose(order.View, first), this->Last.get());
    this->Last = result.Cut;
  }
  catch (...)
  {
    result.Failure = std::current_exception();
  }
  return result;
}

//------------------------------------------------------------------------------
/** At least the pixels of an error of 1 anywhere. */
double SurfaceCutter::BoundWeights(const SurfaceCutOrder& order, const Progress& progress)
{
  const FileReader& file = *order.Source.File->GetFile();
  const Bounds box = file.GetBounds(order.What.Step);
  const double size = GetDiagonal(box);
  if (file.GetLevels().empty())
  {
    return size > 0 ? order.View.Scale * double{ DetailWeights(order.View.View, size).Get(box) }
                    : 0;
  }
  if (!this->Coarsest)
  {
    this->Coarsest = std::make_shared<const SurfaceBase>(
      order.Source, file.GetLevels().back(), order.What, progress);
  }
  return this->Coarsest->GetDetail().BoundWeights(order.View);
}

//------------------------------------------------------------------------------
/** Whether no merge before a base mesh is more than the view allows, or it has enough points.
 * Weight: the largest one. */
bool SurfaceCutter::IsFineEnough(const SurfaceCutOrder& order, std::size_t merges, double weight)
{
  const FileReader& file = *order.Source.File->GetFile();
  const std::uint64_t points = file.GetNumberOfPoints() - merges;
  const SurfaceDetailView& view = order.View;
  if (view.Points < file.GetNumberOfPoints())
  {
    return points / BasePoints >= view.Points;
  }
  if (!this->FirstErrors.contains(merges))
  {
    const MergeTree tree = order.Source.File->GetHierarchy().Find(merges).File->GetMergeTree();
    this->FirstErrors[merges] = tree.GetMerges().empty() ? std::numeric_limits<double>::infinity()
                                                         : double{ tree.GetMerges().front().Error };
  }
  return weight * this->FirstErrors[merges] <= view.PixelError;
}

//------------------------------------------------------------------------------
/** The base mesh for an order; null if there is no room for it. */
std::shared_ptr<const SurfaceBase> SurfaceCutter::FindBase(
  const SurfaceCutOrder& order, const Progress& progress)
{
  const FileReader& file = *order.Source.File->GetFile();
  std::vector<std::size_t> levels{ 0 };
  levels.insert(levels.end(), file.GetLevels().begin(), file.GetLevels().end());
  const bool isCounted = order.View.Points < file.GetNumberOfPoints();
  const auto fits = [&](std::size_t merges)
  { return SurfaceBase::EstimateBytes(file.GetNumberOfPoints() - merges) <= order.MemoryLimit; };
  const auto isKnown = [&](const auto& base)
  { return base->GetSource().File == order.Source.File && base->GetContents() == order.What; };
  if (isCounted && !this->Bases.empty() && isKnown(this->Bases.front()))
  {
    // The last one, as long as it is not much too coarse or too fine.
    const std::uint64_t points =
      (file.GetNumberOfPoints() - this->Bases.front()->GetMerges()) / BasePoints;
    if (2 * points >= order.View.Points && points <= 4 * order.View.Points)
    {
      return this->Bases.front();
    }
  }
  const double weight = isCounted ? 0 : this->BoundWeights(order, progress);
  // From coarse to fine.
  std::optional<std::size_t> found;
  for (auto level = levels.rbegin(); level != levels.rend() && fits(*level); ++level)
  {
    const bool isEnough = this->IsFineEnough(order, *level, weight);
    found = isEnough || *level == 0 || isCounted ? std::optional(*level) : std::nullopt;
    if (isEnough)
    {
      break;
    }
  }
  if (!found)
  {
    return nullptr;
  }
  auto known = std::find_if(this->Bases.begin(), this->Bases.end(),
    [&](const auto& base) { return isKnown(base) && base->GetMerges() == *found; });
  if (known == this->Bases.end())
  {
    // Room for the new one first.
    constexpr std::size_t kept = 1;
    this->Bases.resize(std::min(this->Bases.size(), kept));
    const std::uint64_t both = this->Bases.empty()
      ? 0
      : 2 * file.GetNumberOfPoints() - this->Bases.front()->GetMerges() - *found;
    if (SurfaceBase::EstimateBytes(both) > order.MemoryLimit)
    {
      this->Bases.clear();
      this->Last = nullptr;
    }
    this->Bases.push_back(
      std::make_shared<const SurfaceBase>(order.Source, *found, order.What, progress));
    known = this->Bases.end() - 1;
  }
  std::rotate(this->Bases.begin(), known, known + 1);
  return this->Bases.front();
}
}
