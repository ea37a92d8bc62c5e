// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyPaperSlice_h
#define gatunHartleyPaperSlice_h

#include "gatunHartleyPainter.h"
#include "gatunHartleySpectrum.h"

#include <memory>

namespace gatun
{
/**
 * Pictures of blocks as in Yang's dissertation, for comparison: slices at right angles to the rays,
 * through spectra of blocks with zeros around them, with trilinear interpolation, and pixels as
 * large as a voxel. They are brought to the lattice by cubic convolution.
 */
class HartleyPaperSlice : public HartleyPainter
{
public:
  using Vector = HartleyView::Vector;

  static SpectrumPlan MakePlan(const HartleyLayout::Triple& block, double padding);

  HartleyPaperSlice(const HartleyLattice& lattice, const HartleyView& view,
    std::shared_ptr<HartleySpectra> spectra);

  std::unique_ptr<Brush> MakeBrush() const override;
  std::vector<float> PaintUnit(const HartleyLayout::Triple& filled) const override;

  /** Pixels along each side of a block's own picture, before it is brought to the lattice. */
  std::size_t GetSize() const { return this->Size; }

  /** Unit vectors across and down that picture, whose middle sees the block's. */
  const Vector& GetAcross() const { return this->Across; }
  const Vector& GetDown() const { return this->Down; }

  std::vector<float> PaintOwn(std::size_t block, std::span<const HartleyTerm> terms) const;

private:
  class PaperBrush;

  HartleyLattice Lattice;
  std::shared_ptr<HartleySpectra> Spectra;
  std::size_t Size = 0;
  Vector Across{}, Down{};
  double SamplesPerVoxel = 1; // of the rays' length
};
}

#endif
