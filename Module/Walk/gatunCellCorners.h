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
 * Encodes the permutations that turn the corners of cells into the wanted ones. Vertices must have
 * the same numbers in both lists; order maps one list to the other.
 */
Bytes EncodeCorners(const CellList& cells, const CellList& wanted,
  std::span<const std::uint32_t> order, std::span<const std::uint32_t> inputOf);

/** Restores the corners by the result of EncodeCorners. Safe on hostile input: throws
 * Error(Corrupt). */
void RestoreCorners(CellList& cells, std::span<const std::uint8_t> corners);
}

#endif
