// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyRay_h
#define gatunHartleyRay_h

#include "gatunHartleyLattice.h"

#include <span>
#include <vector>

namespace gatun
{
/**
 * How much each voxel of a block counts in the integral along a ray: the integral of its trilinear
 * hat. Exact but for rounding: between planes of voxels it is that of a cubic polynomial.
 */
class HartleyRay
{
public:
  HartleyRay(const HartleyLayout::Triple& block, const HartleyLattice& lattice);

  /** Adds to the weights of the voxels (x fastest) for the ray at a place of the picture, relative
   * to its middle. */
  void AddWeights(double across, double down, std::span<double> weights);

private:
  void AddPoint(double across, double down, double along, double length, std::span<double> weights);

  HartleyLattice Lattice;
  std::array<std::ptrdiff_t, 3> Strides{}; // along Lattice.Axes
  std::vector<double> Breaks;
};
}

#endif
