// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyKernel_h
#define gatunHartleyKernel_h

// The loops of the projector that have a version for each set of instructions.

#include <cstddef>

namespace gatun
{
/** Values, and how much of them to take. */
struct HartleyShare
{
  const float* Values;
  float Scale;
};

struct HartleyKernelLoops
{
  /** sum[i] = Scale * Values[i], summed over all shares. */
  void (*Combine)(
    const HartleyShare* shares, std::size_t shareCount, std::size_t count, float* sum);

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
