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
 * Computes the images of blocks as Yang's dissertation does, for comparison: slices orthogonal to
 * the rays through the spectra of zero-padded blocks, with trilinear interpolation and pixels of
 * the size of a voxel. The images are resampled to the lattice by cubic convolution.
 */
class HartleyPaperSlice : public HartleyPainter
{
public:
  using Vector = HartleyView::Vector;

  static SpectrumPlan MakePlan(const HartleyLayout::Triple& block, double padding);

  HartleyPaperSlice(const HartleyLattice& lattice, const HartleyView& view,
    std::shared_ptr<HartleySpectra> spectra);

  std::unique_ptr<Brush> MakeBrush() const override;
  bool IsKept(std::size_t block) const override { return this->Spectra->IsKept(block); }
  std::vector<float> PaintUnit(const HartleyLayout::Triple& filled) const override;

  /** Pixels along each side of a block's image before resampling. */
  std::size_t GetSize() const { return this->Size; }

  /** Unit vectors across and down that image, which is centered on the block. */
  const Vector& GetAcross() const { return this->Across; }
  const Vector& GetDown() const { return this->Down; }

  /** The image of a block before resampling. */
  std::vector<float> PaintOwn(std::size_t block, std::span<const HartleyTerm> terms) const;

private:
  class PaperBrush;

  HartleyLattice Lattice;
  std::shared_ptr<HartleySpectra> Spectra;
  std::size_t Size = 0;
  Vector Across{}, Down{};
  double SamplesPerVoxel = 1; // per unit length of a ray
};
}

#endif
