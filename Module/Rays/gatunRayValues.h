// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunRayValues_h
#define gatunRayValues_h

#include "gatunExport.h"
#include "gatunTypes.h"

#include <cstddef>
#include <cstdint>

namespace gatun
{
class FileReader;

/** The values of a file that are drawn. */
struct RayValues
{
  std::uint32_t Array = 0; ///< index into FileReader::GetArrays()
  int Component = 0;       ///< -1: the Euclidean length of the tuple
  std::size_t Step = 0;
};

/** The values in the caller's memory that are drawn. */
struct RayValuesInput
{
  Association Where = Association::Point;
  ScalarType Type = ScalarType::Float32;
  std::uint32_t Components = 1;
  int Component = 0; ///< -1: the Euclidean length of the tuple
  const void* Values = nullptr;
};

/** Throws InvalidInput if a file has no such array, component or step. */
void CheckRayValues(const FileReader& file, const RayValues& values);

/** Returns the range of the values that are drawn, from the ranges that a file stores for an array;
 * component as in RayValues. For arrays with one component files store no range of the tuple's
 * length: the result then contains it. */
GATUN_EXPORT Range GetDrawnRange(const ArrayRanges& ranges, int component);
}

#endif
