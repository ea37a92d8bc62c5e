// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyKernel_h
#define gatunHartleyKernel_h

// The inner loops of the projector, which have a version for each instruction set.

#include "gatunHartleyShading.h"

#include <cstddef>
#include <cstdint>

namespace gatun
{
/** A run of values and its weight. */
struct HartleyShare
{
  std::uint32_t First;
  float Scale;
};

/** The number of sums that stay in registers. */
constexpr std::size_t HartleySegment = 32;

/** A frequency, in cycles per voxel, and the spectrum of the tent function (a trilinear basis
 * function along one axis) at that frequency. */
struct HartleyBand
{
  double Frequency;
  float Tent;
};

/** Interpolation between the points of a spectrum's line. */
struct HartleyBetween
{
  static constexpr std::size_t Taps = 8; // some may be 0

  const float* Weights; // of the taps, for Steps + 1 positions from one point to the next
  float Steps;
  const float* Tents; // spectrum of the tent function, TentSteps per cycle, from frequency 0
  float TentSteps;
  double Points; // in a period, which is one cycle per voxel
  double ShearX, ShearY;
  bool Alternates; // whether the sign changes from each period to the next
};

/** A voxel's place in a block and its weights in the sums of two neighboring lattice points. */
struct HartleyTap
{
  std::int32_t Place;
  float Even;
  float Odd;
};

/** How densities become colors. The planes of channels are the colors (one plane if all are gray)
 * and the opacity or, in the exponential model, the optical depth. The planes of an X-ray are the
 * sum of the densities and the number of samples. */
struct HartleyOpacity
{
  static constexpr std::size_t TableSize = 4096;

  HartleyOpacityModel Model = HartleyOpacityModel::XRay;
  std::size_t Planes = 2;
  float Base = 0;
  float Least = 0; ///< of the densities
  float Most = 0;
  float First = 0; ///< density of the table's first entry
  float PerDensity = 1;
  float Extinction = 0;
  float Zero = 0;               ///< base value minus the value from which densities are measured
  const float* Table = nullptr; ///< TableSize colors for each plane; the last is optical depths
};

/** Planes of numbers on a lattice. */
struct HartleyPlanes
{
  const float* Values = nullptr;
  std::size_t Stride = 0; ///< from one row to the next
  std::size_t Plane = 0;  ///< from one plane to the next
  double HighestX = 0;    ///< the last positions that have all points for interpolation
  double HighestY = 0;
};

/** The positions of pixels in lattice points. */
struct HartleyRow
{
  double X = 0;
  double Y = 0;
  double StepX = 0;
  double StepY = 0;
  std::size_t Count = 0;
};

struct HartleyKernelLoops
{
  /** sum[k] = Scale * values[First + k], summed over all shares; k below HartleySegment. */
  void (*Combine)(
    const float* values, const HartleyShare* shares, std::size_t shareCount, float* sum);

  /** Sums the values of a spectrum's line for each combination of count bands across and count
   * bands down, weighted by the tent functions' spectra. Line: the first tap of frequency 0.
   * Combinations with a weight below least are skipped. */
  float (*SumBands)(const float* line, const HartleyBetween& between, const HartleyBand* across,
    const HartleyBand* down, std::size_t count, float least);

  /** sum[2 m] = Even * values[Place + m], sum[2 m + 1] = Odd * values[Place + m], summed over all
   * taps; m below 8 * groups. At most 4 groups. */
  void (*Project)(const float* values, const HartleyTap* taps, std::size_t tapCount,
    std::size_t groups, float* sum);

  /** Composites count points of a block behind those of a slab. Image: the integrals of the
   * densities minus the base value, or null if they are 0; unit: of ones, and 0 from count to the
   * next multiple of 8. All arrays may be accessed up to there. */
  void (*AddBlock)(const HartleyOpacity& opacities, const float* image, const float* unit,
    std::size_t count, float* planes, std::size_t plane);

  /** Interpolates a slab at pixels, by cubic convolution, and composites it behind them. The last
   * plane of the pixels is their transmittance. */
  void (*AddSlab)(const HartleyOpacity& opacities, const HartleyPlanes& slab, const HartleyRow& row,
    float* pixels, std::size_t plane);
};

/** The fastest version that this processor supports. */
const HartleyKernelLoops& GetBestHartleyKernel();
const HartleyKernelLoops& GetPortableHartleyKernel();
const HartleyKernelLoops* GetAVX2HartleyKernel(); ///< null if it was not compiled
}

#endif
