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
/** A law with its transfer function, ready for use. */
class HartleyLookup
{
public:
  HartleyLookup(const HartleyShading& shading, double base, const Range& range);

  HartleyLaw GetLaw() const { return this->Shading.Law; }

  /** Whether blocks in which all voxels have the base value show nothing. */
  bool IsBaseClear() const { return this->BaseClear; }

  /** What a block adds behind what is there: first is the integral of its densities, less that of
   * the base value; samples that of ones. */
  void Add(float first, float samples, std::array<float, 4>& channels) const;

  /** The same with what a slab has at a place of the picture. The fourth number is the part of
   * light that comes through. */
  void AddSlab(const std::array<float, 4>& channels, std::array<float, 4>& pixel) const;

private:
  const std::array<float, 4>& Find(float density) const;

  HartleyShading Shading;
  float Base = 0;
  float Least = 0, Most = 0; // densities that there are
  float First = 0, PerDensity = 1;
  bool BaseClear = false;
  std::vector<std::array<float, 4>> Table; // red, green, blue, optical depth of a sample
};
}

#endif
