// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunTreeLayout_h
#define gatunTreeLayout_h

#include "gatunMergeTree.h"
#include "gatunMeshTable.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace gatun
{
/** A merge tree in the numbers of a file, and the ranges of its chunks after merges. */
class TreeLayout
{
public:
  /** The value of a point of the file. */
  using GetValue = std::function<double(std::uint32_t)>;

  TreeLayout(MergeTree tree, const MeshTable& mesh);

  const MergeTree& GetTree() const { return this->Tree; }

  /** The numbers of merges that leave half of the points, a quarter and so on, and all merges. */
  const std::vector<std::uint32_t>& GetMergeCounts() const { return this->MergeCounts; }

  /**
   * For each chunk and merge count, the range of a value over the chunk's points and all points
   * that they are merged into by any number of merges up to the merge count. NaN is ignored. Takes
   * 16 bytes a point in each thread.
   */
  std::vector<std::vector<Range>> FindRanges(const GetValue& getValue) const;

private:
  std::vector<Range> FindRanges(std::uint32_t merges, const GetValue& getValue) const;

  MergeTree Tree;
  std::vector<std::uint32_t> MergeCounts;

  /** The points of each chunk as half-open intervals. */
  std::vector<std::vector<std::pair<std::uint64_t, std::uint64_t>>> Runs;
};
}

#endif
