// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyFourier_h
#define gatunHartleyFourier_h

#include "gatunHartleyLanes.h"

#include <cstddef>
#include <vector>

namespace gatun
{
/**
 * Fourier transforms of eight lines at a time, in single precision: out[u] = sum over x of in[x]
 * exp(-2 pi i u x / size), or, inverse, with the other sign. Without scaling. Fast for sizes
 * without prime factors above 5; a prime factor p takes p operations for each value. Immutable.
 *
 * D. H. Bailey: A high-performance FFT algorithm for vector supercomputers. International Journal
 * of Supercomputer Applications 2(1), 1988 (Stockham's transform, which needs no bit reversal).
 */
class LaneFourier
{
public:
  explicit LaneFourier(std::size_t size, const HartleyLaneLoops& loops = GetBestHartleyLanes());

  std::size_t GetSize() const { return this->Size; }

  /** Room: as long as values. Both are overwritten. Returns where the result is. */
  ComplexLanes* Forward(ComplexLanes* values, ComplexLanes* room) const
  {
    return this->Loops.Transform(this->Stages.data(), this->Stages.size(), false, values, room);
  }
  ComplexLanes* Inverse(ComplexLanes* values, ComplexLanes* room) const
  {
    return this->Loops.Transform(this->Stages.data(), this->Stages.size(), true, values, room);
  }

private:
  std::size_t Size;
  const HartleyLaneLoops& Loops;
  std::vector<std::vector<float>> Factors; // that the stages refer to
  std::vector<FourierStage> Stages;
};

/** The smallest even size that is not below the given one and has no prime factor above 5. */
std::size_t GetEvenFastSize(std::size_t size);
}

#endif
