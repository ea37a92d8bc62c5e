// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyPainter_h
#define gatunHartleyPainter_h

#include "gatunHartleyLattice.h"
#include "gatunHartleySource.h"

#include <memory>
#include <span>
#include <vector>

namespace gatun
{
/**
 * Makes the pictures of blocks under one direction: at each point of the lattice the integral of
 * the block's trilinear hats along the ray, in samples.
 */
class HartleyPainter
{
public:
  /** What one thread works in. */
  class Brush
  {
  public:
    virtual ~Brush() = default;

    /** Overwrites all points of the block's picture. */
    virtual void Paint(
      std::size_t block, std::span<const HartleyTerm> terms, std::span<float> picture) = 0;
  };

  virtual ~HartleyPainter() = default;

  virtual std::unique_ptr<Brush> MakeBrush() const = 0;

  /** The picture of a block whose voxels are 1, of which only so many are there along x, y, z. */
  virtual std::vector<float> PaintUnit(const HartleyLayout::Triple& filled) const = 0;
};
}

#endif
