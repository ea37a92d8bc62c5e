// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleySlice_h
#define gatunHartleySlice_h

#include "gatunHartleyPainter.h"
#include "gatunHartleySpectrum.h"

#include <memory>

namespace gatun
{
/**
 * Computes the image of a block by the projection-slice theorem: the spectrum of the image is the
 * central slice of the block's spectrum, orthogonal to the rays, times the spectrum of the
 * trilinear basis function. In the sheared coordinates of the lattice, the slice passes through the
 * points of the spectrum along two axes. Interpolation is needed along the third axis only.
 *
 * M. Levoy: Volume rendering using the Fourier projection-slice theorem. Graphics Interface, 1992.
 */
class HartleySlice : public HartleyPainter
{
public:
  /** The resolution of the spectra for a direction. Padding: points of a period along the rays
   * divided by the voxels of a block. */
  static SpectrumPlan MakePlan(
    const HartleyLayout::Triple& block, const HartleyLattice& lattice, double padding);

  /** Spectra: made by such a plan. */
  HartleySlice(const HartleyLattice& lattice, std::shared_ptr<HartleySpectra> spectra);

  std::unique_ptr<Brush> MakeBrush() const override;
  bool IsKept(std::size_t block) const override { return this->Spectra->IsKept(block); }
  std::vector<float> PaintUnit(const HartleyLayout::Triple& filled) const override;

private:
  class SliceBrush;

  HartleyLattice Lattice;
  std::shared_ptr<HartleySpectra> Spectra;
};
}

#endif
