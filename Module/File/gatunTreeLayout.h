// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunTreeLayout_h
#define gatunTreeLayout_h

#include "gatunMergeTree.h"
#include "gatunTables.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace gatun
{
/** A tree of merges in the numbers of a file, and where the points of its chunks get to. */
class TreeLayout
{
public:
  /** Ids: of each point of the file, which one of the given tree it is. */
  TreeLayout(const MergeTree& tree, std::vector<std::uint32_t> ids, const MeshTable& mesh);

  const MergeTree& GetTree() const { return this->Tree; }

  /** Numbers of merges that leave a half of the points, a quarter and so on, and all merges. */
  const std::vector<std::uint32_t>& GetRungs() const { return this->Rungs; }

  /**
   * Of each chunk, for each rung: the range of a value over all points that its own and shared ones
   * are merged into, themselves included, by any number of merges up to there. NaN is left out. The
   * value is that of a point of the given tree.
   */
  std::vector<std::vector<Range>> FindRanges(
    const std::function<double(std::uint32_t)>& getValue) const;

private:
  std::vector<Range> FindRanges(
    std::uint32_t merges, const std::function<double(std::uint32_t)>& getValue) const;

  std::vector<std::uint32_t> Ids;
  MergeTree Tree;
  std::vector<std::uint32_t> Rungs;

  /** The points of each chunk, from one up to before another one. */
  std::vector<std::vector<std::pair<std::uint64_t, std::uint64_t>>> Runs;
};
}

#endif
