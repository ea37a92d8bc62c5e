// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Based on: Hugues Hoppe: View-dependent refinement of progressive meshes. SIGGRAPH 1997. David
// Luebke, Carl Erikson: View-dependent simplification of arbitrary polygonal environments. SIGGRAPH
// 1997.

#include "gatunCutChooser.h"

#include "gatunError.h"
#include "gatunMergeSelection.h"

#include <algorithm>
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
}

//------------------------------------------------------------------------------
CutChooser::CutChooser(std::shared_ptr<const MergeTree> tree,
  std::shared_ptr<const MergeDependencies> dependencies, std::uint64_t points)
  : Tree(std::move(tree))
  , Dependencies(std::move(dependencies))
  , Points(points)
{
  if (this->Dependencies->GetNumberOfMerges() != this->Tree->GetMerges().size())
  {
    ThrowInvalid("the dependencies are not those of the merges");
  }
}

//------------------------------------------------------------------------------
MergeCut CutChooser::Choose(const std::vector<float>& weights, const CutLimits& limits) const
{
  // Merges that need others are not done without them, so that more must be wanted than done: a
  // search between as many points as may be left and none.
  const std::uint64_t all = this->Points;
  const auto most = static_cast<double>(std::max<std::uint64_t>(std::min(all, limits.Points), 1));
  double wanted = most;
  double tooMany = most;
  double tooFew = 0;
  double nearest = std::numeric_limits<double>::infinity();
  std::optional<MergeCut> best;
  for (int round = 0; round < MostRounds; ++round)
  {
    const auto merges = static_cast<std::size_t>(all - static_cast<std::uint64_t>(wanted));
    const double tolerance = FindTolerance(*this->Tree, weights, merges);
    if (!(tolerance > limits.PixelError))
    {
      return this->Do(weights, limits.PixelError, limits.First);
    }
    MergeCut cut = this->Do(weights, tolerance, limits.First);
    const double left = static_cast<double>(all - cut.GetNumberOfMerges()) / most;
    const double away = std::abs(std::log(left));
    if (away < nearest)
    {
      nearest = away;
      best = std::move(cut);
    }
    const bool isCoarsest = left < 1 && wanted >= most; // nothing finer can be wanted
    if (isCoarsest || (left <= Excess && left >= 1 / Excess))
    {
      break;
    }
    (left > 1 ? tooMany : tooFew) = wanted;
    wanted = tooFew > 0 ? std::sqrt(tooFew * tooMany) : wanted / left;
  }
  return *std::move(best);
}

//------------------------------------------------------------------------------
MergeCut CutChooser::Do(
  const std::vector<float>& weights, double tolerance, std::size_t first) const
{
  std::vector<bool> wanted = SelectMerges(*this->Tree, weights, tolerance);
  std::fill_n(wanted.begin(), std::min(first, wanted.size()), true);
  return { *this->Tree, *this->Dependencies, std::move(wanted) };
}
}
