// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunHartleyLines.h"

#include "gatunFourier.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace gatun
{
namespace
{
constexpr std::size_t LongestProduct = 32;

double GetFrequency(std::size_t index, std::size_t length)
{
  return 2 * index <= length ? static_cast<double>(index)
                             : static_cast<double>(index) - static_cast<double>(length);
}
}

//------------------------------------------------------------------------------
HartleyLines::HartleyLines(std::uint32_t length)
  : Length(length)
{
  const double n = length;
  const double center = (n - 1) / 2;
  const double scale = 1 / std::sqrt(n);
  if (length <= LongestProduct)
  {
    this->Matrix.resize(this->Length * this->Length);
    this->Transposed.resize(this->Length * this->Length);
    for (std::size_t k = 0; k < this->Length; ++k)
    {
      for (std::size_t x = 0; x < this->Length; ++x)
      {
        const double angle = 2 * std::numbers::pi * GetFrequency(k, this->Length) *
          (static_cast<double>(x) - center) / n;
        const double value = scale * (std::cos(angle) + std::sin(angle));
        this->Matrix[k * this->Length + x] = value;
        this->Transposed[x * this->Length + k] = value;
      }
    }
    return;
  }
  this->Cosines.resize(this->Length);
  this->Sines.resize(this->Length);
  for (std::size_t k = 0; k < this->Length; ++k)
  {
    const double angle = 2 * std::numbers::pi * GetFrequency(k, this->Length) * center / n;
    this->Cosines[k] = scale * std::cos(angle);
    this->Sines[k] = scale * std::sin(angle);
  }
  this->Fast = std::make_unique<FourierTransform>(this->Length);
}

//------------------------------------------------------------------------------
HartleyLines::~HartleyLines() = default;

//------------------------------------------------------------------------------
void HartleyLines::Transform(double* values, std::size_t lineStride, std::size_t stride,
  std::size_t count, bool forward, Memory& memory) const
{
  if (this->Fast)
  {
    this->TransformFast(values, lineStride, stride, count, forward, memory);
  }
  else if (stride == 1)
  {
    this->MultiplyInRow(values, lineStride, count, forward, memory);
  }
  else
  {
    this->MultiplySideBySide(values, stride, count, forward, memory);
  }
}

//------------------------------------------------------------------------------
void HartleyLines::MultiplySideBySide(
  double* values, std::size_t stride, std::size_t count, bool forward, Memory& memory) const
{
  const auto& matrix = forward ? this->Matrix : this->Transposed;
  memory.Values.resize(this->Length * count);
  double* const in = memory.Values.data();
  for (std::size_t x = 0; x < this->Length; ++x)
  {
    std::copy_n(values + x * stride, count, in + x * count);
  }
  for (std::size_t k = 0; k < this->Length; ++k)
  {
    double* const out = values + k * stride;
    const double* const row = matrix.data() + k * this->Length;
    std::fill_n(out, count, 0.0);
    for (std::size_t x = 0; x < this->Length; ++x)
    {
      const double factor = row[x];
      const double* const from = in + x * count;
      for (std::size_t i = 0; i < count; ++i)
      {
        out[i] += factor * from[i];
      }
    }
  }
}

//------------------------------------------------------------------------------
void HartleyLines::MultiplyInRow(
  double* values, std::size_t lineStride, std::size_t count, bool forward, Memory& memory) const
{
  // Row by row of the other matrix, which is contiguous.
  const auto& matrix = forward ? this->Transposed : this->Matrix;
  memory.Values.resize(this->Length);
  double* const out = memory.Values.data();
  for (std::size_t line = 0; line < count; ++line)
  {
    double* const in = values + line * lineStride;
    std::fill_n(out, this->Length, 0.0);
    for (std::size_t x = 0; x < this->Length; ++x)
    {
      const double factor = in[x];
      const double* const row = matrix.data() + x * this->Length;
      for (std::size_t k = 0; k < this->Length; ++k)
      {
        out[k] += factor * row[k];
      }
    }
    std::copy_n(out, this->Length, in);
  }
}

//------------------------------------------------------------------------------
void HartleyLines::TransformFast(double* values, std::size_t lineStride, std::size_t stride,
  std::size_t count, bool forward, Memory& memory) const
{
  const auto n = this->Length;
  memory.Values.resize(n * count);
  memory.Complex.resize(4 * n);
  double* const lines = memory.Values.data();
  auto* const in = reinterpret_cast<std::complex<double>*>(memory.Complex.data());
  auto* const out = in + n;
  for (std::size_t i = 0; i < n; ++i)
  {
    for (std::size_t line = 0; line < count; ++line)
    {
      lines[line * n + i] = values[line * lineStride + i * stride];
    }
  }
  // Two real lines at a time form the real and the imaginary parts of a complex line.
  for (std::size_t line = 0; line < count; line += 2)
  {
    double* const first = lines + line * n;
    double* const second = line + 1 < count ? first + n : nullptr;
    if (!forward)
    {
      this->Rotate(first, false);
      if (second)
      {
        this->Rotate(second, false);
      }
    }
    for (std::size_t i = 0; i < n; ++i)
    {
      in[i] = { first[i], second ? second[i] : 0 };
    }
    this->Fast->Forward(in, out);
    for (std::size_t k = 0; k < n; ++k)
    {
      const auto plus = out[k];
      const auto minus = out[k == 0 ? 0 : n - k];
      first[k] = 0.5 * ((plus.real() + minus.real()) - (plus.imag() - minus.imag()));
      if (second)
      {
        second[k] = 0.5 * ((plus.imag() + minus.imag()) + (plus.real() - minus.real()));
      }
    }
    if (forward)
    {
      this->Rotate(first, true);
      if (second)
      {
        this->Rotate(second, true);
      }
    }
  }
  for (std::size_t i = 0; i < n; ++i)
  {
    for (std::size_t line = 0; line < count; ++line)
    {
      values[line * lineStride + i * stride] = lines[line * n + i];
    }
  }
}

//------------------------------------------------------------------------------
/** Moves the origin of the coefficients between the first value and the center. */
void HartleyLines::Rotate(double* values, bool forward) const
{
  const auto n = this->Length;
  values[0] *= this->Cosines[0];
  for (std::size_t k = 1; 2 * k < n; ++k)
  {
    const double plus = values[k];
    const double minus = values[n - k];
    const double c = this->Cosines[k];
    const double s = forward ? -this->Sines[k] : this->Sines[k];
    // The sine is odd.
    values[k] = c * plus + s * minus;
    values[n - k] = c * minus - s * plus;
  }
  if (n % 2 == 0)
  {
    // There is no frequency -n / 2; about the first value, n / 2 has a cosine only.
    values[n / 2] *= this->Cosines[n / 2] - this->Sines[n / 2];
  }
}
}
