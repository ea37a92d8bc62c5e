// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunMergeTriangles_h
#define gatunMergeTriangles_h

#include "gatunLargeArray.h"
#include "gatunMergeInput.h"
#include "gatunMergeRings.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** The sequence of points of each place, and the triangles over places. */
struct MergePlaces
{
  using Cell = MergeRings<3>::Cell;

  /** Points at the same place must follow each other. Points that are not finite or have no
   * triangle are places of their own. */
  explicit MergePlaces(const SurfaceMergeInput& input);

  std::vector<std::uint32_t> First; ///< the first point of each place, and the number of points
  std::vector<Cell> Cells;          ///< over places
};

/**
 * The connectivity of a triangle mesh while its points are merged.
 *
 * Points with the same coordinates, such as the two sides of a seam of texture coordinates, form a
 * *place*. The base class has the rings and cells of places: a seam is no border, and its points
 * are merged together, so that it stays closed. An edge with only one triangle is a border.
 */
class MergeTriangles : public MergeRings<3>
{
public:
  explicit MergeTriangles(const SurfaceMergeInput& input, bool keepBorder = false);

  std::size_t GetNumberOfPlaces() const { return this->GetNumberOfPoints(); }

  /** Whether any place has more than one point. */
  bool HasSeams() const { return this->Seams; }

  /** Returns the first point of a place, and of the one after the last place. */
  std::uint32_t GetFirstPoint(std::uint32_t place) const
  {
    return this->Seams ? this->Places.First[place] : place;
  }
  std::uint32_t CountPoints(std::uint32_t place) const
  {
    return this->GetFirstPoint(place + 1) - this->GetFirstPoint(place);
  }

  /** Returns the point at a corner of a triangle. */
  std::uint32_t GetPoint(std::uint32_t cell, unsigned corner) const
  {
    return this->Seams ? this->Corners[cell][corner] : this->GetCell(cell)[corner];
  }

  /** Whether a place is to be kept: the triangles around it are not one fan, or a point of it is
   * marked. Others may be merged into it. */
  std::span<const std::uint8_t> GetIsKept() const { return this->IsKept; }

  /** Whether the triangles around a place are one fan, as they are on a surface. It may be open. */
  bool IsRegular(std::uint32_t place) const { return this->IsKept[place] != Irregular; }

  /** A point that has been merged into another one. */
  using Pair = std::array<std::uint32_t, 2>;

  /** Merges a place into a neighbor. Returns which points have been merged. Each point of the place
   * that has a triangle must share triangles with just one of the neighbor. */
  std::span<const Pair> Merge(std::uint32_t place, std::uint32_t into);

private:
  enum Keep : std::uint8_t
  {
    Free,
    Marked,
    Irregular
  };

  MergeTriangles(const SurfaceMergeInput& input, MergePlaces&& places, bool keepBorder);
  void FindKept(bool keepBorder);

  enum class Fan : std::uint8_t
  {
    None,
    Open,
    Closed
  };
  Fan FindFan(std::uint32_t place) const;

  MergePlaces Places;
  bool Seams;
  LargeArray<Cell> Corners; // points of each cell, if there are seams
  std::vector<std::uint8_t> IsKept;
  std::vector<Pair> Pairs;
};
}

#endif
