// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunFourier.h"

#include <vtk_kissfft.h>
// clang-format off
#include VTK_KISSFFT_HEADER(kiss_fft.h)
#include VTK_KISSFFT_HEADER(tools/kiss_fftndr.h)
// clang-format on

#include <new>
#include <type_traits>

namespace gatun
{
static_assert(std::is_same_v<kiss_fft_scalar, double>, "VTK's KissFFT works in double precision");

namespace
{
//------------------------------------------------------------------------------
template <typename Plan>
Plan* Check(Plan* plan)
{
  if (!plan)
  {
    throw std::bad_alloc();
  }
  return plan;
}
}

//------------------------------------------------------------------------------
FourierTransform::FourierTransform(std::size_t size)
  : Plan(Check(kiss_fft_alloc(static_cast<int>(size), 0, nullptr, nullptr)))
{
}

//------------------------------------------------------------------------------
FourierTransform::~FourierTransform() = default;

//------------------------------------------------------------------------------
void FourierTransform::Free::operator()(void* plan) const
{
  kiss_fft_free(plan);
}

//------------------------------------------------------------------------------
void FourierTransform::Forward(const std::complex<double>* in, std::complex<double>* out) const
{
  kiss_fft(static_cast<kiss_fft_cfg>(this->Plan.get()), reinterpret_cast<const kiss_fft_cpx*>(in),
    reinterpret_cast<kiss_fft_cpx*>(out));
}

//------------------------------------------------------------------------------
InversePlaneTransform::InversePlaneTransform(std::size_t height, std::size_t width)
{
  const int sizes[2] = { static_cast<int>(height), static_cast<int>(width) };
  this->Plan.reset(Check(kiss_fftndr_alloc(sizes, 2, 1, nullptr, nullptr)));
}

//------------------------------------------------------------------------------
InversePlaneTransform::~InversePlaneTransform() = default;

//------------------------------------------------------------------------------
void InversePlaneTransform::Free::operator()(void* plan) const
{
  kiss_fftndr_free(plan);
}

//------------------------------------------------------------------------------
void InversePlaneTransform::Run(std::complex<double>* in, double* out)
{
  kiss_fftndri(
    static_cast<kiss_fftndr_cfg>(this->Plan.get()), reinterpret_cast<const kiss_fft_cpx*>(in), out);
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
