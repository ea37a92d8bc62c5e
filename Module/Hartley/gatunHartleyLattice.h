// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyLattice_h
#define gatunHartleyLattice_h

// The points at which the images of blocks are computed.

#include "gatunHartleyLayout.h"
#include "gatunHartleyView.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace gatun
{
/**
 * The images of blocks are computed in *sheared* coordinates: a ray is identified by its
 * intersection with a plane orthogonal to the volume axis that is closest to the rays' direction.
 * In this plane, the voxels of all blocks of a slab lie on one lattice with twice the resolution of
 * the voxels. Blocks can therefore be added point by point, and constant regions remain exactly
 * constant. (P. Lacroute, M. Levoy: Fast volume rendering using a shear-warp factorization of the
 * viewing transformation, SIGGRAPH 1994, composite in such coordinates.)
 */
struct HartleyLattice
{
  using Vector = HartleyView::Vector;

  static constexpr int PerVoxel = 2;
  static constexpr double Spacing = 1.0 / PerVoxel; ///< of lattice points, in voxels

  std::array<int, 3> Axes{ 0, 1, 2 }; ///< across the image, down the image, along the rays
  bool Backwards = false;             ///< rays run toward lower indices along Axes[2]
  std::array<double, 2> Shear{};      ///< voxels across and down for each voxel along
  double SamplesPerVoxel = 1;         ///< for each voxel along Axes[2]

  std::array<double, 3> Block{};       ///< voxels of a block, along Axes
  std::array<std::size_t, 2> Points{}; ///< of a block's image; odd, centered on the block

  /** Step: that of a view, finite and not zero. */
  static HartleyLattice Make(const HartleyLayout::Triple& block, const HartleyView::Vector& step);

  std::size_t GetNumberOfPoints() const { return this->Points[0] * this->Points[1]; }

  /** The intersection of the ray through a point, in index coordinates, with index 0 of Axes[2]. */
  std::array<double, 2> Project(const Vector& place) const
  {
    const double along = place[this->Axes[2]];
    return { place[this->Axes[0]] - this->Shear[0] * along,
      place[this->Axes[1]] - this->Shear[1] * along };
  }

  /** The position of point i of an image relative to its middle, in voxels. */
  double GetPlace(int axis, std::size_t i) const
  {
    return (static_cast<double>(i) - static_cast<double>(this->Points[axis] / 2)) * Spacing;
  }

  bool operator==(const HartleyLattice&) const = default;
};
}

#endif
