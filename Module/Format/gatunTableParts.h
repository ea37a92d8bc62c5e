// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunTableParts_h
#define gatunTableParts_h

// Common elements of tables. See Documentation/format.md, 2.6, 2.7 and 3.1.

#include "gatunContainer.h"
#include "gatunQuantizer.h"
#include "gatunScale.h"
#include "gatunTypes.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace gatun
{
// The expansion of smaller tables is not limited. In memory, a table takes up to 40 times its bytes
// (META, TABL, pages), or 3 times (STEP and others).
constexpr std::uint64_t SmallTable = 1u << 20;
constexpr std::uint64_t SmallStep = 16u << 20;

// The maximum ratio of a table to its compressed form, unless it is small, and of the tables of all
// time steps to the file.
constexpr std::uint64_t TableExpansion = 512;

/** Throws Error(Corrupt) unless right is true. */
inline void Check(bool right, const char* what)
{
  if (!right)
  {
    ThrowCorrupt(what);
  }
}

void PutStream(ByteWriter& out, const StreamRef& stream);
StreamRef GetStream(ByteReader& in);

/** The palette, scale or quantizer of a component, or the component of another array that it is
 * equal to. */
struct PaletteRef
{
  static constexpr std::uint32_t NoArray = 0xffffffffu;

  std::uint64_t Count = 0; // 0 if there is no palette
  StreamRef Stream;
  Scale Steps; // none if there is a palette
  std::uint32_t SourceArray = NoArray;
  std::uint32_t SourceComponent = 0;
  Quantizer Rounding; // none if values are exact

  bool IsCopy() const { return this->SourceArray != NoArray; }
  bool IsPlain() const
  {
    return this->Count == 0 && !this->Steps && !this->IsCopy() && !this->Rounding;
  }
};

void PutPalette(ByteWriter& out, const PaletteRef& palette);

/** type: that of the values. Whether there is an array to be copied is left to the caller. */
PaletteRef GetPalette(ByteReader& in, ScalarType type);

void PutRange(ByteWriter& out, const Range& range);
Range GetRange(ByteReader& in);

void PutStrings(ByteWriter& out, const std::vector<std::string>& strings);
std::vector<std::string> GetStrings(ByteReader& in);

/** A value type; throws if it is unknown. */
ScalarType GetScalarType(ByteReader& in);

/** Keys of an array: at least one. */
void PutKeys(ByteWriter& out, const std::vector<ArrayKey>& keys);
std::vector<ArrayKey> GetKeys(ByteReader& in);

/** The description of the points, as META has it. */
void PutPoints(ByteWriter& out, const PointsDescription& points);
PointsDescription GetPoints(ByteReader& in);

/** Descriptions of arrays, as META has them. */
void PutArrays(ByteWriter& out, std::span<const ArrayDescription> arrays);
std::vector<ArrayDescription> GetArrays(ByteReader& in);

/** Reads a varint below 2^32. */
std::uint32_t GetSmall(ByteReader& in);

/** Packs a table. Throws Error(InvalidInput) if Unpack would refuse it. */
Bytes Pack(const ByteWriter& out, std::uint64_t small);

/** Unpacks a table. Throws if it is larger than small and expands by more than TableExpansion. */
Bytes Unpack(std::span<const std::uint8_t> bytes, std::uint64_t small);
}

#endif
