// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunExtremeValues_h
#define gatunExtremeValues_h

// Values that are hard to round, and bounds for them.

#include "gatunErrorBound.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <type_traits>
#include <vector>

namespace gatun::test
{
constexpr std::array ExtremePatterns{ "smooth", "subnormal", "subnormal and smooth",
  "any magnitude", "alternating signs", "subnormal and alternating", "NaN and infinities",
  "decimals", "constants", "near overflow", "narrow range", "zeros of both signs", "any bits",
  "jumps", "ties" };

/** Makes values of a pattern. T: a type of arrays. */
template <typename T>
class ExtremeValues
{
public:
  explicit ExtremeValues(std::mt19937_64& random)
    : Random(random)
  {
  }

  void Fill(std::size_t pattern, std::vector<T>& values)
  {
    this->Frequency = 0.001 + 0.2 * this->Unit();
    this->Size = std::ldexp(1.0, static_cast<int>(this->Below(60)) - 30);
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      if constexpr (std::is_floating_point_v<T>)
      {
        values[i] = this->MakeFloating(pattern, i);
      }
      else
      {
        values[i] = this->MakeWhole(pattern, i);
      }
    }
  }

private:
  using Limits = std::numeric_limits<T>;
  using Word = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;

  std::uint64_t Below(std::uint64_t end) { return this->Random() % end; }
  double Unit() { return static_cast<double>(this->Below(1u << 30)) / (1u << 30); }
  double Smooth(std::size_t i) const
  {
    return std::sin(this->Frequency * static_cast<double>(i)) + 0.3;
  }

  T MakeFloating(std::size_t pattern, std::size_t i)
  {
    const double sign = i % 2 ? -1 : 1;
    const double tiny = static_cast<double>(Limits::denorm_min());
    switch (pattern)
    {
      case 1:
        return static_cast<T>(sign * tiny * static_cast<double>(this->Below(1000)));
      case 2:
        return static_cast<T>(std::floor(1e4 * this->Smooth(i)) * tiny);
      case 3:
      {
        const auto exponents =
          static_cast<std::uint64_t>(Limits::max_exponent - Limits::min_exponent + 20);
        const auto exponent = static_cast<int>(this->Below(exponents)) + Limits::min_exponent - 20;
        return static_cast<T>(sign * std::ldexp(0.5 + 0.4 * this->Unit(), exponent));
      }
      case 4:
        return static_cast<T>(sign * this->Size * (1 + 1e-4 * this->Unit()));
      case 5:
        return static_cast<T>(sign * tiny * static_cast<double>((1u << 20) + this->Below(50)));
      case 6:
        return this->MakeStrange(i);
      case 7:
        return static_cast<T>(std::floor(1e4 * this->Smooth(i)) / 100);
      case 8:
        return static_cast<T>(this->Below(5000) == 0 ? this->Size * 1.5 : this->Size);
      case 9:
        return static_cast<T>(Limits::max() * static_cast<T>(sign * (1 - 1e-3 * this->Unit())));
      case 10:
        return static_cast<T>(1 + static_cast<T>(this->Below(64)) * Limits::epsilon());
      case 11:
        return static_cast<T>(this->Below(3) ? sign * 0.0 : 1e-3 * this->Smooth(i));
      case 12:
        return this->MakeAny();
      case 13:
        return static_cast<T>(this->Size * (this->Smooth(i) + (this->Below(40) ? 0 : 1e6)));
      case 14: // multiples of what steps of a power of 2 lie between
        return static_cast<T>(this->Size * (0.5 + static_cast<double>(this->Below(256)) / 256));
      default:
        return static_cast<T>(this->Size * this->Smooth(i));
    }
  }

  T MakeAny() { return std::bit_cast<T>(static_cast<Word>(this->Random())); }

  T MakeStrange(std::size_t i)
  {
    if (this->Below(4) > 0)
    {
      return static_cast<T>(this->Smooth(i));
    }
    const auto which = this->Below(3);
    const Word infinity = std::bit_cast<Word>(Limits::infinity());
    const Word sign = static_cast<Word>(static_cast<Word>(this->Below(2)) << (8 * sizeof(T) - 1));
    const Word payload = static_cast<Word>(which == 0 ? 0
        : which == 1                                  ? 1 + i % 7
                                                      : this->Random());
    return std::bit_cast<T>(static_cast<Word>(sign | infinity | (payload & (~infinity >> 1))));
  }

  T MakeWhole(std::size_t pattern, std::size_t i)
  {
    using Unsigned = std::make_unsigned_t<T>;
    const auto middle = static_cast<Unsigned>(Limits::max() / 2);
    const double part = pattern % 2 ? 0.45 : 1e-3;
    const auto smooth =
      static_cast<std::int64_t>(static_cast<double>(middle) * part * (this->Smooth(i) - 0.3) * 0.9);
    switch (pattern)
    {
      case 3:
      case 12:
        return static_cast<T>(this->Random());
      case 8:
        return static_cast<T>(this->Below(5000) == 0 ? 90 : 7);
      case 9:
        return static_cast<T>(i % 2 ? Limits::max() - static_cast<T>(this->Below(40))
                                    : Limits::min() + static_cast<T>(this->Below(40)));
      case 10:
        return static_cast<T>(Limits::max() - static_cast<T>(this->Below(100)));
      case 11:
        return static_cast<T>(this->Below(3) ? 0 : this->Below(50));
      default:
        return static_cast<T>(middle + static_cast<Unsigned>(smooth));
    }
  }

  std::mt19937_64& Random;
  double Frequency = 0;
  double Size = 1;
};

/** A bound of a kind, large or tiny. The absolute ones of floating types are around a size. */
template <typename T>
ErrorBound MakeExtremeBound(ErrorKind kind, double size, std::mt19937_64& random)
{
  constexpr std::array simple{ 1.0, 0.5, 0.25, 0.125, 0.1, 1.0 / 3, 1e-3, 0x1p-20 };
  const auto below = [&](std::uint64_t end) { return static_cast<int>(random() % end); };
  ErrorBound bound{ kind, 0, random() % 3 == 0 };
  const double fraction = random() % 2
    ? simple[random() % simple.size()]
    : std::pow(10.0, -0.3 - 0.01 * static_cast<double>(below(1600)));
  switch (kind)
  {
    case ErrorKind::Bits:
      bound.Bound = 1 + below(52);
      break;
    case ErrorKind::Absolute:
      bound.Bound = std::is_floating_point_v<T> ? fraction * size : std::floor(1 / fraction) * 1.5;
      break;
    default:
      bound.Bound = fraction;
  }
  if (kind == ErrorKind::Pointwise)
  {
    bound.Bound *= 0.99;
  }
  const bool isSmall = bound.Bound < std::numeric_limits<double>::denorm_min();
  bound.Bound = isSmall ? std::numeric_limits<double>::denorm_min() : bound.Bound;
  return bound;
}
}

#endif
