// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunFourier.h"

#include <kissfft.hh>

#include <numbers>
#include <vector>

namespace gatun
{
namespace
{
using Complex = std::complex<double>;
using Plan = kissfft<double>;
}

//------------------------------------------------------------------------------
struct FourierTransform::Internals
{
  Plan Whole;
  bool IsShared; // whether several threads may use the plan: other factors need its memory
};

//------------------------------------------------------------------------------
FourierTransform::FourierTransform(std::size_t size)
  : Self(new Internals{ Plan(size, false), GetFastSize(size) == size })
{
}

//------------------------------------------------------------------------------
FourierTransform::~FourierTransform() = default;

//------------------------------------------------------------------------------
void FourierTransform::Forward(const Complex* in, Complex* out) const
{
  if (this->Self->IsShared)
  {
    this->Self->Whole.transform(in, out);
    return;
  }
  const Plan own = this->Self->Whole;
  own.transform(in, out);
}

//------------------------------------------------------------------------------
struct InversePlaneTransform::Internals
{
  Internals(std::size_t height, std::size_t width)
    : Columns(height, true)
    , Rows(width / 2, true)
    , Height(height)
    , Half(width / 2)
    , In(height)
    , Out(height)
    , Twiddles(width / 2)
  {
    for (std::size_t u = 0; u < this->Half; ++u)
    {
      this->Twiddles[u] =
        std::polar(1., std::numbers::pi * static_cast<double>(u) / static_cast<double>(this->Half));
    }
  }

  void TransformColumn(Complex* first)
  {
    const std::size_t stride = this->Half + 1;
    for (std::size_t v = 0; v < this->Height; ++v)
    {
      this->In[v] = first[v * stride];
    }
    this->Columns.transform(this->In.data(), this->Out.data());
    for (std::size_t v = 0; v < this->Height; ++v)
    {
      first[v * stride] = this->Out[v];
    }
  }

  /** The even and the odd values of a row are the real and imaginary parts of a row of half the
   * size, whose spectrum this makes of that of the row. */
  void TransformRow(Complex* row, double* out)
  {
    for (std::size_t u = 0; u <= this->Half / 2; ++u)
    {
      const auto here = row[u];
      const auto there = std::conj(row[this->Half - u]);
      const auto even = here + there;
      const auto odd = (here - there) * this->Twiddles[u];
      const Complex turned{ -odd.imag(), odd.real() };
      row[u] = even + turned;
      if (u > 0)
      {
        row[this->Half - u] = std::conj(even - turned);
      }
    }
    this->Rows.transform(row, reinterpret_cast<Complex*>(out));
  }

  const Plan Columns;
  const Plan Rows;
  const std::size_t Height;
  const std::size_t Half;
  std::vector<Complex> In, Out;
  std::vector<Complex> Twiddles;
};

//------------------------------------------------------------------------------
InversePlaneTransform::InversePlaneTransform(std::size_t height, std::size_t width)
  : Self(std::make_unique<Internals>(height, width))
{
}

//------------------------------------------------------------------------------
InversePlaneTransform::~InversePlaneTransform() = default;

//------------------------------------------------------------------------------
void InversePlaneTransform::Run(Complex* in, double* out)
{
  auto& self = *this->Self;
  for (std::size_t u = 0; u <= self.Half; ++u)
  {
    self.TransformColumn(in + u);
  }
  for (std::size_t v = 0; v < self.Height; ++v)
  {
    self.TransformRow(in + v * (self.Half + 1), out + v * 2 * self.Half);
  }
}

//------------------------------------------------------------------------------
std::size_t GetFastSize(std::size_t size)
{
  for (;; ++size)
  {
    auto rest = size;
    for (const std::size_t factor : { 2u, 3u, 5u })
    {
      while (rest > 0 && rest % factor == 0)
      {
        rest /= factor;
      }
    }
    if (rest == 1)
    {
      return size;
    }
  }
}
}
