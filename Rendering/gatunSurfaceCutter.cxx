// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunSurfaceCutter.h"

#include "gatunDetailWeights.h"
#include "gatunFileReader.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace gatun
{
namespace
{
// Points of a base mesh for each one that may be left.
constexpr std::uint64_t BasePoints = 8;
}

//------------------------------------------------------------------------------
void SurfaceCutter::Clear()
{
  this->Worker.StopAndWait();
  this->Take();
  this->Bases.clear();
  this->Coarsest = nullptr;
  this->FirstErrors.clear();
  this->Last = nullptr;
}

//------------------------------------------------------------------------------
void SurfaceCutter::Request(SurfaceCutOrder order)
{
  this->Take();
  this->Worker.Request(
    [this, order = std::move(order)]
    {
      auto result = this->CarryOut(order, [this](double) { return this->Worker.GoOn(); });
      this->Worker.Publish([&] { this->Ready = std::move(result); });
    });
}

//------------------------------------------------------------------------------
std::optional<SurfaceCutResult> SurfaceCutter::Take()
{
  const auto lock = this->Worker.Lock();
  return std::exchange(this->Ready, std::nullopt);
}

//------------------------------------------------------------------------------
SurfaceCutResult SurfaceCutter::Make(const SurfaceCutOrder& order, const Progress& progress)
{
  this->Worker.StopAndWait();
  this->Take(); // what was ordered before takes the place of nothing any more
  return this->CarryOut(order, progress);
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
    const MergeTree tree = order.Source.File->Find(merges).File->GetMergeTree();
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
