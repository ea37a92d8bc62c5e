// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPointSet_h
#define gatunPointSet_h

// Convex point sets as polyhedra, so that the rule of gatunSimplices.h applies to them.

#include "gatunExport.h"
#include "gatunSimplices.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
constexpr std::uint8_t ConvexPointSetType = 41;

/**
 * Finds the faces of the convex hull of up to 64 points: for each one the positions of its corners,
 * counterclockwise if seen from outside. Points within a millionth of the extent from a plane, or
 * within the rounding of float coordinates, lie in it. There are no faces if all points lie in a
 * plane, if a coordinate is not finite, or if there are more points.
 */
GATUN_EXPORT std::vector<std::vector<std::uint8_t>> FindHullFaces(
  std::span<const std::array<double, 3>> places);

/** Replaces the faces by those of a convex point set. order: such as PointOrder. */
template <typename Id, typename Order>
void SetHullFaces(CellFaces<Id>& faces, std::span<const Id> corners, const Order& order)
{
  std::vector<std::array<double, 3>> places;
  for (const Id corner : corners)
  {
    places.push_back(order.GetPlace(corner));
  }
  faces.Clear();
  for (const auto& face : FindHullFaces(places))
  {
    faces.Add(face, [&](std::uint8_t at) { return corners[at]; });
  }
}
}

#endif
