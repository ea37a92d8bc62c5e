// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunDetailCuts.h"

#include "gatunDetailWeights.h"
#include "gatunError.h"
#include "gatunMergeSelection.h"
#include "gatunParallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace gatun
{
namespace
{
// How many times as many points may be left as there are to be, and how often other merges are
// tried for this.
constexpr double Excess = 1.1;
constexpr int MostRounds = 6;

/** The values at a place. */
Range GetValues(const DetailCuts::Place& place)
{
  return place.Values.IsEmpty() ? Range{ place.Point.Value, place.Point.Value } : place.Values;
}
}

//------------------------------------------------------------------------------
DetailCuts::DetailCuts(std::shared_ptr<const MergeTree> tree,
  std::shared_ptr<const MergeDependencies> dependencies, std::uint64_t points,
  std::vector<Place> places, std::vector<std::uint32_t> placeOf, std::vector<std::uint32_t> open,
  double size)
  : Tree(std::move(tree))
  , Dependencies(std::move(dependencies))
  , Points(points)
  , Places(std::move(places))
  , PlaceOf(std::move(placeOf))
  , Open(std::move(open))
  , Size(size > 0 ? size : 1)
{
  const auto isKnown = [&](std::uint32_t place) { return place <= this->Places.size(); };
  if (this->PlaceOf.size() != this->Tree->GetNumberOfPoints() ||
    !std::all_of(this->PlaceOf.begin(), this->PlaceOf.end(), isKnown))
  {
    ThrowInvalid("there is not a place for each point");
  }
}

//------------------------------------------------------------------------------
/** The weight of each place, and the largest of those in Open. */
std::vector<float> DetailCuts::Weigh(const DetailView& view) const
{
  const DetailWeights weights(view.View, this->Size);
  std::vector<float> result(this->Places.size() + 1, 0);
  constexpr std::size_t atOnce = 4096;
  ParallelFor((this->Places.size() + atOnce - 1) / atOnce,
    [&](std::size_t part)
    {
      const auto end = std::min(this->Places.size(), (part + 1) * atOnce);
      for (auto i = part * atOnce; i < end; ++i)
      {
        const RayPoint& point = this->Places[i].Point;
        const bool isHidden = view.Table && view.Table->IsTransparent(GetValues(this->Places[i]));
        result[i] = isHidden ? 0 : weights.Get(std::array{ point.X, point.Y, point.Z });
      }
    });
  for (const auto place : this->Open)
  {
    result.back() = std::max(result.back(), result[place]);
  }
  return result;
}

//------------------------------------------------------------------------------
double DetailCuts::GetLargestWeight(const DetailView& view) const
{
  const auto weights = this->Weigh(view);
  return *std::max_element(weights.begin(), weights.end());
}

//------------------------------------------------------------------------------
MergeCut DetailCuts::Choose(const DetailView& view, std::uint64_t points) const
{
  const auto ofPlaces = this->Weigh(view);
  std::vector<float> weights(this->PlaceOf.size());
  std::transform(this->PlaceOf.begin(), this->PlaceOf.end(), weights.begin(),
    [&](std::uint32_t place) { return ofPlaces[place]; });
  // Merges that need others are not done without them, so that more must be wanted than done: a
  // search between as many points as may be left and none.
  const std::uint64_t all = this->Points;
  const auto most = static_cast<double>(std::max<std::uint64_t>(std::min(all, points), 1));
  double wanted = most;
  double tooMany = most;
  double tooFew = 0;
  double nearest = std::numeric_limits<double>::infinity();
  std::optional<MergeCut> best;
  for (int round = 0; round < MostRounds; ++round)
  {
    const auto merges = static_cast<std::size_t>(all - static_cast<std::uint64_t>(wanted));
    const double tolerance = FindTolerance(*this->Tree, weights, merges);
    if (!(tolerance > view.PixelError))
    {
      return this->Do(weights, view.PixelError);
    }
    MergeCut cut = this->Do(weights, tolerance);
    const double left = static_cast<double>(all - cut.GetNumberOfMerges()) / most;
    const double away = std::abs(std::log(left));
    if (away < nearest)
    {
      nearest = away;
      best = std::move(cut);
    }
    if (left <= Excess && left >= 1 / Excess)
    {
      break;
    }
    (left > 1 ? tooMany : tooFew) = wanted;
    wanted = tooFew > 0 ? std::sqrt(tooFew * tooMany) : wanted / left;
  }
  return *std::move(best);
}

//------------------------------------------------------------------------------
MergeCut DetailCuts::Do(const std::vector<float>& weights, double tolerance) const
{
  return { *this->Tree, *this->Dependencies, SelectMerges(*this->Tree, weights, tolerance) };
}
}
