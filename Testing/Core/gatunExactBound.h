// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunExactBound_h
#define gatunExactBound_h

// Whether values are within a bound of errors, decided in whole numbers of any length. Nothing of
// it is what the codec checks its values with.

#include "gatunErrorBound.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace gatun::test
{
/** A number: (-1)^Negative * Mantissa * 2^Exponent. */
struct Dyadic
{
  std::uint64_t Mantissa = 0;
  int Exponent = 0;
  bool Negative = false;

  template <typename T>
  static Dyadic Of(T value)
  {
    Dyadic result;
    if constexpr (std::is_floating_point_v<T>)
    {
      const double fraction = std::frexp(static_cast<double>(value), &result.Exponent);
      result.Negative = std::signbit(fraction);
      result.Mantissa = static_cast<std::uint64_t>(std::ldexp(std::abs(fraction), 53));
      result.Exponent -= 53;
    }
    else
    {
      if constexpr (std::is_signed_v<T>)
      {
        result.Negative = value < 0;
      }
      result.Mantissa =
        result.Negative ? 0 - static_cast<std::uint64_t>(value) : static_cast<std::uint64_t>(value);
    }
    return result;
  }
};

/** A sum of products of numbers, without an error. */
class ExactSum
{
public:
  /** Adds l * r, or subtracts it. */
  void Add(const Dyadic& l, const Dyadic& r, bool subtract = false)
  {
    const auto place = static_cast<unsigned>(l.Exponent + r.Exponent + LowestExponent);
    const unsigned shift = place % 32;
    const std::array parts{ (l.Mantissa << shift) & Low, ((l.Mantissa >> (32 - shift)) & Low),
      (l.Mantissa >> 32) >> (32 - shift) };
    const std::array others{ r.Mantissa & Low, r.Mantissa >> 32 };
    const bool isNegative = (l.Negative != r.Negative) != subtract;
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      for (std::size_t k = 0; k < others.size(); ++k)
      {
        const std::uint64_t product = parts[i] * others[k];
        this->AddTo(place / 32 + i + k, product & Low, isNegative);
        this->AddTo(place / 32 + i + k + 1, product >> 32, isNegative);
      }
    }
  }

  void Add(const Dyadic& number, bool subtract = false) { this->Add(number, { 1 }, subtract); }

  /** -1, 0 or 1. */
  int GetSign() const
  {
    std::int64_t carry = 0;
    bool isZero = true;
    for (const auto digit : this->Digits)
    {
      const std::int64_t sum = digit + carry;
      isZero = isZero && (static_cast<std::uint64_t>(sum) & Low) == 0;
      carry = sum >> 32; // rounds down
    }
    return carry < 0 ? -1 : isZero ? 0 : 1;
  }

private:
  static constexpr std::uint64_t Low = 0xffffffff;
  static constexpr int LowestExponent = 2304; // of products of two subnormal numbers, and less

  void AddTo(std::size_t digit, std::uint64_t number, bool isNegative)
  {
    const auto signedNumber = static_cast<std::int64_t>(number);
    this->Digits[digit] += isNegative ? -signedNumber : signedNumber;
  }

  std::array<std::int64_t, 144> Digits{}; // to the base 2^32
};

/** A bound of errors of the values of a component. */
template <typename T>
class ExactBound
{
public:
  /** The values that the range is of. */
  ExactBound(const ErrorBound& bound, const T* values, std::size_t count, std::size_t stride = 1)
    : Bound(bound)
  {
    bool isEmpty = true;
    for (std::size_t i = 0; i < count; ++i)
    {
      const T value = values[i * stride];
      if (IsFinite(value))
      {
        this->Lowest = isEmpty || value < this->Lowest ? value : this->Lowest;
        this->Highest = isEmpty || value > this->Highest ? value : this->Highest;
        isEmpty = false;
      }
    }
    const auto low = static_cast<double>(this->Lowest), high = static_cast<double>(this->Highest);
    const double range = IsExact(low) && IsExact(high) ? high * 0.5 - low * 0.5 : 0;
    this->NearlyAllowed = bound.Kind == ErrorKind::Absolute ? bound.Bound
      : bound.Kind == ErrorKind::Relative                   ? 2 * (bound.Bound * range)
                                                            : 0;
  }

  /** Whether found may stand for original. */
  bool IsWithin(T original, T found) const
  {
    if (std::memcmp(&original, &found, sizeof(T)) == 0)
    {
      return true;
    }
    if (!this->Bound || !IsFinite(original) || !IsFinite(found) ||
      (original == 0 && this->Bound.KeepZeros))
    {
      return false;
    }
    return this->IsClearlyWithin(original, found) ||
      this->Compare(Dyadic::Of(original), Dyadic::Of(found), original < found) <= 0;
  }

private:
  static bool IsFinite(T value)
  {
    if constexpr (std::is_floating_point_v<T>)
    {
      return std::isfinite(value);
    }
    return true;
  }

  /** Whether a value became a number without a rounding error. */
  static bool IsExact(double number)
  {
    return std::is_floating_point_v<T> || std::abs(number) < 1e15;
  }

  /** What most values are, where rounding errors cannot matter. */
  bool IsClearlyWithin(T original, T found) const
  {
    constexpr double less = 1 - 1e-9;
    const auto x = static_cast<double>(original), y = static_cast<double>(found);
    const double allowed = this->Bound.Kind == ErrorKind::Pointwise
      ? this->Bound.Bound * std::abs(x)
      : this->NearlyAllowed;
    return allowed > 1e-280 && std::abs(x - y) < allowed * less && IsExact(x) && IsExact(y);
  }

  /** The sign of |original - found| - what is allowed. */
  int Compare(const Dyadic& original, const Dyadic& found, bool isMore) const
  {
    ExactSum sum;
    sum.Add(original, isMore);
    sum.Add(found, !isMore);
    switch (this->Bound.Kind)
    {
      case ErrorKind::Relative:
        sum.Add(Dyadic::Of(this->Bound.Bound), Dyadic::Of(this->Highest), true);
        sum.Add(Dyadic::Of(this->Bound.Bound), Dyadic::Of(this->Lowest), false);
        break;
      case ErrorKind::Pointwise:
        sum.Add(Dyadic::Of(this->Bound.Bound), { original.Mantissa, original.Exponent }, true);
        break;
      case ErrorKind::Bits:
      {
        // Half a unit of the last significant digit: 2^(e - bits) of a magnitude from 2^e.
        if (original.Mantissa == 0)
        {
          return 1;
        }
        int exponent = original.Exponent;
        for (auto rest = original.Mantissa; rest > 1; rest >>= 1)
        {
          ++exponent;
        }
        sum.Add({ 1, exponent - static_cast<int>(this->Bound.Bound) }, true);
        break;
      }
      default:
        sum.Add(Dyadic::Of(this->Bound.Bound), true);
    }
    return sum.GetSign();
  }

  ErrorBound Bound;
  T Lowest{};
  T Highest{};
  double NearlyAllowed = 0;
};
}

#endif
