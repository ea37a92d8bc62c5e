// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunLanes_h
#define gatunLanes_h

// Vectors of numbers. Lanes are independent, and floats are IEEE 754 binary32, so that results do
// not depend on the registers of the processor.

#include "gatunInline.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace gatun
{
#if defined(__GNUC__)
using Float4 = float __attribute__((vector_size(16)));
using Int4 = std::int32_t __attribute__((vector_size(16)));
using UInt4 = std::uint32_t __attribute__((vector_size(16)));
using Short8 = std::int16_t __attribute__((vector_size(16)));

/** a in lanes where l > r, else b. */
GATUN_INLINE Float4 SelectGreater(Float4 l, Float4 r, Float4 a, Float4 b)
{
  return l > r ? a : b;
}

/** The first three lanes, and 0 in the last one, regardless of its bits. */
GATUN_INLINE Float4 KeepThree(Float4 v)
{
  using Bits = std::int32_t __attribute__((vector_size(16)));
  return std::bit_cast<Float4>(std::bit_cast<Bits>(v) & Bits{ -1, -1, -1, 0 });
}

/** The number of lanes of low and high that are not above a number. */
GATUN_INLINE unsigned CountUpTo(Short8 low, Short8 high, std::int16_t number)
{
  const auto all =
    std::bit_cast<std::array<std::uint64_t, 2>>(-((low <= number) + (high <= number)));
  return static_cast<unsigned>(((all[0] + all[1]) * 0x0001000100010001u) >> 48);
}

/** The least number of a sequence that comes in groups of four, and its position. The first one of
 * equal numbers counts. NaN and infinity never do. */
class LeastOfGroups
{
public:
  /** Compares the next group, whose lanes are at first, first + 1, ... */
  GATUN_INLINE void Compare(Float4 numbers, std::int32_t first)
  {
    const Int4 better = numbers < this->Numbers;
    this->Numbers = better ? numbers : this->Numbers;
    this->Positions = better ? Int4{ 0, 1, 2, 3 } + first : this->Positions;
  }

  /** The position of the least number, or -1. */
  std::int32_t GetPosition() const
  {
    unsigned best = 0;
    for (unsigned lane = 1; lane < 4; ++lane)
    {
      const bool less = (this->Numbers[lane] < this->Numbers[best]) |
        ((this->Numbers[lane] == this->Numbers[best]) &
          (this->Positions[lane] < this->Positions[best]));
      best = less ? lane : best;
    }
    return this->Positions[best];
  }

private:
  static constexpr float Infinity = std::numeric_limits<float>::infinity();

  Float4 Numbers{ Infinity, Infinity, Infinity, Infinity };
  Int4 Positions{ -1, -1, -1, -1 };
};

/** Moves each lane towards a target by 1 / 2^rate of the way. */
GATUN_INLINE Short8 Approach(Short8 value, Short8 target, int rate)
{
  return value + ((target - value) >> rate);
}

/** a in lanes where l == r, else b. */
GATUN_INLINE Short8 SelectEqual(Short8 l, Short8 r, Short8 a, Short8 b)
{
  const Short8 isEqual = l == r;
  return (a & isEqual) | (b & ~isEqual);
}

GATUN_INLINE Short8 Min(Short8 l, Short8 r)
{
  return l < r ? l : r;
}

/** The least lane. */
GATUN_INLINE std::int16_t Least(Short8 v)
{
  v = Min(v, __builtin_shufflevector(v, v, 4, 5, 6, 7, 0, 1, 2, 3));
  v = Min(v, __builtin_shufflevector(v, v, 2, 3, 0, 1, 6, 7, 4, 5));
  return v[0] < v[1] ? v[0] : v[1];
}
#else
using Short8 = std::array<std::int16_t, 8>;

inline unsigned CountUpTo(const Short8& low, const Short8& high, std::int16_t number)
{
  unsigned count = 0;
  for (std::size_t i = 0; i < 8; ++i)
  {
    count += (low[i] <= number) + (high[i] <= number);
  }
  return count;
}

inline Short8 Approach(Short8 value, const Short8& target, int rate)
{
  for (std::size_t i = 0; i < 8; ++i)
  {
    value[i] = static_cast<std::int16_t>(value[i] + ((target[i] - value[i]) >> rate));
  }
  return value;
}

inline Short8 SelectEqual(const Short8& l, const Short8& r, const Short8& a, Short8 b)
{
  for (std::size_t i = 0; i < 8; ++i)
  {
    b[i] = l[i] == r[i] ? a[i] : b[i];
  }
  return b;
}

inline Short8 Min(Short8 l, const Short8& r)
{
  for (std::size_t i = 0; i < 8; ++i)
  {
    l[i] = l[i] < r[i] ? l[i] : r[i];
  }
  return l;
}

inline std::int16_t Least(const Short8& v)
{
  std::int16_t least = v[0];
  for (const auto lane : v)
  {
    least = lane < least ? lane : least;
  }
  return least;
}

struct Float4
{
  std::array<float, 4> Lanes;
  float operator[](std::size_t i) const { return this->Lanes[i]; }
};

template <typename Operation>
Float4 EachLane(const Float4& a, const Float4& b, Operation&& operation)
{
  Float4 result;
  for (std::size_t i = 0; i < 4; ++i)
  {
    result.Lanes[i] = operation(a.Lanes[i], b.Lanes[i]);
  }
  return result;
}

inline Float4 operator+(const Float4& a, const Float4& b)
{
  return EachLane(a, b, [](float l, float r) { return l + r; });
}

inline Float4 operator-(const Float4& a, const Float4& b)
{
  return EachLane(a, b, [](float l, float r) { return l - r; });
}

inline Float4 operator*(const Float4& a, const Float4& b)
{
  return EachLane(a, b, [](float l, float r) { return l * r; });
}

inline Float4 operator/(const Float4& a, const Float4& b)
{
  return EachLane(a, b, [](float l, float r) { return l / r; });
}

inline Float4 SelectGreater(const Float4& l, const Float4& r, const Float4& a, const Float4& b)
{
  Float4 result;
  for (std::size_t i = 0; i < 4; ++i)
  {
    result.Lanes[i] = l.Lanes[i] > r.Lanes[i] ? a.Lanes[i] : b.Lanes[i];
  }
  return result;
}

class LeastOfGroups
{
public:
  void Compare(const Float4& numbers, std::int32_t first)
  {
    for (std::int32_t lane = 0; lane < 4; ++lane)
    {
      if (numbers[static_cast<std::size_t>(lane)] < this->Number)
      {
        this->Number = numbers[static_cast<std::size_t>(lane)];
        this->Position = first + lane;
      }
    }
  }

  std::int32_t GetPosition() const { return this->Position; }

private:
  float Number = std::numeric_limits<float>::infinity();
  std::int32_t Position = -1;
};

inline Float4 KeepThree(const Float4& v)
{
  return { { v.Lanes[0], v.Lanes[1], v.Lanes[2], 0 } };
}
#endif

// Each of these compiles to one instruction.

/** The first three lanes, rotated by one. */
GATUN_INLINE Float4 Rotate(Float4 v)
{
  return Float4{ v[1], v[2], v[0], v[3] };
}

/** Interleaves lanes 0 and 1 of both. */
GATUN_INLINE Float4 Interleave(Float4 a, Float4 b)
{
  return Float4{ a[0], b[0], a[1], b[1] };
}

/** Interleaves lanes 2 and 3 of both. */
GATUN_INLINE Float4 InterleaveHigh(Float4 a, Float4 b)
{
  return Float4{ a[2], b[2], a[3], b[3] };
}

GATUN_INLINE Float4 JoinLow(Float4 a, Float4 b)
{
  return Float4{ a[0], a[1], b[0], b[1] };
}

GATUN_INLINE Float4 JoinHigh(Float4 a, Float4 b)
{
  return Float4{ a[2], a[3], b[2], b[3] };
}

GATUN_INLINE float Least(Float4 v)
{
  const float a = v[1] < v[0] ? v[1] : v[0];
  const float b = v[3] < v[2] ? v[3] : v[2];
  return b < a ? b : a;
}

GATUN_INLINE Float4 Splat(float value)
{
  return Float4{ value, value, value, value };
}
}

#endif
