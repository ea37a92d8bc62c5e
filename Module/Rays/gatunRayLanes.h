// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunRayLanes_h
#define gatunRayLanes_h

// Blocks of pixels in the lanes of vectors. Part of gatunRayLoops.h, see there.
//
// A class of lanes has the types Float, a vector with arithmetic operators, and Mask, a set of
// lanes. Min and Max return their second argument if the first one is NaN.

#include "gatunSimd.h"

namespace gatun
{
namespace GATUN_SIMD
{
/** Four by two pixels. */
struct Lanes8
{
  static constexpr int Rows = 2;
  using Float = Float8;
  GATUN_INLINE static Float Splat(float v) { return Splat8(v); }
  GATUN_INLINE static Float GetX() { return Float{ 0, 1, 2, 3, 0, 1, 2, 3 }; }
  GATUN_INLINE static Float GetY() { return Float{ 0, 0, 0, 0, 1, 1, 1, 1 }; }
#if defined(__AVX2__)
  GATUN_INLINE static Float Load(const float* from)
  {
    return _mm256_load_ps(from);
  }
  GATUN_INLINE static void Store(float* to, Float v)
  {
    _mm256_store_ps(to, v);
  }
  GATUN_INLINE static Float Min(Float a, Float b)
  {
    return _mm256_min_ps(a, b);
  }
  GATUN_INLINE static Float Max(Float a, Float b)
  {
    return _mm256_max_ps(a, b);
  }
#else
  GATUN_INLINE static Float Load(const float* from)
  {
    return GATUN_SIMD::Load<Float>(from);
  }
  GATUN_INLINE static void Store(float* to, Float v)
  {
    GATUN_SIMD::Store(to, v);
  }
  GATUN_INLINE static Float Min(Float a, Float b)
  {
    return a < b ? a : b;
  }
  GATUN_INLINE static Float Max(Float a, Float b)
  {
    return a > b ? a : b;
  }
#endif
#if defined(__AVX512VL__)
  using Mask = __mmask8;
  GATUN_INLINE static Mask All()
  {
    return 0xff;
  }
  GATUN_INLINE static Mask Less(Float a, Float b)
  {
    return _mm256_cmp_ps_mask(a, b, _CMP_LT_OQ);
  }
  GATUN_INLINE static Mask Equal(Float a, Float b)
  {
    return _mm256_cmp_ps_mask(a, b, _CMP_EQ_OQ);
  }
  GATUN_INLINE static Mask And(Mask a, Mask b)
  {
    return static_cast<Mask>(a & b);
  }
  GATUN_INLINE static Mask Or(Mask a, Mask b)
  {
    return static_cast<Mask>(a | b);
  }
  GATUN_INLINE static Mask Without(Mask a, Mask b)
  {
    return static_cast<Mask>(a & ~b);
  }
  GATUN_INLINE static Float Select(Mask m, Float a, Float b)
  {
    return _mm256_mask_blend_ps(m, b, a);
  }
  GATUN_INLINE static unsigned ToBits(Mask m)
  {
    return m;
  }
#else
  using Mask = Int8;
  GATUN_INLINE static Mask All()
  {
    return Mask{ -1, -1, -1, -1, -1, -1, -1, -1 };
  }
  GATUN_INLINE static Mask Less(Float a, Float b)
  {
    return a < b;
  }
  GATUN_INLINE static Mask Equal(Float a, Float b)
  {
    return a == b;
  }
  GATUN_INLINE static Mask And(Mask a, Mask b)
  {
    return a & b;
  }
  GATUN_INLINE static Mask Or(Mask a, Mask b)
  {
    return a | b;
  }
  GATUN_INLINE static Mask Without(Mask a, Mask b)
  {
    return a & ~b;
  }
  GATUN_INLINE static Float Select(Mask m, Float a, Float b)
  {
    return m ? a : b;
  }
  GATUN_INLINE static unsigned ToBits(Mask m)
  {
    return GATUN_SIMD::ToBits(m);
  }
#endif
};

#if defined(__AVX512F__)
/** Four by four pixels. */
struct Lanes16
{
  static constexpr int Rows = 4;
  using Float = float __attribute__((vector_size(64)));
  using Mask = __mmask16;
  GATUN_INLINE static Float Splat(float v) { return _mm512_set1_ps(v); }
  GATUN_INLINE static Float GetX()
  {
    return Float{ 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3 };
  }
  GATUN_INLINE static Float GetY()
  {
    return Float{ 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3 };
  }
  GATUN_INLINE static Float Load(const float* from) { return _mm512_load_ps(from); }
  GATUN_INLINE static void Store(float* to, Float v) { _mm512_store_ps(to, v); }
  // With a mask, as GCC 12 warns about the functions without one.
  GATUN_INLINE static Float Min(Float a, Float b) { return _mm512_maskz_min_ps(0xffff, a, b); }
  GATUN_INLINE static Float Max(Float a, Float b) { return _mm512_maskz_max_ps(0xffff, a, b); }
  GATUN_INLINE static Mask Less(Float a, Float b) { return _mm512_cmp_ps_mask(a, b, _CMP_LT_OQ); }
  GATUN_INLINE static Mask Equal(Float a, Float b) { return _mm512_cmp_ps_mask(a, b, _CMP_EQ_OQ); }
  GATUN_INLINE static Mask And(Mask a, Mask b) { return static_cast<Mask>(a & b); }
  GATUN_INLINE static Mask Or(Mask a, Mask b) { return static_cast<Mask>(a | b); }
  GATUN_INLINE static Mask Without(Mask a, Mask b) { return static_cast<Mask>(a & ~b); }
  GATUN_INLINE static Float Select(Mask m, Float a, Float b)
  {
    return _mm512_mask_blend_ps(m, b, a);
  }
  GATUN_INLINE static unsigned ToBits(Mask m) { return m; }
};
using WideLanes = Lanes16;
#else
using WideLanes = Lanes8;
#endif
}
}

#endif
