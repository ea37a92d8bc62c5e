// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunTreeChunk_h
#define gatunTreeChunk_h

// Chunks of tetrahedra in the fast profile.

#include "gatunChunkMesh.h"

#include <array>
#include <cstdint>
#include <span>

namespace gatun
{
/** As EncodeChunk and DecodeChunk, without the first byte of the connectivity stream. */
EncodedChunk EncodeTreeChunk(const ChunkFrame& frame,
  std::span<const std::array<std::uint32_t, 4>> tets, std::span<const PointKeys> ownKeys);
ChunkMesh DecodeTreeChunk(const ChunkFrame& frame, std::span<const std::uint8_t> connectivity,
  std::span<const std::uint8_t> geometry);
}

#endif
