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
/** The kind of mesh that merges are for. */
enum class MergeKind : std::uint8_t
{
  Tetrahedra, ///< merges are independent
  Surface     ///< some merges belong together, which is coded
};

/** Encodes the merges of a tree; only the first points, as many as given, may be merged. See
 * Documentation/format.md, 13.3. */
Bytes EncodeMerges(
  const MergeTree& tree, std::uint32_t points, MergeKind kind = MergeKind::Tetrahedra);

/** Decodes a stream of EncodeMerges for a tree with the given numbers of points and merges. Throws
 * Error if the stream is damaged or the merges are inconsistent. */
MergeTree DecodeMerges(std::span<const std::uint8_t> stream, std::uint32_t points,
  std::uint32_t merges, MergeKind kind = MergeKind::Tetrahedra);
}

#endif
