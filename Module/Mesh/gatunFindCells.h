// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunFindCells_h
#define gatunFindCells_h

#include "gatunExport.h"
#include "gatunMeshInput.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace gatun
{
/** The places of the cells and points of a mesh in another one. */
struct FoundCells
{
  std::vector<std::uint64_t> Cells;
  std::vector<std::uint64_t> Points; ///< if there are fewer
  bool DropsPoints = false;
  bool HaveMoved = false; ///< whether points are elsewhere

  RemainingCells GetRemaining() const { return { this->Cells, this->DropsPoints, this->Points }; }
};

/**
 * Finds a mesh in another one that has more cells. Its cells must be some of the cells of the other
 * one, in the same order and with the same order of corners. It has the same points, which may have
 * moved, or only the points that its cells use, in the same order and at the same places.
 *
 * Otherwise, and if there are polyhedra or fewer than half of the cells remain, returns nothing: a
 * file with the values of the deleted cells would be larger. Linear time.
 */
GATUN_EXPORT std::optional<FoundCells> FindCells(const MeshInput& mesh, const MeshInput& part);
}

#endif
