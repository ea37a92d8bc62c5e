// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyVoxels_h
#define gatunHartleyVoxels_h

// Conversion between the voxels of a volume and the values of a block, which are voxels minus the
// base value.

#include "gatunHartleyInput.h"
#include "gatunHartleyLayout.h"
#include "gatunTypes.h"

#include <cmath>
#include <cstddef>
#include <functional>
#include <span>

namespace gatun
{
/** Doubles represent all integers up to 2^53. */
constexpr double LargestVoxelInteger = 9007199254740992.0;

/** Coefficients are drawn in single precision and can be larger than voxels. */
constexpr double LargestVoxelRange = 1e30;
constexpr double SmallestVoxelRange = 1e-30;

/** Smallest and largest voxel. Throws Error(InvalidInput) if a voxel is not finite, an integer is
 * larger than LargestVoxelInteger or the range is outside of single precision. */
Range GetVoxelRange(const VolumeInput& input, const std::function<bool(double)>& progress = {});

/** Loads the values of a block. Voxels outside of the volume are 0. */
void LoadBlock(const VolumeInput& input, const HartleyLayout& layout,
  const HartleyLayout::Triple& place, double base, std::span<double> values);

/** Part of a volume, in the caller's memory. */
struct VoxelBox
{
  HartleyLayout::Triple First{};
  HartleyLayout::Triple End{};
  ScalarType Type = ScalarType::UInt8;
  void* Values = nullptr; ///< x fastest
};

/** Converts a value to the nearest voxel in the range. The base of integers is an integer. */
inline double RoundVoxel(double value, double base, bool integer, const Range& range)
{
  // Rounds before adding the base: next to a large base the fraction would be lost.
  const double rounded = (integer ? std::floor(value + 0.5) : value) + base;
  // The order of the comparisons excludes NaN.
  return rounded > range.Min ? (rounded < range.Max ? rounded : range.Max) : range.Min;
}

/** Writes the part of a block that is inside a box. */
void StoreBlock(std::span<const double> values, const HartleyLayout& layout,
  const HartleyLayout::Triple& place, double base, const Range& range, const VoxelBox& box);

/** Accumulated errors of voxels. */
struct VoxelErrors
{
  double Squares = 0;
  double Largest = 0;

  void Add(const VoxelErrors& other);
};

/** The errors of a block's voxels after rounding. */
VoxelErrors CompareBlock(std::span<const double> values, const VolumeInput& input,
  const HartleyLayout& layout, const HartleyLayout::Triple& place, double base, const Range& range);
}

#endif
