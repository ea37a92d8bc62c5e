// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunMergeSelection_h
#define gatunMergeSelection_h

#include "gatunExport.h"
#include "gatunMergeTree.h"

#include <cstddef>
#include <span>
#include <vector>

namespace gatun
{
/**
 * Selects merges whose weighted error, error times the weight of the point, is at most the
 * tolerance. Zero weight always selects. Merges that belong together are selected together.
 *
 * weights: for each point, 0 or more. tolerance: negative values and NaN count as 0. Throws
 * InvalidInput if there is not a weight for each point.
 */
GATUN_EXPORT std::vector<bool> SelectMerges(
  const MergeTree& tree, std::span<const float> weights, double tolerance);

/** Returns the smallest tolerance that selects at least this number of merges, or all. */
GATUN_EXPORT double FindTolerance(
  const MergeTree& tree, std::span<const float> weights, std::size_t merges);
}

#endif
