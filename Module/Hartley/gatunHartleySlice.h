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
 * Pictures of blocks by the projection-slice theorem: the spectrum of a block's picture is the
 * slice through the middle of the block's spectrum, across the rays, times the spectrum of the
 * hats. In the lattice's sheared coordinates the slice meets the spectrum's points along two axes,
 * and only along the third values have to be found between them.
 *
 * M. Levoy: Volume rendering using the Fourier projection-slice theorem. Graphics Interface, 1992.
 */
class HartleySlice : public HartleyPainter
{
public:
  /** How fine spectra have to be for a direction; padding: points of a period along the rays, in
   * voxels of the block. */
  static SpectrumPlan MakePlan(
    const HartleyLayout::Triple& block, const HartleyLattice& lattice, double padding);

  /** Spectra are those of such a plan. */
  HartleySlice(const HartleyLattice& lattice, std::shared_ptr<HartleySpectra> spectra);

  std::unique_ptr<Brush> MakeBrush() const override;
  std::vector<float> PaintUnit(const HartleyLayout::Triple& filled) const override;

private:
  class SliceBrush;

  HartleyLattice Lattice;
  std::shared_ptr<HartleySpectra> Spectra;
};
}

#endif
