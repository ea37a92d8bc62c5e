// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunCellTree_h
#define gatunCellTree_h

// Cells of any type whose corners are copied from earlier cells, as templates say. See
// Documentation/cell-codec.md, 10.

#include "gatunBytes.h"
#include "gatunCellList.h"
#include "gatunTetTree.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** The cells of a chunk. Vertices are numbered in the order of their first use. */
struct CellTree
{
  CellList Cells;
  std::vector<std::uint32_t> Parents; ///< the first source of each cell, or TetTree::NoTet
  std::vector<PackedTet> Gates;       ///< for each vertex, those from which it is predicted
  std::vector<std::uint32_t> Sources; ///< as in TetTree
};

struct CellTreeSize
{
  std::uint32_t Cells = 0;
  std::uint32_t Corners = 0;
  std::uint32_t FaceValues = 0;
  std::uint32_t Shared = 0;
  std::uint32_t Vertices = 0; ///< with the shared ones
};

struct EncodedCellTree
{
  Bytes Stream;
  std::vector<std::uint32_t> CellOrder; ///< of the input's cells
  std::vector<std::uint32_t> InputOf;   ///< the input's vertex of each one
  std::vector<std::uint32_t> OwnOrder;  ///< of the input's own vertices, from 0
};

/** Where a vertex is, for the choice of gates, in steps of which 2^24 are the size of the chunk. */
using TreePlace = std::array<std::int32_t, 3>;

/** Whether a chunk of cells can have this coder. */
constexpr bool FitsCellTree(std::size_t cells, std::size_t vertices)
{
  return cells > 0 && vertices > 0 && FitsTree(vertices);
}

/** Encodes cells. Vertices below shared are the shared ones; each is used. Cells keep the order of
 * their corners, but the points and faces of polyhedra may come in another order, and triangles may
 * begin with another corner unless keepCorners. */
EncodedCellTree EncodeCellTree(
  const CellList& cells, std::uint32_t shared, std::span<const TreePlace> places, bool keepCorners);

/** Decodes a stream of EncodeCellTree. Safe on hostile input: throws Error(Corrupt). */
CellTree DecodeCellTree(std::span<const std::uint8_t> stream, const CellTreeSize& size);
}

#endif
