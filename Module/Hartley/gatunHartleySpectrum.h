// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleySpectrum_h
#define gatunHartleySpectrum_h

#include "gatunCache.h"
#include "gatunHartleyKernelFunction.h"
#include "gatunHartleyLayout.h"
#include "gatunHartleySource.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace gatun
{
/** The resolution of zero-padded spectra, for interpolation between their points. */
struct SpectrumPlan
{
  HartleyLayout::Triple Block{};
  std::array<int, 3> Axes{ 0, 1, 2 };             ///< lines run along the third
  std::array<std::size_t, 3> Points{};            ///< frequencies of one period, along Axes
  std::shared_ptr<const KaiserBessel> Correction; ///< along Axes[2]; null: none

  bool operator==(const SpectrumPlan& other) const
  {
    return this->Block == other.Block && this->Axes == other.Axes && this->Points == other.Points &&
      !this->Correction == !other.Correction;
  }
};

/**
 * The Hartley spectrum of a block about its middle, at multiples of 1 / Points cycles per voxel
 * from 0 to 1. It has the period 1. Along axes where the block has an even number of voxels, its
 * middle is between voxels and the sign changes from each period to the next.
 */
class HartleySpectrum
{
public:
  HartleySpectrum(const SpectrumPlan& plan, std::span<const HartleyTerm> terms);

  /** The values along the third axis. Before values precede the first, After follow the last. */
  const float* GetLine(std::size_t first, std::size_t second) const
  {
    return this->Values.data() + (second * this->Points[0] + first) * this->Stride + Before;
  }

  std::size_t GetBytes() const { return this->Values.size() * sizeof(float); }

  static constexpr std::size_t Before = 2;
  static constexpr std::size_t After = 6;

private:
  class Builder;

  std::array<std::size_t, 3> Points;
  std::size_t Stride; // from one line to the next
  std::vector<float> Values;
};

/** Computes the spectra of blocks and keeps as many of them as a budget allows. Thread safe. */
class HartleySpectra
{
public:
  HartleySpectra(SpectrumPlan plan, std::uint64_t bytes)
    : Plan(std::move(plan))
    , Kept(std::make_shared<CacheBudget>(bytes), CachePolicy::KeepFirst)
    , KeptUnits(Kept.GetBudget(), CachePolicy::KeepFirst)
  {
  }

  const SpectrumPlan& GetPlan() const { return this->Plan; }

  std::shared_ptr<const HartleySpectrum> Get(std::size_t block, std::span<const HartleyTerm> terms);

  /** Whether Get finds the spectrum of a block, and so does not use its terms. Kept spectra
   * stay. */
  bool IsKept(std::size_t block) { return this->Kept.Find(block) != nullptr; }

  /** The spectrum of a block whose first voxels along each axis (filled) are 1. */
  std::shared_ptr<const HartleySpectrum> GetUnit(const HartleyLayout::Triple& filled);

private:
  SpectrumPlan Plan;
  // The first ones are kept, because all are used in a cycle.
  Cache<std::size_t, HartleySpectrum> Kept;
  Cache<HartleyLayout::Triple, HartleySpectrum> KeptUnits;
};
}

#endif
