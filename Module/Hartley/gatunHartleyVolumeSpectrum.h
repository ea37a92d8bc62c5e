// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyVolumeSpectrum_h
#define gatunHartleyVolumeSpectrum_h

#include "gatunHartleyLayout.h"
#include "gatunLargeArray.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

namespace gatun
{
/** The resolution of the spectrum of a whole volume. */
struct VolumeSpectrumPlan
{
  HartleyLayout::Triple Size{};
  std::array<std::size_t, 3> Points{}; ///< frequencies of one period, which is one cycle a voxel
  std::array<std::ptrdiff_t, 3>
    Highest{}; ///< frequencies that are stored, of at most half of Points

  /** Cut: the highest frequency along each axis, in cycles per voxel. */
  static VolumeSpectrumPlan Make(const HartleyLayout::Triple& size, double cut);

  /** From one point to the next along each axis, in points. */
  std::array<std::ptrdiff_t, 3> GetStrides() const;

  /** The number of the point of a frequency, given in points; that along x is not below
   * -HartleyVolumeSpectrum::Before. */
  std::ptrdiff_t GetPoint(const std::array<std::ptrdiff_t, 3>& at) const;

  std::uint64_t GetBytes() const;        ///< of the spectrum
  std::uint64_t GetWorkingBytes() const; ///< more, while it is made
};

/**
 * The Fourier spectrum of a volume about its middle, in half precision. Its points are at multiples
 * of 1 / Points cycles per voxel. The period is large enough along all axes for an image along each
 * of them. Between the points it is interpolated along one axis by a windowed sinc, which does not
 * change the points. So one spectrum serves all directions.
 *
 * Half of the spectrum is stored, as the voxels are real: that of positive frequencies along x.
 * Some points before and after those of the plan are stored for interpolation.
 */
class HartleyVolumeSpectrum
{
public:
  static constexpr std::ptrdiff_t Before = 3;
  static constexpr std::ptrdiff_t After = 4;
  static constexpr std::size_t Taps = 8; ///< the fourth is that of the point before a position

  static constexpr std::size_t Steps = 512; ///< of the table of weights, from point to point

  /** Voxels: x fastest. Parallel. Throws Error(Aborted) if progress returns false. */
  HartleyVolumeSpectrum(const VolumeSpectrumPlan& plan, std::span<const float> voxels,
    const std::function<bool(double)>& progress = {});

  const VolumeSpectrumPlan& GetPlan() const { return this->Plan; }

  /** By which stored values have to be multiplied. */
  double GetScale() const { return this->Scale; }

  /** All values: real and imaginary parts. */
  const std::uint16_t* GetValues() const { return this->Values.data(); }

  /** The number of the point of a frequency, given in points; that along x is not below -Before. */
  std::ptrdiff_t GetPoint(const std::array<std::ptrdiff_t, 3>& at) const
  {
    return at[0] * this->Strides[0] + at[1] * this->Strides[1] + at[2] + this->Middle;
  }

  /** From one point to the next along an axis, in points. */
  std::ptrdiff_t GetStride(std::size_t axis) const { return this->Strides[axis]; }

  /** The largest number of points, for 32 bits. */
  static constexpr std::uint64_t MostBytes = std::uint64_t{ 1 } << 34;

  /** The weights of Taps points, each twice, for Steps + 1 positions and one more. */
  static const float* GetWeights();

private:
  class Builder;

  VolumeSpectrumPlan Plan;
  double Scale = 1;
  std::array<std::ptrdiff_t, 3> Strides{};
  std::ptrdiff_t Middle = 0; // number of the point of frequency 0
  LargeArray<std::uint16_t> Values;
};
}

#endif
