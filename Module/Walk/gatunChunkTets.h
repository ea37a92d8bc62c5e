// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunChunkTets_h
#define gatunChunkTets_h

#include "gatunChunkCodec.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gatun
{
/** Tetrahedra of cells, and the cell of each. */
struct ChunkSize
{
  std::vector<std::array<Vertex, 4>> Tets;
  std::vector<std::uint32_t> Cells;
};

/** Splits the cells of a chunk of other cells than tetrahedra: see CellSplitter. */
ChunkSize SplitCells(const ChunkMesh& mesh);

/** How many tetrahedra SplitCells makes. */
std::size_t CountTets(const ChunkMesh& mesh);
}

#endif
