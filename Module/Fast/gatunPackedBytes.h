// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPackedBytes_h
#define gatunPackedBytes_h

// Symbols of a byte each, which zstd packs nearly only by their frequencies.

#include "gatunBytes.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace gatun
{
/** Appends symbols, packed where that is shorter. */
void PutPacked(ByteWriter& out, std::span<const std::uint8_t> symbols);

/** Reads as many symbols as the target has room for. Safe on hostile input: throws
 * Error(Corrupt). */
void GetPacked(ByteReader& in, std::span<std::uint8_t> symbols);
}

#endif
