// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunHartleyKernelFunction.h"

#include "gatunBessel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gatun
{
//------------------------------------------------------------------------------
KaiserBessel::KaiserBessel(std::size_t values, std::size_t points)
  : Points(static_cast<double>(points))
{
  const double oversampling = this->Points / static_cast<double>(values);
  const double reach = Taps / oversampling * (oversampling - 0.5);
  this->Shape = std::numbers::pi * std::sqrt(std::max(reach * reach - 0.8, 1.0));
  this->Table.resize((Steps + 1) * Stored);
  for (std::size_t step = 0; step <= Steps; ++step)
  {
    const double part = static_cast<double>(step) / Steps;
    for (int tap = 0; tap < Taps; ++tap)
    {
      const double x = (part - (tap - Taps / 2 + 1)) / (Taps / 2.0);
      const double inside = std::max(1 - x * x, 0.0);
      this->Table[step * Stored + static_cast<std::size_t>(tap)] =
        static_cast<float>(GetBessel(this->Shape * std::sqrt(inside)) * (x * x <= 1));
    }
  }
}

//------------------------------------------------------------------------------
double KaiserBessel::GetTransform(double place) const
{
  const double angle = std::numbers::pi * Taps * place / this->Points;
  const double square = this->Shape * this->Shape - angle * angle;
  const double root = std::sqrt(std::abs(square));
  if (root < 1e-9)
  {
    return Taps;
  }
  return Taps * (square > 0 ? std::sinh(root) : std::sin(root)) / root;
}
}
