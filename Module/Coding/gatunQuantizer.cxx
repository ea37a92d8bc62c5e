// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunQuantizer.h"

#include "gatunWithType.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace gatun
{
namespace
{
constexpr double MaxIndex = 2251799813685248; // 2^51: sums of indices are exact
constexpr double Infinity = std::numeric_limits<double>::infinity();

Key MakeMask(ScalarType type)
{
  return ~Key{ 0 } >> (64 - 8 * SizeOf(type));
}

double RoundHalfAway(double number)
{
  return number < 0 ? -std::floor(0.5 - number) : std::floor(number + 0.5);
}

std::uint64_t Distance(Key l, Key r)
{
  return l < r ? r - l : l - r;
}

int GetMantissaBits(ScalarType type)
{
  return type == ScalarType::Float32 ? 23 : 52;
}

/** a - b - difference, where that is a - b rounded (two-sum). */
double GetDifferenceError(double a, double b, double difference)
{
  const double part = difference - a;
  return (a - (difference - part)) + (-b - part);
}

/** The next number down, if there is any error that was rounded up. */
double RoundDown(double number, double error)
{
  return error < 0 ? std::nextafter(number, -Infinity) : number;
}

/** l * r - product, where that is l * r rounded (Dekker). Neither overflows nor underflows. */
double GetProductError(double l, double r, double product)
{
  constexpr double split = 134217729; // 2^27 + 1
  const auto getHigh = [](double number)
  {
    const double large = split * number;
    return large - (large - number);
  };
  const double lHigh = getHigh(l), lLow = l - lHigh;
  const double rHigh = getHigh(r), rLow = r - rHigh;
  return ((lHigh * rHigh - product) + lHigh * rLow + lLow * rHigh) + lLow * rLow;
}

/** bound * (high - low), rounded down at every step. Numbers are scaled to be around 1, as the
 * rounding errors of subnormal ones are as large as the numbers. */
double GetPartOfRange(double bound, double low, double high)
{
  int boundExponent = 0;
  int exponent = 0;
  const double fraction = std::frexp(bound, &boundExponent);
  std::frexp(std::max(std::abs(low), std::abs(high)), &exponent);
  const double highest = std::ldexp(high, -exponent);
  const double lowest = std::ldexp(low, -exponent);
  // What is too small to be scaled counts as the next number towards the other one.
  const auto isChanged = [&](double number, double scaled)
  { return std::ldexp(scaled, exponent) != number; };
  double range = highest - lowest;
  range = RoundDown(range, GetDifferenceError(highest, lowest, range));
  if (isChanged(high, highest) || isChanged(low, lowest))
  {
    range = std::nextafter(range, -Infinity);
  }
  const double product = fraction * range;
  const double part = RoundDown(product, GetProductError(fraction, range, product));
  const double result = std::ldexp(part, exponent + boundExponent);
  return RoundDown(result, part - std::ldexp(result, -exponent - boundExponent));
}
}

//------------------------------------------------------------------------------
void FiniteRange::Add(ScalarType type, const void* values, std::size_t count,
  std::size_t components, std::size_t component)
{
  WithType(type, values,
    [&](const auto* typed)
    {
      for (std::size_t i = 0; i < count; ++i)
      {
        const auto number = static_cast<double>(typed[i * components + component]);
        if (std::isfinite(number))
        {
          this->Include(number);
        }
      }
    });
}

//------------------------------------------------------------------------------
bool IsClose(double a, double b, double bound)
{
  const double difference = a - b;
  if (std::abs(difference) != bound)
  {
    return std::abs(difference) < bound;
  }
  // The rounding error of the difference decides.
  const double error = GetDifferenceError(a, b, difference);
  return difference < 0 ? error >= 0 : error <= 0;
}

//------------------------------------------------------------------------------
double GetNumberIndex(double number, double width)
{
  const double index = RoundHalfAway(number / width);
  return std::abs(index) < MaxIndex ? index : 0;
}

//------------------------------------------------------------------------------
std::int64_t GetKeyIndex(Key key, Key zero, std::uint64_t step)
{
  const auto distance = Distance(key, zero);
  const auto index =
    distance / step + (distance % step > (step - 1) / 2 ? std::uint64_t{ 1 } : std::uint64_t{ 0 });
  return static_cast<std::int64_t>(key < zero ? 0 - index : index);
}

//------------------------------------------------------------------------------
bool Quantizer::IsValid(ScalarType type) const
{
  const auto kind = this->Bound.Kind;
  if (kind < ErrorKind::Absolute || kind > ErrorKind::Bits || !(this->Bound.Bound > 0) ||
    !std::isfinite(this->Bound.Bound) || !(this->Reached >= 0))
  {
    return false;
  }
  if (!this->RoundsKeys(type))
  {
    return this->Step > 0 && std::isfinite(2 * this->Step);
  }
  // Keys are integers, and pointwise bounds are for floating types only.
  const bool hasMeasure = IsFloating(type) || kind <= ErrorKind::Relative;
  return hasMeasure && this->Step >= 2 && this->Step <= MaxKeyStep &&
    this->Step == std::floor(this->Step) && static_cast<Key>(this->Step) <= MakeMask(type);
}

//------------------------------------------------------------------------------
double Quantizer::GetAllowed(ScalarType type) const
{
  switch (this->Bound.Kind)
  {
    case ErrorKind::Pointwise:
      return this->Bound.Bound;
    case ErrorKind::Bits:
      return std::ldexp(1.0, -static_cast<int>(this->Bound.Bound));
    default:
      return IsFloating(type) ? this->Step : std::floor((this->Step - 1) / 2);
  }
}

//------------------------------------------------------------------------------
bool Quantizer::IsWithin(ScalarType type, Key original, Key stored) const
{
  if (original == stored)
  {
    return true;
  }
  const double allowed = this->GetAllowed(type);
  const Key zero = PlainKeys::FromNumber(type, 0);
  if (!IsFloating(type))
  {
    return !(this->Bound.KeepZeros && original == zero) &&
      Distance(original, stored) <= static_cast<Key>(allowed);
  }
  const double x = PlainKeys::PlainToNumber(type, original);
  const double y = PlainKeys::PlainToNumber(type, stored);
  if (!std::isfinite(x) || !std::isfinite(y) || (x == 0 && this->Bound.KeepZeros))
  {
    return false;
  }
  switch (this->Bound.Kind)
  {
    case ErrorKind::Pointwise:
    {
      // The product is rounded; a little less than it is surely allowed, but for subnormal ones.
      constexpr double less = 1 - 4 * std::numeric_limits<double>::epsilon();
      const double most = allowed * std::abs(x) * less;
      return most > 1e-290 && std::abs(x - y) <= most;
    }
    case ErrorKind::Bits:
      return x != 0 && IsClose(x, y, std::ldexp(allowed, std::ilogb(x)));
    default:
      return IsClose(x, y, allowed);
  }
}

//------------------------------------------------------------------------------
double Quantizer::Measure(ScalarType type, Key original, Key stored) const
{
  if (original == stored)
  {
    return 0;
  }
  if (!IsFloating(type))
  {
    return static_cast<double>(Distance(original, stored));
  }
  const double x = PlainKeys::PlainToNumber(type, original);
  const double error = std::abs(x - PlainKeys::PlainToNumber(type, stored));
  if (!std::isfinite(error))
  {
    return Infinity;
  }
  switch (this->Bound.Kind)
  {
    case ErrorKind::Pointwise:
      return error == 0 ? 0 : error / std::abs(x);
    case ErrorKind::Bits:
      return error == 0 ? 0 : x == 0 ? Infinity : std::ldexp(error, -std::ilogb(x));
    default:
      return error;
  }
}

//------------------------------------------------------------------------------
Key Quantizer::ToLattice(ScalarType type, Key original) const
{
  const Key zero = PlainKeys::FromNumber(type, 0);
  if (this->RoundsKeys(type))
  {
    const auto step = static_cast<std::uint64_t>(this->Step);
    const Key mask = MakeMask(type);
    const Key place = GetIndexKey(GetKeyIndex(original, zero, step), zero, step);
    // A place beyond the first or last key would wrap around.
    return place <= mask && (place < zero) == (original < zero) && place != original &&
        this->IsWithin(type, original, place)
      ? place
      : original;
  }
  const double number = PlainKeys::PlainToNumber(type, original);
  if (!std::isfinite(number))
  {
    return original;
  }
  const double width = 2 * this->Step;
  const double index = GetNumberIndex(number, width);
  for (const double other : std::array{ index, index + 1, index - 1 })
  {
    const Key place = PlainKeys::FromNumber(type, other * width);
    if (this->IsWithin(type, original, place))
    {
      return place;
    }
  }
  return original;
}

//------------------------------------------------------------------------------
Quantizer MakeQuantizer(ScalarType type, const ErrorBound& bound, const FiniteRange& range)
{
  Quantizer result;
  result.Bound = bound;
  double most = bound.Bound;
  if (bound.Kind == ErrorKind::Relative)
  {
    most = range.IsEmpty() ? 0 : GetPartOfRange(bound.Bound, range.Low, range.High);
  }
  const auto bits = GetMantissaBits(type);
  if (!result.RoundsKeys(type))
  {
    result.Step = std::min(most, std::numeric_limits<double>::max() / 4);
  }
  else if (!IsFloating(type))
  {
    // Large integers were rounded when they became numbers.
    const bool isRounded = bound.Kind == ErrorKind::Relative &&
      std::max(std::abs(range.Low), std::abs(range.High)) >= Quantizer::MaxKeyStep;
    const double whole = std::floor(isRounded ? std::max(0.0, most - 4096) : most);
    const double end =
      std::min(Quantizer::MaxKeyStep / 4, std::ldexp(1.0, static_cast<int>(8 * SizeOf(type)) - 3));
    result.Step = 2 * std::min(whole, end) + 1;
  }
  else if (bound.Kind == ErrorKind::Bits)
  {
    result.Step = std::ldexp(1.0, bits + 1 - static_cast<int>(bound.Bound));
  }
  else
  {
    const double half = std::floor(std::ldexp(bound.Bound, bits));
    result.Step = 2 * half + 1;
  }
  return result.IsValid(type) ? result : Quantizer();
}
}
