// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunProgression.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace gatun
{
namespace
{
/** How far a number may be from the value that it is rounded to, at most. */
double GetRoundingError(ScalarType type, double value)
{
  if (type == ScalarType::Float64)
  {
    return std::nextafter(std::abs(value), std::numeric_limits<double>::infinity()) -
      std::abs(value);
  }
  const auto size = static_cast<float>(std::abs(value));
  return 0.5 *
    (static_cast<double>(std::nextafter(size, std::numeric_limits<float>::infinity())) - size);
}

/** The number with the fewest digits well within an interval: what was meant is likely to be short,
 * and the ends of the interval are where values are rounded the other way. */
double FindShortest(double low, double high)
{
  constexpr int digits = 52;
  const double middle = low + 0.5 * (high - low);
  const double margin = 0.25 * (high - low);
  for (int kept = 0; kept < digits; ++kept)
  {
    const double unit = std::ldexp(1.0, std::ilogb(middle) - kept);
    const double rounded = std::floor(middle / unit + 0.5) * unit;
    if (rounded >= low + margin && rounded <= high - margin)
    {
      return rounded;
    }
  }
  return middle;
}

/** The places of some values on a lattice of an unknown step, and bounds of the step. */
class StepSearch
{
public:
  /** least: the least distance of values, about one step. */
  StepSearch(double first, double least, double error)
    : First(first)
    , Low(least - error)
    , High(least + error)
  {
  }

  /** Adds the next value. Returns false if no step fits, or if its place is not certain. */
  bool Add(double value, double error)
  {
    const double middle = 0.5 * (this->Low + this->High);
    const double steps = std::floor((value - this->Last) / middle + 0.5);
    if (!(this->Low > 0) || !(steps >= 1) || !(steps * (this->High - this->Low) < 0.5 * middle))
    {
      return false;
    }
    this->Place += steps;
    this->Last = value;
    this->Low = std::max(this->Low, (value - this->First - error) / this->Place);
    this->High = std::min(this->High, (value - this->First + error) / this->Place);
    return this->Low <= this->High;
  }

  const double First;
  double Low, High; // of the step
  double Place = 0; // of the last value
  double Last = First;
};
}

//------------------------------------------------------------------------------
bool Progression::IsWithin(ScalarType type) const
{
  const double largest = type == ScalarType::Float64 ? std::numeric_limits<double>::max()
                                                     : std::numeric_limits<float>::max();
  const double last = this->Origin + static_cast<double>(this->Count - 1) * this->Step;
  return this->Step > 0 && std::abs(this->Origin) <= largest && std::abs(last) <= largest;
}

//------------------------------------------------------------------------------
Palette Progression::MakeKeys(ScalarType type) const
{
  Palette keys(this->Count);
  for (std::size_t i = 0; i < keys.size(); ++i)
  {
    keys[i] = PlainKeys::RoundToFloating(type, this->Origin + static_cast<double>(i) * this->Step);
  }
  return keys;
}

//------------------------------------------------------------------------------
std::optional<Progression> FitProgression(
  ScalarType type, std::span<const Key> keys, std::size_t most)
{
  const auto value = [&](std::size_t i) { return Domain::PlainToNumber(type, keys[i]); };
  if (keys.size() < 2 || keys.size() > most || !std::isfinite(value(0)) ||
    !std::isfinite(value(keys.size() - 1)))
  {
    return std::nullopt;
  }
  double least = std::numeric_limits<double>::infinity();
  double error = 0;
  for (std::size_t i = 1; i < keys.size(); ++i)
  {
    const double gap = value(i) - value(i - 1);
    if (gap < least)
    {
      least = gap;
      error = GetRoundingError(type, value(i)) + GetRoundingError(type, value(i - 1));
    }
  }
  // The first values are close to each other, so that the bounds narrow before large gaps come.
  StepSearch search(value(0), least, error);
  for (std::size_t i = 1; i < keys.size(); ++i)
  {
    if (!search.Add(value(i), GetRoundingError(type, value(i))))
    {
      return std::nullopt;
    }
  }
  if (!(search.Place < static_cast<double>(most)))
  {
    return std::nullopt;
  }
  const Progression result{ value(0), FindShortest(search.Low, search.High),
    static_cast<std::size_t>(search.Place) + 1 };
  if (!result.IsWithin(type))
  {
    return std::nullopt;
  }
  const auto all = result.MakeKeys(type);
  const bool ascends =
    std::adjacent_find(all.begin(), all.end(), std::greater_equal<>()) == all.end();
  return ascends && std::includes(all.begin(), all.end(), keys.begin(), keys.end())
    ? std::optional(result)
    : std::nullopt;
}
}
