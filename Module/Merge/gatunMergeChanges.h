// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunMergeChanges_h
#define gatunMergeChanges_h

#include "gatunExport.h"
#include "gatunMergeTree.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace gatun
{
/** Finds the points whose ancestors differ between two numbers of merges. Immutable and thread
 * safe. Memory: four bytes for each point and each merge. */
class GATUN_EXPORT MergeChanges
{
public:
  explicit MergeChanges(std::shared_ptr<const MergeTree> tree);

  const std::shared_ptr<const MergeTree>& GetTree() const { return this->Tree; }

  /** Returns the points in no order. Takes time and memory in proportion to their number. */
  std::vector<std::uint32_t> Find(std::size_t from, std::size_t to) const;

private:
  std::shared_ptr<const MergeTree> Tree;

  // The merges into each point, in order, as a list of lists.
  std::vector<std::uint32_t> First; // for each point, and the end
  std::vector<std::uint32_t> List;  // numbers of merges
};
}

#endif
