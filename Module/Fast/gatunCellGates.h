// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunCellGates_h
#define gatunCellGates_h

// The choice of gates for new vertices.

#include "gatunCellTemplates.h"
#include "gatunCellTree.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace gatun
{
/** Finds the gate that predicts a vertex best, as a parallelogram or the middle of an edge, from
 * samples of it. */
class GateFinder
{
public:
  static constexpr std::size_t MaxSamples = 16;

  /** A place that the gate may use, by its name in the template. */
  struct Candidate
  {
    std::uint8_t Name = 0;
    std::vector<TreePlace> Places; ///< in each sample
  };

  /** places: of the vertex in each sample. */
  static std::optional<CellTemplate::Gate> Find(
    const std::vector<TreePlace>& places, const std::vector<Candidate>& candidates);
};
}

#endif
