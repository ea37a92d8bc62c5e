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
 * The weight of each voxel of a block in the integral along a ray, that is, the integral of its
 * trilinear basis function. Exact except for rounding: between planes of voxels the integrand is a
 * cubic polynomial.
 */
class HartleyRay
{
public:
  HartleyRay(const HartleyLayout::Triple& block, const HartleyLattice& lattice);

  /** Adds the weights of the voxels (x fastest) for the ray at a position relative to the middle of
   * the block's image. */
  void AddWeights(double across, double down, std::span<double> weights);

private:
  void AddPoint(double across, double down, double along, double length, std::span<double> weights);

  HartleyLattice Lattice;
  std::array<std::ptrdiff_t, 3> Strides{}; // along Lattice.Axes
  std::vector<double> Breaks;
};
}

#endif
