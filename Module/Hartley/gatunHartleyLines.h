// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyLines_h
#define gatunHartleyLines_h

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace gatun
{
class FourierTransform;

/**
 * The discrete Hartley transform in one dimension, about the centre and orthonormal, of lines of
 * one length: short ones by a product with its matrix, long ones by a fast Fourier transform.
 */
class HartleyLines
{
public:
  /** What a thread works in. */
  struct Memory
  {
    std::vector<double> Values;
    std::vector<double> Complex;
  };

  explicit HartleyLines(std::uint32_t length);
  ~HartleyLines();
  HartleyLines(const HartleyLines&) = delete;
  HartleyLines& operator=(const HartleyLines&) = delete;

  /** Transforms count lines in place; thread safe. Line l has its values at
   * values[l * lineStride + i * stride]; one of the strides is 1. */
  void Transform(double* values, std::size_t lineStride, std::size_t stride, std::size_t count,
    bool forward, Memory& memory) const;

private:
  void MultiplySideBySide(
    double* values, std::size_t stride, std::size_t count, bool forward, Memory& memory) const;
  void MultiplyInRow(
    double* values, std::size_t lineStride, std::size_t count, bool forward, Memory& memory) const;
  void TransformFast(double* values, std::size_t lineStride, std::size_t stride, std::size_t count,
    bool forward, Memory& memory) const;
  void Rotate(double* values, bool forward) const;

  std::size_t Length;
  std::vector<double> Matrix;     ///< of frequency and place, if short
  std::vector<double> Transposed; ///< of place and frequency
  std::vector<double> Cosines;    ///< of the angles by which the centre moves, if long
  std::vector<double> Sines;
  std::unique_ptr<FourierTransform> Fast;
};
}

#endif
