// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunHartleyRay.h"

#include <algorithm>

namespace gatun
{
//------------------------------------------------------------------------------
HartleyRay::HartleyRay(const HartleyLayout::Triple& block, const HartleyLattice& lattice)
  : Lattice(lattice)
{
  const std::array<std::ptrdiff_t, 3> strides{ 1, static_cast<std::ptrdiff_t>(block[0]),
    static_cast<std::ptrdiff_t>(block[0]) * static_cast<std::ptrdiff_t>(block[1]) };
  for (int i = 0; i < 3; ++i)
  {
    this->Strides[i] = strides[lattice.Axes[i]];
  }
}

//------------------------------------------------------------------------------
void HartleyRay::AddWeights(double across, double down, std::span<double> weights)
{
  const auto& size = this->Lattice.Block;
  const std::array<double, 2> place{ across, down };

  // The part of the ray in the support of the block, measured from the block's middle.
  double first = -(size[2] + 1) / 2;
  double last = (size[2] + 1) / 2;
  for (int i = 0; i < 2; ++i)
  {
    const double reach = (size[i] + 1) / 2;
    const double shear = this->Lattice.Shear[i];
    if (shear == 0)
    {
      if (std::abs(place[i]) >= reach)
      {
        return;
      }
      continue;
    }
    const double one = (-reach - place[i]) / shear;
    const double two = (reach - place[i]) / shear;
    first = std::max(first, std::min(one, two));
    last = std::min(last, std::max(one, two));
  }
  if (!(first < last))
  {
    return;
  }

  // Intersections with planes of voxels.
  this->Breaks = { first, last };
  const auto cross = [&](double at, double slope, double planes)
  {
    const double middle = (planes - 1) / 2;
    for (double plane = -middle - 1; plane <= middle + 1; ++plane)
    {
      const double where = (plane - at) / slope;
      if (first < where && where < last)
      {
        this->Breaks.push_back(where);
      }
    }
  };
  cross(0, 1, size[2]);
  for (int i = 0; i < 2; ++i)
  {
    if (this->Lattice.Shear[i] != 0)
    {
      cross(place[i], this->Lattice.Shear[i], size[i]);
    }
  }
  std::sort(this->Breaks.begin(), this->Breaks.end());

  // Two-point Gauss quadrature is exact for cubics.
  const double offset = 1 / (2 * std::sqrt(3.0));
  for (std::size_t i = 1; i < this->Breaks.size(); ++i)
  {
    const double length = this->Breaks[i] - this->Breaks[i - 1];
    const double middle = (this->Breaks[i] + this->Breaks[i - 1]) / 2;
    for (const double along : { middle - offset * length, middle + offset * length })
    {
      this->AddPoint(across, down, along, length / 2, weights);
    }
  }
}

//------------------------------------------------------------------------------
void HartleyRay::AddPoint(
  double across, double down, double along, double length, std::span<double> weights)
{
  const std::array<double, 3> place{ across + this->Lattice.Shear[0] * along,
    down + this->Lattice.Shear[1] * along, along };
  std::array<std::ptrdiff_t, 3> low;
  std::array<std::array<double, 2>, 3> parts;
  for (int i = 0; i < 3; ++i)
  {
    const double voxel = place[i] + (this->Lattice.Block[i] - 1) / 2;
    const double floor = std::floor(voxel);
    low[i] = static_cast<std::ptrdiff_t>(floor);
    parts[i] = { 1 - (voxel - floor), voxel - floor };
    for (int side = 0; side < 2; ++side)
    {
      const auto index = low[i] + side;
      if (index < 0 || index >= static_cast<std::ptrdiff_t>(this->Lattice.Block[i]))
      {
        parts[i][side] = 0;
      }
    }
  }
  const double scale = length * this->Lattice.SamplesPerVoxel;
  for (int corner = 0; corner < 8; ++corner)
  {
    const std::array<int, 3> side{ corner & 1, corner >> 1 & 1, corner >> 2 };
    const double weight = parts[0][side[0]] * parts[1][side[1]] * parts[2][side[2]] * scale;
    if (weight != 0)
    {
      std::ptrdiff_t index = 0;
      for (int i = 0; i < 3; ++i)
      {
        index += (low[i] + side[i]) * this->Strides[i];
      }
      weights[static_cast<std::size_t>(index)] += weight;
    }
  }
}
}
