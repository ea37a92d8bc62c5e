// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunMergeDependencies_h
#define gatunMergeDependencies_h

#include "gatunExport.h"
#include "gatunMergeTree.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace gatun
{
/**
 * Dependencies between the merges of a tree, so that merges can be done where a mesh may be coarse,
 * and not where it must be fine.
 *
 * A merge depends on the merges that last changed each of the tetrahedra around its point before
 * it. It also depends on a merge that took a tetrahedron away and so made a face of one of these a
 * part of the boundary. If a set contains the dependencies of all its merges, each remaining
 * tetrahedron is one that the mesh has after some number of merges, and they cover each place once.
 * The rule is that of multi-tessellations (De Floriani, Magillo, Puppo: "Efficient implementation
 * of multi-triangulations", IEEE Visualization 1998).
 *
 * Merges that belong together (MergeTree::GetBonds) depend on the same ones. If all of them are
 * wanted, they are done together or not at all.
 *
 * Immutable. Memory: about 22 bytes a merge.
 */
class GATUN_EXPORT MergeDependencies
{
public:
  static constexpr std::uint32_t MergesBetweenProgress = 4096;

  MergeDependencies() = default;

  /**
   * Finds the dependencies by doing all merges one after the other: 0.5 us a tetrahedron. Cells:
   * all tetrahedra of the mesh; degenerate ones do not count.
   *
   * progress: called with the fraction done, from 0 to 1. Error(Aborted) is thrown if it returns
   * false. Throws InvalidInput if a corner is not a point of the tree.
   */
  MergeDependencies(const MergeTree& tree, std::span<const std::array<std::uint32_t, 4>> cells,
    const std::function<bool(double)>& progress = {});

  /** The same for triangles, whose borders take the place of the boundary. */
  MergeDependencies(const MergeTree& tree, std::span<const std::array<std::uint32_t, 3>> cells,
    const std::function<bool(double)>& progress = {});

  /** Adds the next merge of the tree with the earlier ones that it depends on, ascending. */
  void Add(std::span<const std::uint32_t> earlier)
  {
    this->Earlier.insert(this->Earlier.end(), earlier.begin(), earlier.end());
    this->First.push_back(this->Earlier.size());
  }

  std::size_t GetNumberOfMerges() const { return this->First.size() - 1; }

  /** The numbers of the earlier merges that a merge depends on directly, ascending. */
  std::span<const std::uint32_t> Get(std::size_t merge) const
  {
    return { this->Earlier.data() + this->First[merge],
      this->First[merge + 1] - this->First[merge] };
  }

private:
  template <std::size_t Corners>
  void Replay(const MergeTree& tree, std::span<const std::array<std::uint32_t, Corners>> cells,
    const std::function<bool(double)>& progress);

  void AddTogether(std::span<const std::uint32_t> merges, std::vector<std::uint32_t>& earlier);

  std::vector<std::size_t> First{ 0 };
  std::vector<std::uint32_t> Earlier;
};
}

#endif
