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
/** How spectra of blocks are made finer, so that values between their points can be found. */
struct SpectrumPlan
{
  HartleyLayout::Triple Block{};
  std::array<int, 3> Axes{ 0, 1, 2 };             ///< lines lie along the third
  std::array<std::size_t, 3> Points{};            ///< frequencies along Axes, in one period
  std::shared_ptr<const KaiserBessel> Correction; ///< along Axes[2]; null: none

  bool operator==(const SpectrumPlan& other) const
  {
    return this->Block == other.Block && this->Axes == other.Axes && this->Points == other.Points &&
      !this->Correction == !other.Correction;
  }
};

/**
 * The Hartley spectrum of a block about its middle, at multiples of 1 / Points cycles a voxel from
 * 0 up to 1. It goes on with period 1 along axes of which the block has an odd number of voxels;
 * with the other sign in every other period where that number is even, as the middle is then
 * between voxels.
 */
class HartleySpectrum
{
public:
  HartleySpectrum(const SpectrumPlan& plan, std::span<const HartleyTerm> terms);

  /** All values along the third axis; Before lie before the first, and After behind the last. */
  const float* GetLine(std::size_t first, std::size_t second) const
  {
    return this->Values.data() + (second * this->Points[0] + first) * this->Stride + Before;
  }

  std::size_t GetBytes() const { return this->Values.size() * sizeof(float); }

  static constexpr std::size_t Before = 2;
  static constexpr std::size_t After = 6;

private:
  std::array<std::size_t, 3> Points;
  std::size_t Stride; // of lines
  std::vector<float> Values;
};

/** The spectra of blocks that are kept from picture to picture. Thread safe. */
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

  /** Of a block of which the first voxels along each axis are 1. */
  std::shared_ptr<const HartleySpectrum> GetUnit(const HartleyLayout::Triple& filled);

private:
  SpectrumPlan Plan;
  // The first ones are kept, because all are used in a cycle.
  Cache<std::size_t, HartleySpectrum> Kept;
  Cache<HartleyLayout::Triple, HartleySpectrum> KeptUnits;
};
}

#endif
