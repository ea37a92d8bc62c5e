// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunRayValues_h
#define gatunRayValues_h

#include "gatunRayBlock.h"
#include "gatunTypes.h"
#include "vtkGatunCoreModule.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace gatun
{
class FileReader;

/** The values of a file that determine colors, if not those that are drawn do. */
struct RayHueValues
{
  std::uint32_t Array = 0; ///< as in RayValues
  int Component = 0;       ///< with 1 channel
  unsigned Channels = 0;   ///< 0 for none, 1, or 3 for the first three components
};

/** The values of a file that are drawn. */
struct RayValues
{
  std::uint32_t Array = 0; ///< index into FileReader::GetArrays()
  int Component = 0;       ///< -1: the Euclidean length of the tuple
  std::size_t Step = 0;
  RayHueValues Hues = {};
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

/** The same for colors; see RayHueValues. */
struct RayHuesInput
{
  RayValuesInput Values;
  unsigned Channels = 0;
};

/** Sets hues to those of some tuples. Of three channels, integers are divided by 255. */
void TakeHues(const RayHuesInput& input, std::span<const std::uint32_t> tuples, RayHues& hues);

/** Throws InvalidInput if a file has no such array, component or step. */
void CheckRayValues(const FileReader& file, const RayValues& values);

/** Returns the range of the values that are drawn, from the ranges that a file stores for an array;
 * component as in RayValues. For arrays with one component files store no range of the tuple's
 * length: the result then contains it. */
VTKGATUNCORE_EXPORT Range GetDrawnRange(const ArrayRanges& ranges, int component);
}

#endif
