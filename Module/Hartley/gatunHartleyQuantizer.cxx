// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunHartleyQuantizer.h"

#include <algorithm>
#include <cmath>

namespace gatun
{
namespace
{
// Added before rounding down. Values between two integers are more often near the smaller one,
// which also takes fewer bits.
constexpr double RoundingOfOne = 0.30;
constexpr double RoundingOfMore = 0.42;

// Files store shifts as multiples of this.
constexpr double ShiftUnit = 1.0 / 256;

constexpr double Largest = 4611686018427387904.0; // 2^62

/** The square of a frequency along an axis, in periods per voxel. */
double GetSquare(std::uint32_t index, std::uint32_t size)
{
  const double k =
    2 * index <= size ? static_cast<double>(index) : static_cast<double>(index) - size;
  return k / size * (k / size);
}
}

//------------------------------------------------------------------------------
HartleyQuantizer::HartleyQuantizer(const HartleyLayout::Triple& block, const HartleySteps& steps)
  : Steps(steps)
{
  if (steps.Weight == 0)
  {
    return;
  }
  this->PerIndex.reserve(std::size_t{ block[0] } * block[1] * block[2]);
  constexpr double most = 3 * 0.25; // half a period per voxel along each axis
  for (std::uint32_t w = 0; w < block[2]; ++w)
  {
    for (std::uint32_t v = 0; v < block[1]; ++v)
    {
      for (std::uint32_t u = 0; u < block[0]; ++u)
      {
        const double square =
          GetSquare(u, block[0]) + GetSquare(v, block[1]) + GetSquare(w, block[2]);
        this->PerIndex.push_back(steps.Step * (1 + steps.Weight * (square / most)));
      }
    }
  }
}

//------------------------------------------------------------------------------
void HartleyQuantizer::Quantize(
  std::span<const double> coefficients, std::span<std::int64_t> integers) const
{
  const auto round = [](double value)
  {
    // Faster than lround(), which reads the rounding mode.
    const double size = std::min(std::abs(value) + 0.5, Largest);
    const auto integer = static_cast<std::int64_t>(size);
    return value < 0 ? -integer : integer;
  };
  const auto roundDown = [](double value)
  {
    const double size = std::min(std::abs(value), Largest);
    const double rounding = size < 2 - RoundingOfOne ? RoundingOfOne : RoundingOfMore;
    const auto integer = static_cast<std::int64_t>(size + rounding);
    return value < 0 ? -integer : integer;
  };
  const bool nearest = this->Steps.Nearest;
  if (this->PerIndex.empty())
  {
    const double factor = 1 / this->Steps.Step;
    for (std::size_t i = 0; i < integers.size(); ++i)
    {
      const double value = coefficients[i] * factor;
      integers[i] = nearest || i == 0 ? round(value) : roundDown(value);
    }
    return;
  }
  for (std::size_t i = 0; i < integers.size(); ++i)
  {
    const double value = coefficients[i] / this->PerIndex[i];
    integers[i] = nearest || i == 0 ? round(value) : roundDown(value);
  }
}

//------------------------------------------------------------------------------
void HartleyQuantizer::Restore(
  std::span<const std::int64_t> integers, std::span<double> coefficients) const
{
  for (std::size_t i = 0; i < integers.size(); ++i)
  {
    coefficients[i] = this->Restore(i, integers[i]);
  }
}

//------------------------------------------------------------------------------
void HartleyShiftSums::Add(const HartleyQuantizer& quantizer, std::span<const double> coefficients,
  std::span<const std::int64_t> integers)
{
  for (std::size_t i = 1; i < integers.size(); ++i)
  {
    if (integers[i] != 0)
    {
      const auto size = std::abs(integers[i]);
      const auto kind = static_cast<std::size_t>(std::min<std::int64_t>(size, 3) - 1);
      this->Sums[kind] +=
        static_cast<double>(size) - std::abs(coefficients[i]) / quantizer.GetStep(i);
      ++this->Counts[kind];
    }
  }
}

//------------------------------------------------------------------------------
void HartleyShiftSums::Add(const HartleyShiftSums& other)
{
  for (std::size_t kind = 0; kind < this->Sums.size(); ++kind)
  {
    this->Sums[kind] += other.Sums[kind];
    this->Counts[kind] += other.Counts[kind];
  }
}

//------------------------------------------------------------------------------
std::array<double, 3> HartleyShiftSums::Get() const
{
  std::array<double, 3> shifts{};
  for (std::size_t kind = 0; kind < shifts.size(); ++kind)
  {
    if (this->Counts[kind] > 0)
    {
      const double mean = this->Sums[kind] / static_cast<double>(this->Counts[kind]);
      shifts[kind] = ShiftUnit * std::round(std::clamp(mean, -0.5, 0.5) / ShiftUnit);
    }
  }
  return shifts;
}
}
