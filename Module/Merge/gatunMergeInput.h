// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunMergeInput_h
#define gatunMergeInput_h

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** The weight of a tetrahedron for changes of the fields. */
enum class MergeMetric : std::uint8_t
{
  Mass,   ///< its volume
  Density ///< the same for all, so that regions of small tetrahedra count more
};

struct MergeSettings
{
  MergeMetric Metric = MergeMetric::Mass;

  /** Weight of the change of shape in the cost of a merge on the boundary, 0 to 1. The change of
   * the fields has the rest. */
  double BoundaryWeight = 0.5;

  /**
   * Fraction of the cheapest possible merges that are made before the points around them may be
   * merged, 0 to 1. With 0, any of these points may be the next. With a larger fraction, merges
   * depend on fewer others, so that a mesh with fine and coarse places (MergeCut) has fewer
   * tetrahedra; but their order is less exact, and errors are larger.
   */
  double PartAtOnce = 0;
};

struct SurfaceMergeSettings
{
  /** Weight of the change of shape in the cost of a merge, 0 to 1. The change of the fields has the
   * rest. */
  double ShapeWeight = 0.5;

  /** Angle between the normals of two triangles, in degrees, 0 to 180. Edges with a larger angle
   * are kept like the border. */
  double FeatureAngle = 30;

  /** Whether points of the border are never merged. */
  bool KeepBorder = false;
};

/** A mesh and the fields that simplification preserves. Cells are triangles or tetrahedra. */
template <std::size_t Corners>
struct BasicMergeInput
{
  /** A value for each point. */
  struct Field
  {
    std::span<const double> Values;
    double Weight = 1; ///< relative to those of the other fields
  };

  std::span<const std::array<double, 3>> Points;
  std::span<const std::array<std::uint32_t, Corners>> Cells;
  std::vector<Field> Fields; ///< empty: only the shape counts

  /** For each point, whether it is kept, such as a point shared with another mesh. Others may be
   * merged into it. Empty: none. */
  std::span<const std::uint8_t> IsKept = {};
};

using MergeInput = BasicMergeInput<4>;
using SurfaceMergeInput = BasicMergeInput<3>;
}

#endif
