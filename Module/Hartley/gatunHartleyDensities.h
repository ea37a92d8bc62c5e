// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyDensities_h
#define gatunHartleyDensities_h

#include "gatunHartleySource.h"
#include "gatunLargeArray.h"

#include <array>
#include <functional>
#include <span>
#include <vector>

namespace gatun
{
/** The voxels of a source minus its base, x fastest, in single precision. Parallel. Throws the
 * errors of the source, and Error(Aborted) if progress returns false. */
LargeArray<float> DecodeHartleyDensities(
  const HartleySource& source, const std::function<bool(double)>& progress = {});

/** The limit of the resolution of X-rays of a volume. */
struct HartleyDetail
{
  /** The mean of the outermost voxels. A box of this value has a closed form; its sharp border
   * would need the highest frequencies. */
  double Border = 0;

  /** The largest absolute sum of voxels along each axis. */
  std::array<double, 3> Largest{};

  /** The highest frequency that images along the axes need, in cycles per voxel, at most 0.5: the
   * mean square of higher ones is below a quarter of the error, which is relative to the largest
   * sum. */
  double Cut = 0.5;

  /** Subtracts the mean of the outermost voxels from all voxels and measures the rest. Parallel. */
  static HartleyDetail Take(
    const HartleyLayout::Triple& size, std::span<float> voxels, double meanSquareError);
};
}

#endif
