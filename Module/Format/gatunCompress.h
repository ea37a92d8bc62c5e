// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunCompress_h
#define gatunCompress_h

#include "gatunBytes.h"

#include <cstdint>
#include <span>

namespace gatun
{
/** Compresses with zstd and puts the uncompressed length in front. */
Bytes Compress(std::span<const std::uint8_t> bytes);

/** Reverses Compress. Throws Error(Corrupt) for damaged data and for more than limit bytes. Safe on
 * hostile input: memory grows with the data that are actually there. */
Bytes Decompress(std::span<const std::uint8_t> bytes, std::uint64_t limit);
}

#endif
