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
 * Computes the images of blocks for one direction: at each lattice point, the integral of the
 * block's trilinear basis functions along the ray, in samples.
 */
class HartleyPainter
{
public:
  /** A block to project. All points of its image are overwritten. */
  struct Task
  {
    std::size_t Block = 0;
    std::span<const HartleyTerm> Terms;
    float* Image = nullptr;
  };

  /** The working memory of one thread. */
  class Brush
  {
  public:
    virtual ~Brush() = default;
    virtual void Paint(std::span<const Task> tasks) = 0;
  };

  virtual ~HartleyPainter() = default;

  virtual std::unique_ptr<Brush> MakeBrush() const = 0;

  /** Whether a block can be painted without its coefficients, because the results from them are
   * kept. */
  virtual bool IsKept(std::size_t) const { return false; }

  /** The image of a block whose first voxels along x, y and z (filled) are 1 and the others 0. */
  virtual std::vector<float> PaintUnit(const HartleyLayout::Triple& filled) const = 0;
};
}

#endif
