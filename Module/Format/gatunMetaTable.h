// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunMetaTable_h
#define gatunMetaTable_h

// The META section and field data. See Documentation/format.md, 3.2 and 3.5.

#include "gatunBytes.h"
#include "gatunFieldData.h"
#include "gatunTypes.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace gatun
{
struct MetaTable
{
  std::string WriterVersion;
  std::uint64_t Points = 0;
  std::uint64_t Tets = 0;
  std::uint64_t UnusedPoints = 0;
  ScalarType CoordinateType = ScalarType::Float32;
  bool WideIds = true;
  bool HasTime = false;
  bool PointsMove = false;
  std::uint8_t Keep = KeepNone;
  Profile Coding = Profile::Small; ///< for information: streams tell how they are coded
  std::uint32_t ChunkSize = 0;
  std::uint32_t KeyStepInterval = 1;
  Bounds Box;
  PointsDescription PointArray;

  /** The arrays of the file. If the points move, one more comes last, their coordinates: tables of
   * time steps have it like the others, but the file does not list it. */
  std::vector<ArrayDescription> Arrays;

  /** The number of arrays that the file lists. */
  std::size_t GetListedArrays() const { return this->Arrays.size() - (this->PointsMove ? 1 : 0); }

  /** Whether an array is the coordinates of points that move. */
  bool IsPoints(std::size_t array) const
  {
    return this->PointsMove && array + 1 == this->Arrays.size();
  }

  Bytes Write() const;
  static MetaTable Read(std::span<const std::uint8_t> bytes);
};

/** Coordinates of points that move, as an array. */
ArrayDescription DescribePoints(ScalarType type);

/** The type of the original numbers for a number of points or cells. */
constexpr ScalarType GetNumberType(std::uint64_t count)
{
  return count < std::uint64_t{ 1 } << 32 ? ScalarType::UInt32 : ScalarType::UInt64;
}

Bytes WriteFieldData(const FieldData& field);
FieldData ReadFieldData(std::span<const std::uint8_t> bytes);
}

#endif
