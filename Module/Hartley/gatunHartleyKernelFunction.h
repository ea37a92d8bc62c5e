// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyKernelFunction_h
#define gatunHartleyKernelFunction_h

#include <cstddef>
#include <vector>

namespace gatun
{
/**
 * The Kaiser-Bessel function, by which values between equally spaced ones are found: a sum over the
 * nearest ones, of a signal that has been divided by the function's Fourier transform before.
 *
 * P. J. Beatty, D. G. Nishimura, J. M. Pauly: Rapid gridding reconstruction with a minimal
 * oversampling ratio. IEEE Transactions on Medical Imaging 24(6), 2005 (for its shape parameter).
 */
class KaiserBessel
{
public:
  static constexpr int Taps = 6;
  static constexpr std::size_t Steps = 512; ///< of the table, between two points

  /** For a signal of so many values, with so many points in a period of its spectrum. */
  KaiserBessel(std::size_t values, std::size_t points);

  /** Fourier transform at a value, counted from the middle of the signal. */
  double GetTransform(double place) const;

  /** For Steps + 1 places from one point to the next, the weights of the points from two before
   * the one; those behind the taps are 0. */
  static constexpr std::size_t Stored = 8;
  const float* GetWeights() const { return this->Table.data(); }

private:
  double Points;
  double Shape;
  std::vector<float> Table;
};
}

#endif
