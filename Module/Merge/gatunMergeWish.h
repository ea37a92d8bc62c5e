// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunMergeWish_h
#define gatunMergeWish_h

#include "gatunExport.h"
#include "gatunMergeTree.h"

#include <cstddef>
#include <span>
#include <vector>

namespace gatun
{
/**
 * For each merge, whether it is wanted: if its error times the weight of its point is at most a
 * tolerance. Those with a weight of 0 always are. Merges that belong together are wanted if all of
 * them are.
 *
 * weights: for each point, 0 or more. tolerance: a negative one or one that is not a number counts
 * as 0. Throws InvalidInput if there is not a weight for each point.
 */
GATUN_EXPORT std::vector<bool> WantMerges(
  const MergeTree& tree, std::span<const float> weights, double tolerance);

/** Returns the smallest tolerance at which at least so many merges are wanted; all if there are not
 * so many. */
GATUN_EXPORT double FindTolerance(
  const MergeTree& tree, std::span<const float> weights, std::size_t merges);
}

#endif
