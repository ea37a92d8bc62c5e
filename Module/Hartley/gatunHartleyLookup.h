// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyLookup_h
#define gatunHartleyLookup_h

#include "gatunHartleyShading.h"
#include "gatunTypes.h"

#include <array>
#include <vector>

namespace gatun
{
/** An opacity model with its transfer function, tabulated. */
class HartleyLookup
{
public:
  HartleyLookup(const HartleyShading& shading, double base, const Range& range);

  /** Whether blocks whose voxels all have the base value are transparent. */
  bool IsBaseClear() const { return this->BaseClear; }

  /** Composites a block behind the content of a lattice point. First: the integral of its densities
   * minus the base value; samples: the integral of ones. */
  void Add(float first, float samples, std::array<float, 4>& channels) const;

  /** Composites a slab behind the content of a pixel, whose fourth number is the transmittance. */
  void AddSlab(const std::array<float, 4>& channels, std::array<float, 4>& pixel) const;

private:
  const std::array<float, 4>& Find(float density) const;

  HartleyShading Shading;
  float Base = 0;
  float Least = 0, Most = 0; // range of the densities
  float First = 0, PerDensity = 1;
  bool BaseClear = false;
  std::vector<std::array<float, 4>> Table; // red, green, blue, optical depth of a sample
};
}

#endif
