// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunMergeRanks_h
#define gatunMergeRanks_h

#include "gatunLargeArray.h"
#include "gatunMergeTree.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gatun
{
/** Merges that do not depend on each other follow each other in groups. */
struct RankedMerges
{
  std::vector<Merge> Merges;
  std::vector<std::uint32_t> Order;  ///< when each merge was done, from 0
  std::vector<std::uint32_t> Groups; ///< the first merge of each group
};

/**
 * Ranks of merges: those of the same rank do not depend on each other. Two merges do if the point
 * of the later one is a corner of a cell of the earlier one's. Ranks ascend from window to window
 * of merges, so that the mesh after each window is the same in the order of the ranks.
 */
class MergeRanks
{
public:
  explicit MergeRanks(std::size_t points)
    : Next(points, 0)
  {
  }

  /** The rank of the next merge. change: of the mesh by this merge. */
  std::uint32_t Add(std::uint32_t point, double change)
  {
    if (this->Ranks.size() >= this->WindowEnd)
    {
      this->BeginWindow();
    }
    const auto rank = std::max(this->FirstRank, this->Next[point]);
    this->LastRank = std::max(this->LastRank, rank);
    this->Ranks.push_back(rank);
    this->Changes.push_back(change);
    return rank;
  }

  /** A point is a corner of a cell around the point of a merge. */
  void Touch(std::uint32_t point, std::uint32_t rank)
  {
    this->Next[point] = std::max(this->Next[point], rank + 1);
  }

  /** Sorts merges, which were added one after the other, by their ranks. Their errors are the roots
   * of the sums of the changes, divided by changePerError. */
  RankedMerges Arrange(const std::vector<Merge>& merges, double changePerError) const;

private:
  void BeginWindow();

  LargeArray<std::uint32_t> Next; // of a merge of each point, at least
  std::vector<std::uint32_t> Ranks;
  std::vector<double> Changes;
  std::size_t WindowEnd = 0;
  std::uint32_t FirstRank = 0; // of the window
  std::uint32_t LastRank = 0;
};
}

#endif
