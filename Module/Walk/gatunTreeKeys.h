// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunTreeKeys_h
#define gatunTreeKeys_h

// The geometry stream of a chunk with gates. See Documentation/format.md, 9.5.

#include "gatunBytes.h"
#include "gatunChunkMesh.h"

#include <cstdint>
#include <span>

namespace gatun
{
/** Encodes the keys of a mesh. */
Bytes EncodeTreeKeys(const ChunkMesh& mesh);

/** Finds the keys of a mesh that has all but these. Safe on hostile input: throws Error(Corrupt).
 */
void DecodeTreeKeys(
  const ChunkFrame& frame, std::span<const std::uint8_t> geometry, ChunkMesh& mesh);
}

#endif
