// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunCutChooser_h
#define gatunCutChooser_h

#include "gatunExport.h"
#include "gatunMergeCut.h"
#include "gatunMergeDependencies.h"
#include "gatunMergeTree.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace gatun
{
/** How much of a mesh is to be left. */
struct CutLimits
{
  std::uint64_t Points = 0; ///< approximate limit of remaining points
  double PixelError = 0; ///< the largest weighted error; exceeded if too many points would be left
  std::size_t First = 0; ///< the number of first merges that are made in any case
};

/**
 * Chooses the merges that a view allows. A merge is wanted if its error, times the weight of its
 * point, is at most a tolerance: the one of the limits, or a larger one if too many points would be
 * left. A wanted merge is chosen if its dependencies are wanted, too, so that a closed surface
 * stays closed, and each cell is one that the mesh has after some number of merges.
 *
 * The result does not depend on earlier views. Immutable and thread safe.
 */
class GATUN_EXPORT CutChooser
{
public:
  /** Points: of the mesh before the merges. The tree may have more, which were merged before.
   * Throws InvalidInput if the dependencies are those of another number of merges. */
  CutChooser(std::shared_ptr<const MergeTree> tree,
    std::shared_ptr<const MergeDependencies> dependencies, std::uint64_t points);

  const MergeTree& GetTree() const { return *this->Tree; }

  /** Weights: for each point of the tree, the pixels of an error of 1. */
  MergeCut Choose(const std::vector<float>& weights, const CutLimits& limits) const;

private:
  MergeCut Do(const std::vector<float>& weights, double tolerance, std::size_t first) const;

  std::shared_ptr<const MergeTree> Tree;
  std::shared_ptr<const MergeDependencies> Dependencies;
  std::uint64_t Points;
};
}

#endif
