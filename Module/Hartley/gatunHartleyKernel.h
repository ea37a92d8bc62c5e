// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyKernel_h
#define gatunHartleyKernel_h

// The loops of the projector that have a version for each set of instructions.

#include <cstddef>
#include <cstdint>

namespace gatun
{
/** Where values are, and how much of them to take. */
struct HartleyShare
{
  std::uint32_t First;
  float Scale;
};

/** So many sums stay in registers. */
constexpr std::size_t HartleySegment = 32;

/** A frequency, in cycles a voxel, and the spectrum of a hat there. */
struct HartleyBand
{
  double Frequency;
  float Hat;
};

/** How values between the points of a spectrum's line are found. */
struct HartleyBetween
{
  static constexpr std::size_t Taps = 8; // of which some may be 0

  const float* Weights; // of the taps, for Steps + 1 places from one point to the next
  float Steps;
  const float* Hats; // spectrum of a hat, HatSteps a cycle, from frequency 0 on
  float HatSteps;
  double Points; // in a period, of one cycle a voxel
  double ShearX, ShearY;
  bool Alternates; // whether every other period has the other sign
};

struct HartleyKernelLoops
{
  /** sum[k] = Scale * values[First + k], summed over all shares; k below HartleySegment. */
  void (*Combine)(
    const float* values, const HartleyShare* shares, std::size_t shareCount, float* sum);

  /** Sums what a line of a spectrum has where count bands across meet count bands down, times the
   * hats; the line is that of the taps of frequency 0. Meetings with less than least are left out.
   */
  float (*SumBands)(const float* line, const HartleyBetween& between, const HartleyBand* across,
    const HartleyBand* down, std::size_t count, float least);

  /** Four channels at a place of a lattice between its points (first: of the four by four points
   * around it the first; next row: so many floats on; x, y: from 0 to 1), by cubic convolution. */
  void (*Interpolate)(const float* first, std::size_t nextRow, float x, float y, float* channels);
};

/** The fastest that this processor has. */
const HartleyKernelLoops& GetBestHartleyKernel();
const HartleyKernelLoops& GetPortableHartleyKernel();
const HartleyKernelLoops* GetAVX2HartleyKernel(); ///< null where it was not made
}

#endif
