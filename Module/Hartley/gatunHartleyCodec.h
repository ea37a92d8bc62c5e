// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyCodec_h
#define gatunHartleyCodec_h

// Quantised coefficients as streams of bytes. Specified in Documentation/ghv-format.md.

#include "gatunBytes.h"
#include "gatunHartleyLayout.h"
#include "gatunHartleyOrder.h"

#include <cstdint>
#include <span>

namespace gatun
{
/** Coefficients of no more than this, so that sums of a few do not overflow. */
constexpr std::int64_t LargestHartleyInteger = std::int64_t{ 1 } << 62;

/**
 * The blocks of a chunk in one stream. Integers are those of the blocks one after the other, each
 * by index; grid tells how many blocks there are along each axis.
 */
Bytes EncodeHartleyBlocks(const HartleyOrder& order, const HartleyLayout::Triple& grid,
  std::span<const std::int64_t> integers);

/** Integers must be 0 before. Throws Error(Corrupt) for streams that nobody wrote. */
void DecodeHartleyBlocks(const HartleyOrder& order, const HartleyLayout::Triple& grid,
  std::span<const std::uint8_t> stream, std::span<std::int64_t> integers);

/** What a segment has at least, behind its stream zeros if need be, so that a short file cannot
 * claim a large block. */
std::size_t GetLeastHartleySegmentBytes(std::size_t blockLength, std::size_t segment);

/** One segment of a block, which has several: positions of the order from segment *
 * HartleyOrder::SegmentLength on. Segments may be coded at the same time. */
Bytes EncodeHartleySegment(
  const HartleyOrder& order, std::size_t segment, std::span<const std::int64_t> integers);
void DecodeHartleySegment(const HartleyOrder& order, std::size_t segment,
  std::span<const std::uint8_t> stream, std::span<std::int64_t> integers);
}

#endif
