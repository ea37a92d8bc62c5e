// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunDetailCuts_h
#define gatunDetailCuts_h

#include "gatunDetailView.h"
#include "gatunExport.h"
#include "gatunMergeCut.h"
#include "gatunMergeDependencies.h"
#include "gatunMergeTree.h"
#include "gatunRayBlock.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace gatun
{
/**
 * Chooses the merges that a view allows. A merge is wanted if its error, in pixels at its point, is
 * at most a tolerance: the one of the view, or a larger one if too many points would be left.
 * Outside of the view, and where no value is visible, all merges are wanted. A wanted merge is
 * chosen if its dependencies are wanted, too.
 *
 * The result does not depend on earlier views. Immutable.
 */
class GATUN_EXPORT DetailCuts
{
public:
  /** Where merges take place. */
  struct Place
  {
    RayPoint Point{};
    Range Values; ///< of the points around it; empty: its value
  };

  /**
   * Points: number of points of the mesh before the merges. The tree may have more, which were
   * merged before. Places: where the points of the tree are, approximately. placeOf: for each point
   * of the tree, one of these; or their number, if it is not known, for all of open, whose largest
   * weight counts. Size: of the mesh, in world units, above 0.
   */
  DetailCuts(std::shared_ptr<const MergeTree> tree,
    std::shared_ptr<const MergeDependencies> dependencies, std::uint64_t points,
    std::vector<Place> places, std::vector<std::uint32_t> placeOf, std::vector<std::uint32_t> open,
    double size);

  const MergeTree& GetTree() const { return *this->Tree; }

  /** Points: approximate limit of remaining points. */
  MergeCut Choose(const DetailView& view, std::uint64_t points) const;

  /** The largest weight of a place: pixels for an error of 1. */
  double GetLargestWeight(const DetailView& view) const;

private:
  std::vector<float> Weigh(const DetailView& view) const;
  MergeCut Do(const std::vector<float>& weights, double tolerance) const;

  std::shared_ptr<const MergeTree> Tree;
  std::shared_ptr<const MergeDependencies> Dependencies;
  std::uint64_t Points;
  std::vector<Place> Places;
  std::vector<std::uint32_t> PlaceOf;
  std::vector<std::uint32_t> Open;
  double Size;
};
}

#endif
