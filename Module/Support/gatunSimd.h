// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunSimd_h
#define gatunSimd_h

// Eight floats or four doubles at once.
//
// Sources that include this header are compiled once for each instruction set, which GATUN_SIMD
// names. This code and the kernels that use it are in a namespace of that name, so that code for
// newer processors is never linked in place of code for older ones.

#include "gatunInline.h"

#include <cstdint>

#if defined(__AVX2__)
#include <immintrin.h>
#elif defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace gatun
{
namespace GATUN_SIMD
{
using Float8 = float __attribute__((vector_size(32)));
using Int8 = std::int32_t __attribute__((vector_size(32)));
using Float4 = float __attribute__((vector_size(16)));
using Int4 = std::int32_t __attribute__((vector_size(16)));
using Double4 = double __attribute__((vector_size(32)));
using Long4 = std::int64_t __attribute__((vector_size(32)));

GATUN_INLINE Float8 Splat8(float v)
{
  return Float8{ v, v, v, v, v, v, v, v };
}

GATUN_INLINE Float4 Splat4(float v)
{
  return Float4{ v, v, v, v };
}

GATUN_INLINE Double4 SplatD(double v)
{
  return Double4{ v, v, v, v };
}

template <typename Vector>
GATUN_INLINE Vector Load(const void* from)
{
  Vector v;
  __builtin_memcpy(&v, from, sizeof(v));
  return v;
}

template <typename Vector>
GATUN_INLINE void Store(void* to, Vector v)
{
  __builtin_memcpy(to, &v, sizeof(v));
}

template <typename Vector>
GATUN_INLINE Vector Smaller(Vector a, Vector b)
{
  return a < b ? a : b;
}

template <typename Vector>
GATUN_INLINE Vector Larger(Vector a, Vector b)
{
  return a > b ? a : b;
}

/** Moves lane order[i] of v to lane i. */
GATUN_INLINE Float4 Permute(Float4 v, Int4 order)
{
#if defined(__AVX2__)
  return _mm_permutevar_ps(v, reinterpret_cast<__m128i>(order));
#else
  return Float4{ v[order[0]], v[order[1]], v[order[2]], v[order[3]] };
#endif
}

/** Bit i is set where lane i of the comparison holds. */
template <unsigned Lanes, typename Comparison>
GATUN_INLINE unsigned CollectBits(Comparison comparison)
{
  unsigned bits = 0;
  for (unsigned i = 0; i < Lanes; ++i)
  {
    bits |= comparison[i] ? 1u << i : 0u;
  }
  return bits;
}

GATUN_INLINE unsigned ToBits(Int4 comparison)
{
#if defined(__SSE2__)
  return static_cast<unsigned>(_mm_movemask_ps(reinterpret_cast<__m128>(comparison)));
#else
  return CollectBits<4>(comparison);
#endif
}

GATUN_INLINE unsigned ToBits(Int8 comparison)
{
#if defined(__AVX2__)
  return static_cast<unsigned>(_mm256_movemask_ps(reinterpret_cast<__m256>(comparison)));
#else
  return ToBits(__builtin_shufflevector(comparison, comparison, 0, 1, 2, 3)) |
    ToBits(__builtin_shufflevector(comparison, comparison, 4, 5, 6, 7)) << 4;
#endif
}

GATUN_INLINE unsigned ToBits(Long4 comparison)
{
#if defined(__AVX2__)
  return static_cast<unsigned>(_mm256_movemask_pd(reinterpret_cast<__m256d>(comparison)));
#else
  return CollectBits<4>(comparison);
#endif
}

/** Rounds numbers from -2^30 to 2^30 up to integers. */
GATUN_INLINE Float8 RoundUp(Float8 v)
{
#if defined(__AVX2__)
  return _mm256_ceil_ps(v);
#else
  const auto down = __builtin_convertvector(__builtin_convertvector(v, Int8), Float8);
  return down + (down < v ? Splat8(1.0f) : Splat8(0.0f));
#endif
}
}
}

#endif
