// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnCellHash_h
#define gtnCellHash_h

#include "gtnGridView.h"
#include "gtnHash.h"

#include <cstddef>
#include <vector>

namespace gtn
{
/**
 * Adds the type and the points of a cell to a hash. points: a hash of each point of the grid.
 * Without keepCorners, tetrahedra and triangles that differ by an even permutation have the same
 * hash, and so have polyhedra whose points and faces are the same sets.
 */
Hash HashOfCell(const GridView& grid, std::size_t cell, const std::vector<Hash>& points,
  bool keepCorners, Hash seed);
}

#endif
