// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunMergeCut_h
#define gatunMergeCut_h

#include "gatunExport.h"
#include "gatunMergeDependencies.h"
#include "gatunMergeTree.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gatun
{
/**
 * Some merges of a tree, and the ancestor of each point by them. The mesh of a cut has the points
 * that are their own ancestors, and the tetrahedra whose corners have four different ones.
 *
 * Uniform cuts have the first merges of the tree. Others have merges where the mesh may be coarse.
 * Immutable. Memory: 4 bytes a point, and a bit a merge.
 */
class GATUN_EXPORT MergeCut
{
public:
  /** The first merges of a tree; all of them if there are fewer. */
  MergeCut(const MergeTree& tree, std::size_t merges);

  /**
   * The largest set of wanted merges that can be done together: the merges whose dependencies are
   * all wanted. There is just one such set. It does not depend on earlier cuts.
   *
   * wanted: for each merge. Throws InvalidInput if the sizes differ.
   */
  MergeCut(const MergeTree& tree, const MergeDependencies& dependencies, std::vector<bool> wanted);

  /** Merges that can be done together, such as the merges of another cut that remain for a base
   * mesh. Throws InvalidInput if their number is not that of the tree. */
  MergeCut(const MergeTree& tree, std::vector<bool> done);

  /** The ancestor of each point. */
  const std::vector<std::uint32_t>& GetAncestors() const { return this->Ancestors; }

  /** For each merge, whether it is done. */
  const std::vector<bool>& GetDone() const { return this->Done; }

  std::size_t GetNumberOfMerges() const { return this->Number; }

  /** The number of first merges of the tree that have all merges of the cut. Boxes and ranges up to
   * this number of merges enclose the cut. */
  std::size_t GetLast() const { return this->Last; }

  bool IsUniform() const { return this->Number == this->Last; }

private:
  void FindAncestors(const MergeTree& tree);

  std::vector<bool> Done;
  std::vector<std::uint32_t> Ancestors;
  std::size_t Number = 0;
  std::size_t Last = 0;
};
}

#endif
