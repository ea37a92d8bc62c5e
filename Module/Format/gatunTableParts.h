// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunTableParts_h
#define gatunTableParts_h

// What all tables of a file are made of. See Documentation/format.md, 2.6, 2.7 and 3.1.

#include "gatunContainer.h"
#include "gatunTypes.h"

#include <cstdint>
#include <span>

namespace gatun
{
// Tables that are smaller may be any number of times as large as their compressed form. In memory
// a table takes up to some 40 times its bytes (META, TABL), or 3 times (STEP and the like).
constexpr std::uint64_t SmallTable = 1u << 20;
constexpr std::uint64_t SmallStep = 16u << 20;

// How much larger than its compressed form a table may be, unless it is small anyway; and how much
// larger than the file the tables of all its time steps may be.
constexpr std::uint64_t TableExpansion = 512;

/** Throws Error(Corrupt) unless this is right. */
inline void Check(bool right, const char* what)
{
  if (!right)
  {
    ThrowCorrupt(what);
  }
}

void PutStream(ByteWriter& out, const StreamRef& stream);
StreamRef GetStream(ByteReader& in);

void PutRange(ByteWriter& out, const Range& range);
Range GetRange(ByteReader& in);

/** A varint below 2^32. */
std::uint32_t GetSmall(ByteReader& in);

/** Packs a table; refuses what Unpack would refuse, as no file is better than one that cannot be
 * read. */
Bytes Pack(const ByteWriter& out, std::uint64_t small);

/** Unpacks a table, unless it is larger than small and much larger than its packed form. */
Bytes Unpack(std::span<const std::uint8_t> bytes, std::uint64_t small);
}

#endif
