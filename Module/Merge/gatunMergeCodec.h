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
/** The merges of a tree as a stream; only the first so many points may be merged. See
 * Documentation/format.md, 13.2. */
Bytes EncodeMerges(const MergeTree& tree, std::uint32_t points);

/** What EncodeMerges wrote, of a tree of so many points with so many merges. Throws if the merges
 * do not follow from each other. */
MergeTree DecodeMerges(
  std::span<const std::uint8_t> stream, std::uint32_t points, std::uint32_t merges);
}

#endif
