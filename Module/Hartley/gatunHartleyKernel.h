// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyKernel_h
#define gatunHartleyKernel_h

// The inner loops of the projector, which have a version for each instruction set.

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

  /** Interpolates four channels between the points of a lattice by cubic convolution. First: the
   * first of the four by four surrounding points; nextRow: distance of rows in floats; x, y:
   * position in the middle cell, 0 to 1. */
  void (*Interpolate)(const float* first, std::size_t nextRow, float x, float y, float* channels);
};

/** The fastest version that this processor supports. */
const HartleyKernelLoops& GetBestHartleyKernel();
const HartleyKernelLoops& GetPortableHartleyKernel();
const HartleyKernelLoops* GetAVX2HartleyKernel(); ///< null if it was not compiled
}

#endif
