// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunMergeLanes_h
#define gatunMergeLanes_h

// Tetrahedra around a point in blocks of four, of which each has a lane. Lanes are added in a fixed
// order, so that results do not depend on the processor.

#include "gatunInline.h"
#include "gatunLanes.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace gatun
{
constexpr std::size_t Lanes = 4; // of a block

using Double2 = double __attribute__((vector_size(16)));

/** All bits of a lane, or none. */
using Mask2 = std::int64_t __attribute__((vector_size(16)));

/** a in lanes where l > r, else b. */
GATUN_INLINE Double2 SelectGreater(Double2 l, Double2 r, Double2 a, Double2 b)
{
  return l > r ? a : b;
}

/** v in the lanes of a mask, else 0. */
GATUN_INLINE Double2 Keep(Double2 v, Mask2 mask)
{
  return std::bit_cast<Double2>(std::bit_cast<Mask2>(v) & mask);
}

/** A mask of four lanes as two of two. */
GATUN_INLINE std::array<Mask2, 2> Split(Int4 mask)
{
  return { std::bit_cast<Mask2>(__builtin_shufflevector(mask, mask, 0, 0, 1, 1)),
    std::bit_cast<Mask2>(__builtin_shufflevector(mask, mask, 2, 2, 3, 3)) };
}

GATUN_INLINE bool IsAny(Mask2 mask)
{
  return (mask[0] | mask[1]) != 0;
}

/** Four of many numbers, a stride apart. */
GATUN_INLINE Float4 GatherFour(const float* from, const UInt4& places, std::size_t stride)
{
  return Float4{ from[places[0] * stride], from[places[1] * stride], from[places[2] * stride],
    from[places[3] * stride] };
}

GATUN_INLINE Double2 Splat2(double value)
{
  return Double2{ value, value };
}

/** Three coordinates in each lane. */
template <typename Lane>
struct Triple
{
  Lane X, Y, Z;
};

template <typename Lane>
GATUN_INLINE Triple<Lane> operator+(const Triple<Lane>& a, const Triple<Lane>& b)
{
  return { a.X + b.X, a.Y + b.Y, a.Z + b.Z };
}

template <typename Lane>
GATUN_INLINE Triple<Lane> operator-(const Triple<Lane>& a, const Triple<Lane>& b)
{
  return { a.X - b.X, a.Y - b.Y, a.Z - b.Z };
}

template <typename Lane>
GATUN_INLINE Triple<Lane> operator*(Lane a, const Triple<Lane>& b)
{
  return { a * b.X, a * b.Y, a * b.Z };
}

template <typename Lane>
GATUN_INLINE Lane Dot(const Triple<Lane>& a, const Triple<Lane>& b)
{
  return a.X * b.X + a.Y * b.Y + a.Z * b.Z;
}

template <typename Lane>
GATUN_INLINE Triple<Lane> Cross(const Triple<Lane>& a, const Triple<Lane>& b)
{
  return { a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X };
}

GATUN_INLINE double Sum(Double2 v)
{
  return v[0] + v[1];
}

GATUN_INLINE float Sum(Float4 v)
{
  return (v[0] + v[1]) + (v[2] + v[3]);
}
}

#endif
