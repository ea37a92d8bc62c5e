// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunCellCodec_h
#define gatunCellCodec_h

// Encoding of chunks of cells of any VTK type.

#include "gatunBytes.h"
#include "gatunCellCorners.h"
#include "gatunCellList.h"
#include "gatunChunkCodec.h"
#include "gatunShapeTable.h"

#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** A stream has at least one byte for this number of corners and values of faces. This bounds the
 * memory that a short file can request, as MaxItemsPerByte does for cells. */
constexpr std::uint32_t MaxCornersPerByte = 16384;

/** The most corners and values of faces of a chunk; it has at most MaxChunkTets cells. */
constexpr std::uint32_t MaxChunkCorners = 1u << 24;

/**
 * Encodes a chunk of cells of any type and in any state. Vertices of the cells are shared ones
 * first, in the order of the frame, then own ones with ownKeys. Every vertex must be used by a
 * cell. Only polyhedra (VTK's type 42) have faces; FaceStarts is empty if there are none.
 *
 * The cells keep the order of their corners, except that tetrahedra and triangles may be turned by
 * an even permutation, and that the points, the faces and the first corner of each face of
 * polyhedra may come in another order. keepCorners: whether to encode these orders, too.
 *
 * shapes: of the file. The bytes depend only on the input. The fast profile is for up to
 * TetTree::MaxVertices vertices; more, and none, have the small one.
 */
EncodedCells EncodeCells(const ChunkFrame& frame, const CellList& cells, const ShapeTable& shapes,
  std::span<const PointKeys> ownKeys, bool keepCorners, Profile profile = Profile::Small);

/** Decodes the streams of EncodeCells. Safe on hostile input: throws Error(Corrupt). */
ChunkMesh DecodeCells(const ChunkFrame& frame, const ShapeTable& shapes,
  std::span<const std::uint8_t> connectivity, std::span<const std::uint8_t> geometry);
}

#endif
