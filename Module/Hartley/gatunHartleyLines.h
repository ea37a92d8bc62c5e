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
 * The one-dimensional orthonormal discrete Hartley transform about the center, for lines of one
 * length. Short lines are multiplied by its matrix; long ones use a fast Fourier transform.
 */
class HartleyLines
{
public:
  /** The working memory of a thread. */
  struct Memory
  {
    std::vector<double> Values;
    std::vector<double> Complex;
  };

  explicit HartleyLines(std::uint32_t length);
  ~HartleyLines();
  HartleyLines(const HartleyLines&) = delete;
  HartleyLines& operator=(const HartleyLines&) = delete;

  /** Transforms count lines in place. The values of line l are values[l * lineStride + i * stride];
   * one of the strides is 1. Thread safe. */
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
  std::vector<double> Matrix;     ///< by frequency and position; of short lines
  std::vector<double> Transposed; ///< by position and frequency
  std::vector<double> Cosines;    ///< of the phase of the center; of long lines
  std::vector<double> Sines;
  std::unique_ptr<FourierTransform> Fast;
};
}

#endif
