// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyKernelFunction_h
#define gatunHartleyKernelFunction_h

#include <cstddef>
#include <vector>

namespace gatun
{
/**
 * The Kaiser-Bessel interpolation kernel for equally spaced samples of a spectrum. The signal must
 * have been divided by the Fourier transform of the kernel before its spectrum was computed.
 *
 * P. J. Beatty, D. G. Nishimura, J. M. Pauly: Rapid gridding reconstruction with a minimal
 * oversampling ratio. IEEE Transactions on Medical Imaging 24(6), 2005 (for its shape parameter).
 */
class KaiserBessel
{
public:
  static constexpr int Taps = 6;
  static constexpr std::size_t Steps = 512; ///< table entries between two points

  /** Values: length of the signal; points: in one period of its spectrum. */
  KaiserBessel(std::size_t values, std::size_t points);

  /** The Fourier transform of the kernel at a position relative to the middle of the signal. */
  double GetTransform(double place) const;

  /** The weights of Stored points, for Steps + 1 positions from one point to the next. The first
   * weight is for the second point before the position; weights after the taps are 0. */
  static constexpr std::size_t Stored = 8;
  const float* GetWeights() const { return this->Table.data(); }

private:
  double Points;
  double Shape;
  std::vector<float> Table;
};
}

#endif
