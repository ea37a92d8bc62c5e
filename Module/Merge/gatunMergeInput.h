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
/** How much a change of the fields counts in each tetrahedron. */
enum class MergeMetric : std::uint8_t
{
  Mass,   ///< as much as its volume is
  Density ///< the same in all, so more where tetrahedra are small
};

struct MergeSettings
{
  MergeMetric Metric = MergeMetric::Mass;

  /** How much of the cost of a merge on the boundary is its change of shape, 0 to 1; the rest is
   * that of the fields. */
  double BoundaryWeight = 0.5;
};

/** A mesh and what counts of it. */
struct MergeInput
{
  /** Values at the points that are to change little. */
  struct Field
  {
    std::span<const double> Values;
    double Weight = 1; ///< relative to those of the other fields
  };

  std::span<const std::array<double, 3>> Points;
  std::span<const MergeTree::Tet> Tets;
  std::vector<Field> Fields; ///< none: only shape counts
};
}

#endif
