// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunRayDecoder_h
#define gatunRayDecoder_h

// Blocks from the chunks of a file.

#include "gatunRayBlock.h"
#include "gatunRayValues.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace gatun
{
class ChunkCache;

/** The share of a budget in bytes that is reserved for shared points, which are small and soon
 * needed again. */
inline std::uint64_t GetBudgetForParts(std::uint64_t budget)
{
  return std::min(budget / 4, std::uint64_t{ 16 } << 20);
}

/** Decodes a chunk of a file: its shared points, then its own. The block is not prepared yet. */
RayBlock DecodeRayBlock(
  const std::shared_ptr<ChunkCache>& parts, const RayValues& values, std::size_t chunk);
}

#endif
