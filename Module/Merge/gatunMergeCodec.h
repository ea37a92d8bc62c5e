// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunMergeCodec_h
#define gatunMergeCodec_h

#include "gatunBytes.h"
#include "gatunMergeTree.h"

#include <cstdint>
#include <span>

namespace gatun
{
/** Encodes the merges of a tree; only the first points, as many as given, may be merged. See
 * Documentation/format.md, 13.2. */
Bytes EncodeMerges(const MergeTree& tree, std::uint32_t points);

/** Decodes a stream of EncodeMerges for a tree with the given numbers of points and merges. Throws
 * Error if the stream is damaged or the merges are inconsistent. */
MergeTree DecodeMerges(
  std::span<const std::uint8_t> stream, std::uint32_t points, std::uint32_t merges);
}

#endif
