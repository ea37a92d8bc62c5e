// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyQuickSlice_h
#define gatunHartleyQuickSlice_h

#include "gatunCache.h"
#include "gatunHartleyLanes.h"
#include "gatunHartleyPainter.h"
#include "gatunHartleyVolumeSpectrum.h"

#include <memory>
#include <vector>

namespace gatun
{
/** The spectra of blocks that HartleyQuickSlice uses, as many as a budget allows. They serve all
 * directions. Thread safe. */
class HartleyBlockSpectra
{
public:
  HartleyBlockSpectra(const HartleyLayout::Triple& block, std::uint64_t bytes);

  const VolumeSpectrumPlan& GetPlan() const { return this->Plan; }
  std::shared_ptr<const HartleyVolumeSpectrum> Get(
    std::size_t block, std::span<const HartleyTerm> terms);
  bool IsKept(std::size_t block) { return this->Kept.Find(block) != nullptr; }

private:
  VolumeSpectrumPlan Plan;
  // The first ones are kept, because all are used in a cycle.
  Cache<std::size_t, HartleyVolumeSpectrum> Kept;
};

/**
 * Computes the images of blocks by the projection-slice theorem, as HartleySlice does, in single
 * precision from spectra in half precision, eight lines at a time. The points of the slice are the
 * same for all blocks and are listed once for a direction.
 */
class HartleyQuickSlice : public HartleyPainter
{
public:
  HartleyQuickSlice(const HartleyLattice& lattice, const HartleyLayout::Triple& block,
    std::shared_ptr<HartleyBlockSpectra> spectra);

  std::unique_ptr<Brush> MakeBrush() const override;
  std::vector<float> PaintUnit(const HartleyLayout::Triple& filled) const override;
  bool IsKept(std::size_t block) const override { return this->Spectra->IsKept(block); }

private:
  class QuickBrush;

  /** An axis across the rays. */
  struct Side
  {
    std::size_t Axis = 0;
    double Shear = 0;
    std::ptrdiff_t Period = 0; ///< frequencies in a cycle per voxel
    bool Even = false;         ///< whether the sign changes from each period to the next
    std::size_t Points = 0;    ///< of a period of the image
    std::size_t Count = 0;     ///< of the points of the image of a block
    std::size_t GetIndex(std::size_t i) const
    {
      return (i + this->Points - this->Count / 2) % this->Points;
    }
  };

  void List(const VolumeSpectrumPlan& plan);

  HartleyLattice Lattice;
  HartleyLayout::Triple Block;
  std::shared_ptr<HartleyBlockSpectra> Spectra;
  std::array<Side, 2> Sides; // of columns, of rows
  std::size_t Along = 2;
  std::ptrdiff_t Stride = 1;                       // of the taps
  std::vector<std::vector<HartleySample>> Samples; // of each column of the slice
};
}

#endif
