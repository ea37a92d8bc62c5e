// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunMergeSelection.h"

#include "gatunError.h"

#include <algorithm>

namespace gatun
{
namespace
{
/** The weighted error of a merge. An infinite error does not count where nothing does. */
double Weigh(const Merge& merge, std::span<const float> weights)
{
  const double weight = weights[merge.Point];
  return weight > 0 ? weight * merge.Error : 0;
}

void CheckWeights(const MergeTree& tree, std::span<const float> weights)
{
  if (weights.size() != tree.GetNumberOfPoints())
  {
    ThrowInvalid("there is not a weight for each point");
  }
}
}

//------------------------------------------------------------------------------
std::vector<bool> SelectMerges(
  const MergeTree& tree, std::span<const float> weights, double tolerance)
{
  CheckWeights(tree, weights);
  const double most = tolerance > 0 ? tolerance : 0;
  std::vector<bool> wanted(tree.GetMerges().size());
  std::transform(tree.GetMerges().begin(), tree.GetMerges().end(), wanted.begin(),
    [&](const Merge& merge) { return Weigh(merge, weights) <= most; });
  // Of merges that belong together, all or none: backwards to the first one, and then to the last.
  const auto& bonds = tree.GetBonds();
  for (std::size_t i = bonds.size(); i-- > 1;)
  {
    wanted[i - 1] = wanted[i - 1] && (!bonds[i - 1] || wanted[i]);
  }
  for (std::size_t i = 1; i < bonds.size(); ++i)
  {
    wanted[i] = wanted[i] && (!bonds[i - 1] || wanted[i - 1]);
  }
  return wanted;
}

//------------------------------------------------------------------------------
double FindTolerance(const MergeTree& tree, std::span<const float> weights, std::size_t merges)
{
  CheckWeights(tree, weights);
  std::vector<double> errors(tree.GetMerges().size());
  std::transform(tree.GetMerges().begin(), tree.GetMerges().end(), errors.begin(),
    [&](const Merge& merge) { return Weigh(merge, weights); });
  const std::size_t number = std::min(merges, errors.size());
  if (number == 0)
  {
    return 0;
  }
  const auto last = errors.begin() + static_cast<std::ptrdiff_t>(number - 1);
  std::nth_element(errors.begin(), last, errors.end());
  return *last;
}
}
