// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunMergeLanes_h
#define gatunMergeLanes_h

// Tetrahedra around a point in blocks of four, of which each has a lane. Lanes are added in a fixed
// order, so that results do not depend on the processor.

#include "gatunInline.h"
#include "gatunLanes.h"

#include <array>
#include <cstddef>

namespace gatun
{
constexpr std::size_t Lanes = 4; // of a block

#if defined(__GNUC__)
using Double2 = double __attribute__((vector_size(16)));

/** a in lanes where l > r, else b. */
GATUN_INLINE Double2 SelectGreater(Double2 l, Double2 r, Double2 a, Double2 b)
{
  return l > r ? a : b;
}
#else
struct Double2
{
  std::array<double, 2> Two;
  double operator[](std::size_t i) const { return this->Two[i]; }
};

inline Double2 operator+(const Double2& a, const Double2& b)
{
  return { { a[0] + b[0], a[1] + b[1] } };
}

inline Double2 operator-(const Double2& a, const Double2& b)
{
  return { { a[0] - b[0], a[1] - b[1] } };
}

inline Double2 operator*(const Double2& a, const Double2& b)
{
  return { { a[0] * b[0], a[1] * b[1] } };
}

inline Double2 operator/(const Double2& a, const Double2& b)
{
  return { { a[0] / b[0], a[1] / b[1] } };
}

inline Double2 SelectGreater(const Double2& l, const Double2& r, const Double2& a, const Double2& b)
{
  return { { l[0] > r[0] ? a[0] : b[0], l[1] > r[1] ? a[1] : b[1] } };
}
#endif

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
