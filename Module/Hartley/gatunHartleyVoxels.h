// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyVoxels_h
#define gatunHartleyVoxels_h

// Between the voxels of a volume and the values of a block, which are less by the base value.

#include "gatunHartleyInput.h"
#include "gatunHartleyLayout.h"
#include "gatunTypes.h"

#include <cmath>
#include <cstddef>
#include <functional>
#include <span>

namespace gatun
{
/** Integers beyond 2^53 are not all doubles. */
constexpr double LargestVoxelInteger = 9007199254740992.0;

/** Coefficients are in single precision where they are drawn, and larger than voxels. */
constexpr double LargestVoxelRange = 1e30;
constexpr double SmallestVoxelRange = 1e-30;

/** Smallest and largest voxel. Throws Error(InvalidInput) where a voxel is not finite, integers are
 * beyond what a double holds, or the range is beyond single precision. */
Range GetVoxelRange(const VolumeInput& input, const std::function<bool(double)>& progress = {});

/** The values of a block; those beyond the volume are 0. */
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

/** A value as a voxel: what is nearest in the range. The base of integers is one. */
inline double RoundVoxel(double value, double base, bool integer, const Range& range)
{
  // Half a unit is lost next to a large base.
  const double rounded = (integer ? std::floor(value + 0.5) : value) + base;
  // In this order NaN cannot pass.
  return rounded > range.Min ? (rounded < range.Max ? rounded : range.Max) : range.Min;
}

/** Writes what a box has of a block. */
void StoreBlock(std::span<const double> values, const HartleyLayout& layout,
  const HartleyLayout::Triple& place, double base, const Range& range, const VoxelBox& box);

/** Sums of errors of voxels. */
struct VoxelErrors
{
  double Squares = 0;
  double Largest = 0;

  void Add(const VoxelErrors& other);
};

/** How far a block's voxels are from those of the volume once they have been rounded. */
VoxelErrors CompareBlock(std::span<const double> values, const VolumeInput& input,
  const HartleyLayout& layout, const HartleyLayout::Triple& place, double base, const Range& range);
}

#endif
