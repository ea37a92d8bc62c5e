// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyLattice_h
#define gatunHartleyLattice_h

// The points at which pictures of blocks are computed.

#include "gatunHartleyLayout.h"
#include "gatunHartleyView.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace gatun
{
/**
 * Pictures of blocks are made in *sheared* coordinates: a ray is known by where it crosses a plane
 * across the axis of the voxels that it follows most. There all blocks of a slab have their voxels
 * at the same places of one lattice, twice as fine as the voxels, so that they can be added point
 * by point, and what is constant stays exactly so. (P. Lacroute, M. Levoy: Fast volume rendering
 * using a shear-warp factorization of the viewing transformation, SIGGRAPH 1994, composite in such
 * coordinates.)
 */
struct HartleyLattice
{
  using Vector = HartleyView::Vector;

  static constexpr int PerVoxel = 2;
  static constexpr double Spacing = 1.0 / PerVoxel; ///< of lattice points, in voxels

  std::array<int, 3> Axes{ 0, 1, 2 }; ///< across the picture, down the picture, along the rays
  bool Backwards = false;             ///< rays go to lower indices along Axes[2]
  std::array<double, 2> Shear{};      ///< voxels across and down, per voxel along
  double SamplesPerVoxel = 1;         ///< for each voxel along Axes[2]

  std::array<double, 3> Block{};       ///< voxels of a block, along Axes
  std::array<std::size_t, 2> Points{}; ///< of a block's picture, odd; its middle is the block's

  /** For views whose Step is finite and not zero. */
  static HartleyLattice Make(const HartleyLayout::Triple& block, const HartleyView::Vector& step);

  std::size_t GetNumberOfPoints() const { return this->Points[0] * this->Points[1]; }

  /** Where the ray through a point, in index coordinates, crosses index 0 of Axes[2]. */
  std::array<double, 2> Project(const Vector& place) const
  {
    const double along = place[this->Axes[2]];
    return { place[this->Axes[0]] - this->Shear[0] * along,
      place[this->Axes[1]] - this->Shear[1] * along };
  }

  /** Of point i of a picture, relative to its middle, in voxels. */
  double GetPlace(int axis, std::size_t i) const
  {
    return (static_cast<double>(i) - static_cast<double>(this->Points[axis] / 2)) * Spacing;
  }

  bool operator==(const HartleyLattice&) const = default;
};
}

#endif
