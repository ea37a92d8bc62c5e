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
  /** A block to paint: all points of its picture are overwritten. */
  struct Task
  {
    std::size_t Block = 0;
    std::span<const HartleyTerm> Terms;
    float* Picture = nullptr;
  };

  /** What one thread works in. */
  class Brush
  {
  public:
    virtual ~Brush() = default;
    virtual void Paint(std::span<const Task> tasks) = 0;
  };

  virtual ~HartleyPainter() = default;

  virtual std::unique_ptr<Brush> MakeBrush() const = 0;

  /** The picture of a block whose voxels are 1, of which only so many are there along x, y, z. */
  virtual std::vector<float> PaintUnit(const HartleyLayout::Triple& filled) const = 0;
};
}

#endif
