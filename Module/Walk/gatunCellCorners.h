// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunCellCorners_h
#define gatunCellCorners_h

// The order of corners where a chunk does not keep it: tetrahedra, and points and faces of
// polyhedra.

#include "gatunBytes.h"
#include "gatunCellList.h"

#include <cstdint>
#include <span>

namespace gatun
{
/**
 * Encodes how the corners of cells are turned into those that are wanted. All vertices of wanted
 * must have the numbers that they have in cells, and order leads from one list to the other.
 */
Bytes EncodeCorners(const CellList& cells, const CellList& wanted,
  std::span<const std::uint32_t> order, std::span<const std::uint32_t> inputOf);

/** Restores the corners by the result of EncodeCorners. Safe on hostile input: throws
 * Error(Corrupt). */
void RestoreCorners(CellList& cells, std::span<const std::uint8_t> corners);
}

#endif
