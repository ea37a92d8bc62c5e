// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunHartleyFourier.h"

#include "gatunFourier.h"

#include <cmath>
#include <numbers>

namespace gatun
{
namespace
{
//------------------------------------------------------------------------------
std::vector<std::size_t> GetFactors(std::size_t size)
{
  std::vector<std::size_t> factors;
  for (const std::size_t factor : { 4, 2, 3, 5 })
  {
    for (; size % factor == 0; size /= factor)
    {
      factors.push_back(factor);
    }
  }
  for (std::size_t factor = 7; size > 1; factor += 2)
  {
    for (; size % factor == 0; size /= factor)
    {
      factors.push_back(factor);
    }
  }
  return factors;
}

//------------------------------------------------------------------------------
void PutRoot(std::size_t number, std::size_t size, std::vector<float>& to)
{
  const double angle =
    -2 * std::numbers::pi * static_cast<double>(number % size) / static_cast<double>(size);
  to.push_back(static_cast<float>(std::cos(angle)));
  to.push_back(static_cast<float>(std::sin(angle)));
}
}

//------------------------------------------------------------------------------
LaneFourier::LaneFourier(std::size_t size, const HartleyLaneLoops& loops)
  : Size(size)
  , Loops(loops)
{
  std::size_t rest = size;
  std::size_t stride = 1;
  for (const std::size_t radix : GetFactors(size))
  {
    std::vector<float> turns, roots;
    for (std::size_t i = 0; i < rest / radix; ++i)
    {
      for (std::size_t k = 1; k < radix; ++k)
      {
        PutRoot(i * k, rest, turns);
      }
    }
    for (std::size_t k = 0; k < radix; ++k)
    {
      PutRoot(k, radix, roots);
    }
    // The data of a vector stays where it is when the vector is moved.
    this->Stages.push_back({ radix, rest / radix, stride, turns.data(), roots.data() });
    this->Factors.push_back(std::move(turns));
    this->Factors.push_back(std::move(roots));
    rest /= radix;
    stride *= radix;
  }
}

//------------------------------------------------------------------------------
std::size_t GetEvenFastSize(std::size_t size)
{
  return 2 * GetFastSize((size + 1) / 2);
}
}
