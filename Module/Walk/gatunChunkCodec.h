// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunChunkCodec_h
#define gatunChunkCodec_h

// Encoding of the mesh of a chunk as a connectivity and a geometry stream.

#include "gatunChunkMesh.h"
#include "gatunCornerRotation.h"
#include "gatunTypes.h"

#include <array>
#include <cstdint>
#include <span>

namespace gatun
{
/**
 * Encodes a chunk. Shared vertices come first, in the order of the frame, then own vertices with
 * ownKeys. Every vertex must be used. The bytes depend only on the input. The fast profile is for
 * up to MaxFastVertices vertices; more have the small one.
 */
EncodedChunk EncodeChunk(const ChunkFrame& frame,
  std::span<const std::array<std::uint32_t, 4>> tets, std::span<const PointKeys> ownKeys,
  Profile profile = Profile::Small);

/** Decodes the streams of EncodeChunk. Safe on hostile input: throws Error(Corrupt). */
ChunkMesh DecodeChunk(const ChunkFrame& frame, std::span<const std::uint8_t> connectivity,
  std::span<const std::uint8_t> geometry);
}

#endif
