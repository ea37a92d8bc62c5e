// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunMergeCodec_h
#define gatunMergeCodec_h

#include "gatunBytes.h"
#include "gatunMergeTree.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** The kind of mesh that merges are for. */
enum class MergeKind : std::uint8_t
{
  Tetrahedra, ///< merges are independent
  Surface     ///< some merges belong together, which is coded
};

/** Encodes the first merges of a tree, as many as given; only the first points, as many as given,
 * may be merged. Runs of merges whose points ascend take the least room (SortRounds). See
 * Documentation/format.md, 13.3. */
Bytes EncodeMerges(const MergeTree& tree, std::uint32_t points, std::size_t merges, MergeKind kind);

/** Decodes a stream of EncodeMerges for a tree with the given numbers of points and merges. Throws
 * Error if the stream is damaged or the merges are inconsistent. */
MergeTree DecodeMerges(
  std::span<const std::uint8_t> stream, std::uint32_t points, std::uint32_t merges, MergeKind kind);

/** Encodes other numbers of some points, which are the numbers from 0 on in any order. */
Bytes EncodePointMap(std::span<const std::uint32_t> numbers);

/** Decodes a stream of EncodePointMap of so many points. Throws Error if it is damaged. */
std::vector<std::uint32_t> DecodePointMap(
  std::span<const std::uint8_t> stream, std::uint32_t points);

/** Puts merges before those of a tree, which is about the points that they leave. map: the numbers
 * there of these points, in ascending order of their own numbers. Throws Error if they do not fit
 * together. */
MergeTree JoinMerges(
  const MergeTree& first, const MergeTree& rest, std::span<const std::uint32_t> map);
}

#endif
