// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunCellTreeChunk_h
#define gatunCellTreeChunk_h

// Chunks of cells of any type in the fast profile.

#include "gatunCellList.h"
#include "gatunChunkMesh.h"

#include <cstdint>
#include <span>

namespace gatun
{
/** As EncodeCells and DecodeCells, without the first byte of the connectivity stream. */
EncodedCells EncodeCellTreeChunk(const ChunkFrame& frame, const CellList& cells,
  std::span<const PointKeys> ownKeys, bool keepCorners);
ChunkMesh DecodeCellTreeChunk(const ChunkFrame& frame, std::span<const std::uint8_t> connectivity,
  std::span<const std::uint8_t> geometry);
}

#endif
