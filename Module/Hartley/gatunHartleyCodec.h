// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyCodec_h
#define gatunHartleyCodec_h

// Entropy coding of quantized coefficients. Specified in Documentation/ghv-format.md.

#include "gatunBytes.h"
#include "gatunHartleyLayout.h"
#include "gatunHartleyOrder.h"

#include <cstdint>
#include <span>

namespace gatun
{
/** Upper bound of the coefficients' absolute values, so that sums of several do not overflow. */
constexpr std::int64_t LargestHartleyInteger = std::int64_t{ 1 } << 62;

/**
 * Encodes the blocks of a chunk as one stream. Integers: block by block, each by index; grid:
 * number of blocks along each axis.
 */
Bytes EncodeHartleyBlocks(const HartleyOrder& order, const HartleyLayout::Triple& grid,
  std::span<const std::int64_t> integers);

/** Integers must be 0 initially. Safe on hostile input: throws Error(Corrupt) for invalid streams.
 */
void DecodeHartleyBlocks(const HartleyOrder& order, const HartleyLayout::Triple& grid,
  std::span<const std::uint8_t> stream, std::span<std::int64_t> integers);

/** The minimum length of a segment. Shorter streams are padded with zeros, so that a short file
 * cannot claim a large block. */
std::size_t GetLeastHartleySegmentBytes(std::size_t blockLength, std::size_t segment);

/** Encodes and decodes one segment of a long block: HartleyOrder::SegmentLength positions of the
 * order, the first of which is segment * SegmentLength. Segments may be coded in parallel. */
Bytes EncodeHartleySegment(
  const HartleyOrder& order, std::size_t segment, std::span<const std::int64_t> integers);
void DecodeHartleySegment(const HartleyOrder& order, std::size_t segment,
  std::span<const std::uint8_t> stream, std::span<std::int64_t> integers);
}

#endif
