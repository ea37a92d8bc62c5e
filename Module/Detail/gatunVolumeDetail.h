// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunVolumeDetail_h
#define gatunVolumeDetail_h

#include "gatunCutChooser.h"
#include "gatunDetailView.h"
#include "gatunRayBlock.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/**
 * Chooses the merges of a volume that a view allows: those whose error in pixels is small enough,
 * and all of them outside of the view and where no value is visible. Immutable.
 */
class VolumeDetail
{
public:
  /** Where merges take place. */
  struct Place
  {
    RayPoint Point{};
    Range Values; ///< of the points around it; empty: its value
  };

  /**
   * Places: where the points of the tree are, approximately. placeOf: for each point of the tree,
   * one of these; or their number, if it is not known, for all of open, whose largest weight
   * counts. Size: of the mesh, in world units.
   */
  VolumeDetail(CutChooser chooser, std::vector<Place> places, std::vector<std::uint32_t> placeOf,
    std::vector<std::uint32_t> open, double size);

  const MergeTree& GetTree() const { return this->Chooser.GetTree(); }

  /** Points: approximate limit of remaining points. */
  MergeCut Choose(const DetailView& view, std::uint64_t points) const;

private:
  CutChooser Chooser;
  std::vector<Place> Places;
  std::vector<std::uint32_t> PlaceOf;
  std::vector<std::uint32_t> Open;
  double Size;
};

/** Adds the values of a block's tetrahedra to the places of their corners. toPlace(corner): null if
 * the corner has none. */
template <typename ToPlace>
void IncludeValues(std::span<const RayBlock::Tet> tets, std::span<const RayPoint> points,
  std::span<const double> cellValues, const ToPlace& toPlace)
{
  for (std::size_t i = 0; i < tets.size(); ++i)
  {
    Range values;
    for (const auto corner : tets[i])
    {
      values.Include(cellValues.empty() ? points[corner].Value : cellValues[i]);
    }
    for (const auto corner : tets[i])
    {
      if (VolumeDetail::Place* const place = toPlace(corner))
      {
        place->Values.Include(values);
      }
    }
  }
}
}

#endif
