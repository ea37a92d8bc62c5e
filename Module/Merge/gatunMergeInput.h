// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunMergeInput_h
#define gatunMergeInput_h

#include "gatunMergeTree.h"

#include <array>
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
};

/** A mesh and the fields that simplification preserves. */
struct MergeInput
{
  /** A value for each point. */
  struct Field
  {
    std::span<const double> Values;
    double Weight = 1; ///< relative to those of the other fields
  };

  std::span<const std::array<double, 3>> Points;
  std::span<const MergeTree::Tet> Tets;
  std::vector<Field> Fields; ///< empty: only the shape counts

  /** For each point, whether it is kept, such as one that another mesh has, too. Others may be
   * merged into it. Empty: none. */
  std::span<const std::uint8_t> IsKept = {};
};
}

#endif
