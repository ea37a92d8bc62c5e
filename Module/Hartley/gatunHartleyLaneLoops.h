// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyLaneLoops_h
#define gatunHartleyLaneLoops_h

// Compiled once for each instruction set; see gatunSimd.h.

#include "gatunHartleyLanes.h"
#include "gatunSimd.h"

#include <utility>

namespace gatun
{
namespace GATUN_SIMD
{
/** ComplexLanes in registers. */
struct Complex8
{
  Float8 Re, Im;
};

GATUN_INLINE Complex8 Get(const ComplexLanes& from)
{
  return { Load<Float8>(from.Re), Load<Float8>(from.Im) };
}

GATUN_INLINE void Put(ComplexLanes& to, const Float8& re, const Float8& im)
{
  Store(to.Re, re);
  Store(to.Im, im);
}

/** The product with a complex number or, inverse, with its conjugate. */
template <bool Inverse>
GATUN_INLINE void PutTurned(ComplexLanes& to, const Float8& re, const Float8& im, const float* turn)
{
  const Float8 c = Splat8(turn[0]);
  const Float8 s = Splat8(Inverse ? -turn[1] : turn[1]);
  Put(to, re * c - im * s, re * s + im * c);
}

//------------------------------------------------------------------------------
/** Transforms of Radix numbers, which are Apart from each other; the results are Stride apart. */
template <std::size_t Radix, bool Inverse>
struct Butterfly;

template <bool Inverse>
struct Butterfly<2, Inverse>
{
  GATUN_INLINE static void Run(const ComplexLanes* in, std::size_t apart, ComplexLanes* out,
    std::size_t stride, const float* turns)
  {
    const Complex8 a = Get(in[0]);
    const Complex8 b = Get(in[apart]);
    Put(out[0], a.Re + b.Re, a.Im + b.Im);
    PutTurned<Inverse>(out[stride], a.Re - b.Re, a.Im - b.Im, turns);
  }
};

template <bool Inverse>
struct Butterfly<3, Inverse>
{
  GATUN_INLINE static void Run(const ComplexLanes* in, std::size_t apart, ComplexLanes* out,
    std::size_t stride, const float* turns)
  {
    const Complex8 a = Get(in[0]);
    const Complex8 b = Get(in[apart]);
    const Complex8 c = Get(in[2 * apart]);
    const Float8 half = Splat8(0.5f);
    const Float8 sine = Splat8(Inverse ? -0.8660254037844386f : 0.8660254037844386f);
    const Float8 sumRe = b.Re + c.Re, sumIm = b.Im + c.Im;
    const Float8 sideRe = (b.Re - c.Re) * sine, sideIm = (b.Im - c.Im) * sine;
    const Float8 midRe = a.Re - half * sumRe, midIm = a.Im - half * sumIm;
    Put(out[0], a.Re + sumRe, a.Im + sumIm);
    PutTurned<Inverse>(out[stride], midRe + sideIm, midIm - sideRe, turns);
    PutTurned<Inverse>(out[2 * stride], midRe - sideIm, midIm + sideRe, turns + 2);
  }
};

template <bool Inverse>
struct Butterfly<4, Inverse>
{
  GATUN_INLINE static void Run(const ComplexLanes* in, std::size_t apart, ComplexLanes* out,
    std::size_t stride, const float* turns)
  {
    const Complex8 a = Get(in[0]);
    const Complex8 b = Get(in[apart]);
    const Complex8 c = Get(in[2 * apart]);
    const Complex8 d = Get(in[3 * apart]);
    const Float8 acRe = a.Re + c.Re, acIm = a.Im + c.Im;
    const Float8 bdRe = b.Re + d.Re, bdIm = b.Im + d.Im;
    const Float8 evenRe = a.Re - c.Re, evenIm = a.Im - c.Im;
    // (b - d) / i, or times i.
    const Float8 oddRe = Inverse ? d.Im - b.Im : b.Im - d.Im;
    const Float8 oddIm = Inverse ? b.Re - d.Re : d.Re - b.Re;
    Put(out[0], acRe + bdRe, acIm + bdIm);
    PutTurned<Inverse>(out[stride], evenRe + oddRe, evenIm + oddIm, turns);
    PutTurned<Inverse>(out[2 * stride], acRe - bdRe, acIm - bdIm, turns + 2);
    PutTurned<Inverse>(out[3 * stride], evenRe - oddRe, evenIm - oddIm, turns + 4);
  }
};

template <bool Inverse>
struct Butterfly<5, Inverse>
{
  GATUN_INLINE static void Run(const ComplexLanes* in, std::size_t apart, ComplexLanes* out,
    std::size_t stride, const float* turns)
  {
    const Complex8 a = Get(in[0]);
    const Complex8 b = Get(in[apart]);
    const Complex8 c = Get(in[2 * apart]);
    const Complex8 d = Get(in[3 * apart]);
    const Complex8 e = Get(in[4 * apart]);
    const Float8 cos1 = Splat8(0.30901699437494745f);
    const Float8 cos2 = Splat8(-0.8090169943749475f);
    const Float8 sin1 = Splat8(Inverse ? -0.9510565162951535f : 0.9510565162951535f);
    const Float8 sin2 = Splat8(Inverse ? -0.5877852522924731f : 0.5877852522924731f);
    const Float8 beRe = b.Re + e.Re, beIm = b.Im + e.Im;
    const Float8 cdRe = c.Re + d.Re, cdIm = c.Im + d.Im;
    const Float8 beSideRe = b.Re - e.Re, beSideIm = b.Im - e.Im;
    const Float8 cdSideRe = c.Re - d.Re, cdSideIm = c.Im - d.Im;
    const Float8 mid1Re = a.Re + cos1 * beRe + cos2 * cdRe;
    const Float8 mid1Im = a.Im + cos1 * beIm + cos2 * cdIm;
    const Float8 mid2Re = a.Re + cos2 * beRe + cos1 * cdRe;
    const Float8 mid2Im = a.Im + cos2 * beIm + cos1 * cdIm;
    const Float8 side1Re = sin1 * beSideRe + sin2 * cdSideRe;
    const Float8 side1Im = sin1 * beSideIm + sin2 * cdSideIm;
    const Float8 side2Re = sin2 * beSideRe - sin1 * cdSideRe;
    const Float8 side2Im = sin2 * beSideIm - sin1 * cdSideIm;
    Put(out[0], a.Re + beRe + cdRe, a.Im + beIm + cdIm);
    PutTurned<Inverse>(out[stride], mid1Re + side1Im, mid1Im - side1Re, turns);
    PutTurned<Inverse>(out[2 * stride], mid2Re + side2Im, mid2Im - side2Re, turns + 2);
    PutTurned<Inverse>(out[3 * stride], mid2Re - side2Im, mid2Im + side2Re, turns + 4);
    PutTurned<Inverse>(out[4 * stride], mid1Re - side1Im, mid1Im + side1Re, turns + 6);
  }
};

//------------------------------------------------------------------------------
template <std::size_t Radix, bool Inverse>
inline void RunStage(const FourierStage& stage, const ComplexLanes* in, ComplexLanes* out)
{
  const std::size_t apart = stage.Stride * stage.Count;
  const float* turns = stage.Turns;
  for (std::size_t j = 0; j < stage.Count; ++j, turns += 2 * (Radix - 1))
  {
    const ComplexLanes* from = in + stage.Stride * j;
    ComplexLanes* to = out + stage.Stride * Radix * j;
    for (std::size_t i = 0; i < stage.Stride; ++i, ++from, ++to)
    {
      Butterfly<Radix, Inverse>::Run(from, apart, to, stage.Stride, turns);
    }
  }
}

//------------------------------------------------------------------------------
/** A prime radix, by the definition. */
template <bool Inverse>
inline void RunAnyStage(const FourierStage& stage, const ComplexLanes* in, ComplexLanes* out)
{
  const std::size_t radix = stage.Radix;
  const std::size_t apart = stage.Stride * stage.Count;
  const float* turns = stage.Turns;
  for (std::size_t j = 0; j < stage.Count; ++j, turns += 2 * (radix - 1))
  {
    for (std::size_t i = 0; i < stage.Stride; ++i)
    {
      const ComplexLanes* const from = in + stage.Stride * j + i;
      ComplexLanes* const to = out + stage.Stride * radix * j + i;
      for (std::size_t k = 0; k < radix; ++k)
      {
        Float8 re{}, im{};
        std::size_t root = 0;
        for (std::size_t r = 0; r < radix; ++r)
        {
          const Complex8 value = Get(from[r * apart]);
          const Float8 c = Splat8(stage.Roots[2 * root]);
          const Float8 s = Splat8(Inverse ? -stage.Roots[2 * root + 1] : stage.Roots[2 * root + 1]);
          re += value.Re * c - value.Im * s;
          im += value.Re * s + value.Im * c;
          root += k;
          root -= root >= radix ? radix : 0;
        }
        if (k == 0)
        {
          Put(to[0], re, im);
        }
        else
        {
          PutTurned<Inverse>(to[k * stage.Stride], re, im, turns + 2 * (k - 1));
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
template <bool Inverse>
inline ComplexLanes* RunStages(
  const FourierStage* stages, std::size_t count, ComplexLanes* values, ComplexLanes* room)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    switch (stages[i].Radix)
    {
      case 2:
        RunStage<2, Inverse>(stages[i], values, room);
        break;
      case 3:
        RunStage<3, Inverse>(stages[i], values, room);
        break;
      case 4:
        RunStage<4, Inverse>(stages[i], values, room);
        break;
      case 5:
        RunStage<5, Inverse>(stages[i], values, room);
        break;
      default:
        RunAnyStage<Inverse>(stages[i], values, room);
    }
    ComplexLanes* const swapped = values;
    values = room;
    room = swapped;
  }
  return values;
}

inline ComplexLanes* Transform(const FourierStage* stages, std::size_t count, bool inverse,
  ComplexLanes* values, ComplexLanes* room)
{
  return inverse ? RunStages<true>(stages, count, values, room)
                 : RunStages<false>(stages, count, values, room);
}

//------------------------------------------------------------------------------
inline void Turn(ComplexLanes* values, const float* factors, std::size_t count)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    const Complex8 value = Get(values[i]);
    PutTurned<false>(values[i], value.Re, value.Im, factors + 2 * i);
  }
}

//------------------------------------------------------------------------------
GATUN_INLINE void Transpose8(Float8* r)
{
  Float8 t[8], s[8];
  for (int i = 0; i < 8; i += 2)
  {
    t[i] = __builtin_shufflevector(r[i], r[i + 1], 0, 8, 1, 9, 4, 12, 5, 13);
    t[i + 1] = __builtin_shufflevector(r[i], r[i + 1], 2, 10, 3, 11, 6, 14, 7, 15);
  }
  for (int i = 0; i < 8; i += 4)
  {
    s[i] = __builtin_shufflevector(t[i], t[i + 2], 0, 1, 8, 9, 4, 5, 12, 13);
    s[i + 1] = __builtin_shufflevector(t[i], t[i + 2], 2, 3, 10, 11, 6, 7, 14, 15);
    s[i + 2] = __builtin_shufflevector(t[i + 1], t[i + 3], 0, 1, 8, 9, 4, 5, 12, 13);
    s[i + 3] = __builtin_shufflevector(t[i + 1], t[i + 3], 2, 3, 10, 11, 6, 7, 14, 15);
  }
  for (int i = 0; i < 4; ++i)
  {
    r[i] = __builtin_shufflevector(s[i], s[i + 4], 0, 1, 2, 3, 8, 9, 10, 11);
    r[i + 4] = __builtin_shufflevector(s[i], s[i + 4], 4, 5, 6, 7, 12, 13, 14, 15);
  }
}

inline void Transpose(const float* from, std::size_t fromStride, float* to, std::size_t toStride)
{
  Float8 rows[8];
  for (std::size_t i = 0; i < 8; ++i)
  {
    rows[i] = Load<Float8>(from + i * fromStride);
  }
  Transpose8(rows);
  for (std::size_t i = 0; i < 8; ++i)
  {
    Store(to + i * toStride, rows[i]);
  }
}

//------------------------------------------------------------------------------
inline void Separate(const ComplexLanes& here, const ComplexLanes& there, const float* factor,
  ComplexLanes& first, ComplexLanes& second)
{
  const Complex8 a = Get(here);
  const Complex8 b = Get(there);
  const float half[2] = { 0.5f * factor[0], 0.5f * factor[1] };
  PutTurned<false>(first, a.Re + b.Re, a.Im - b.Im, half);
  PutTurned<false>(second, a.Im + b.Im, b.Re - a.Re, half);
}

//------------------------------------------------------------------------------
inline void Join(const ComplexLanes* first, const ComplexLanes* second, std::size_t count,
  std::size_t size, ComplexLanes* to)
{
  Put(to[0], Load<Float8>(first[0].Re), Load<Float8>(second[0].Re));
  for (std::size_t u = 1; u < count; ++u)
  {
    const Complex8 a = Get(first[u]);
    const Complex8 b = Get(second[u]);
    Put(to[u], a.Re - b.Im, a.Im + b.Re);
    Put(to[size - u], a.Re + b.Im, b.Re - a.Im);
  }
  for (std::size_t u = count; u + count <= size; ++u)
  {
    Put(to[u], Float8{}, Float8{});
  }
}

//------------------------------------------------------------------------------
using Half8 = std::uint16_t __attribute__((vector_size(16)));

#if defined(__F16C__)
GATUN_INLINE Half8 RoundToHalf(const Float8& v)
{
  return reinterpret_cast<Half8>(_mm256_cvtps_ph(v, _MM_FROUND_TO_NEAREST_INT));
}

GATUN_INLINE Float8 WidenHalf(const Half8& v)
{
  return _mm256_cvtph_ps(reinterpret_cast<__m128i>(v));
}
#else
/** To the nearest, ties to even, as F16C rounds. For numbers below 65520. */
GATUN_INLINE Half8 RoundToHalf(const Float8& v)
{
  using Bits8 = std::uint32_t __attribute__((vector_size(32)));
  Bits8 bits = reinterpret_cast<Bits8>(v);
  const Bits8 sign = (bits >> 16) & 0x8000u;
  bits &= 0x7fffffffu;
  // Normal numbers: the exponent gets another bias and the mantissa is rounded to 10 bits.
  const Bits8 normal = (bits - 0x38000000u + 0xfffu + ((bits >> 13) & 1u)) >> 13;
  // The others are multiples of 2^-24; adding 1/2 moves the bits of such a number to the end.
  const Bits8 small =
    reinterpret_cast<Bits8>(reinterpret_cast<Float8>(bits) + Splat8(0.5f)) - 0x3f000000u;
  const Bits8 least = Bits8{} + 0x38800000u;
  return __builtin_convertvector(sign | (bits < least ? small : normal), Half8);
}

GATUN_INLINE Float8 WidenHalf(const Half8& v)
{
  using Bits8 = std::uint32_t __attribute__((vector_size(32)));
  const Bits8 bits = __builtin_convertvector(v, Bits8);
  const Bits8 sign = (bits & 0x8000u) << 16;
  // Exponent and mantissa are those of the number divided by 2^112.
  const Bits8 rest = (bits & 0x7fffu) << 13;
  const Float8 wide = reinterpret_cast<Float8>(rest) * Splat8(0x1p112f);
  return reinterpret_cast<Float8>(reinterpret_cast<Bits8>(wide) | sign);
}
#endif

inline void ToHalf(const float* from, std::size_t count, float scale, std::uint16_t* to)
{
  for (std::size_t i = 0; i < count; i += 8)
  {
    Store(to + i, RoundToHalf(Load<Float8>(from + i) * Splat8(scale)));
  }
}

inline void FromHalf(const std::uint16_t* from, std::size_t count, float* to)
{
  for (std::size_t i = 0; i < count; i += 8)
  {
    Store(to + i, WidenHalf(Load<Half8>(from + i)));
  }
}

//------------------------------------------------------------------------------
inline void StoreRows(const ComplexLanes* from, float scale, std::size_t rows, std::size_t columns,
  std::uint16_t* to, std::size_t stride)
{
  Float8 re[8], im[8];
  for (std::size_t i = 0; i < 8; ++i)
  {
    re[i] = Load<Float8>(from[i].Re) * Splat8(scale);
    im[i] = Load<Float8>(from[i].Im) * Splat8(scale);
  }
  Transpose8(re);
  Transpose8(im);
  for (std::size_t i = 0; i < rows; ++i)
  {
    const Half8 low = RoundToHalf(__builtin_shufflevector(re[i], im[i], 0, 8, 1, 9, 2, 10, 3, 11));
    const Half8 high =
      RoundToHalf(__builtin_shufflevector(re[i], im[i], 4, 12, 5, 13, 6, 14, 7, 15));
    std::uint16_t* const row = to + i * stride;
    if (columns == 8)
    {
      Store(row, low);
      Store(row + 8, high);
      continue;
    }
    std::uint16_t values[16];
    Store(values, low);
    Store(values + 8, high);
    for (std::size_t k = 0; k < 2 * columns; ++k)
    {
      row[k] = values[k];
    }
  }
}

//------------------------------------------------------------------------------
inline void Sample(const HartleySample* samples, std::size_t count, const std::uint16_t* values,
  const float* weights, std::ptrdiff_t stride, float* to)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    const HartleySample& sample = samples[i];
    const std::uint16_t* const first = values + 2 * std::size_t{ sample.First };
    Half8 low, high;
    if (stride == 1)
    {
      low = Load<Half8>(first);
      high = Load<Half8>(first + 8);
    }
    else
    {
      std::uint32_t taps[8];
      for (std::ptrdiff_t k = 0; k < 8; ++k)
      {
        taps[k] = Load<std::uint32_t>(first + 2 * k * stride);
      }
      low = Load<Half8>(taps);
      high = Load<Half8>(taps + 4);
    }
    const auto step = static_cast<std::int32_t>(sample.Position);
    const Float8 part = Splat8(sample.Position - static_cast<float>(step));
    const float* const at = weights + static_cast<std::size_t>(step) * 16;
    const Float8 one = Load<Float8>(at), two = Load<Float8>(at + 8);
    const Float8 total = (one + part * (Load<Float8>(at + 16) - one)) * WidenHalf(low) +
      (two + part * (Load<Float8>(at + 24) - two)) * WidenHalf(high);
    // Real and imaginary parts alternate.
    const Float4 four = __builtin_shufflevector(total, total, 0, 1, 2, 3) +
      __builtin_shufflevector(total, total, 4, 5, 6, 7);
    to[sample.To] += (four[0] + four[2]) * sample.Scale;
    to[sample.To + 8] += (four[1] + four[3]) * sample.ImaginaryScale;
  }
}

//------------------------------------------------------------------------------
GATUN_INLINE Float4 GetTapWeights(const HartleyResampling& resampling, float part)
{
  const float at = part * resampling.Steps;
  const auto step = static_cast<std::int32_t>(at);
  const float* const weights =
    resampling.Weights + static_cast<std::size_t>(step) * HartleyResampling::Taps;
  const Float4 one = Load<Float4>(weights);
  return one + Splat4(at - static_cast<float>(step)) * (Load<Float4>(weights + 4) - one);
}

inline void Resample(const HartleyResampling& resampling, double x, double y, double stepX,
  double stepY, std::size_t count, float* to)
{
  static_assert(HartleyResampling::Taps == 4);
  for (std::size_t i = 0; i < count; ++i)
  {
    const double atX = x + static_cast<double>(i) * stepX;
    const double atY = y + static_cast<double>(i) * stepY;
    const auto column = static_cast<std::int32_t>(atX);
    const auto row = static_cast<std::int32_t>(atY);
    const Float4 across =
      GetTapWeights(resampling, static_cast<float>(atX - static_cast<double>(column)));
    const Float4 down =
      GetTapWeights(resampling, static_cast<float>(atY - static_cast<double>(row)));
    const float* const from = resampling.Lattice +
      static_cast<std::size_t>(row - 1) * resampling.Stride + static_cast<std::size_t>(column - 1);
    Float4 sum = Splat4(down[0]) * Load<Float4>(from);
    sum += Splat4(down[1]) * Load<Float4>(from + resampling.Stride);
    sum += Splat4(down[2]) * Load<Float4>(from + 2 * resampling.Stride);
    sum += Splat4(down[3]) * Load<Float4>(from + 3 * resampling.Stride);
    sum *= across;
    to[i] = (sum[0] + sum[1]) + (sum[2] + sum[3]);
  }
}

//------------------------------------------------------------------------------
/** Sorts one value of each lane to a, the other to b. */
GATUN_INLINE void Order(Float8& a, Float8& b)
{
  const Float8 low = Smaller(a, b);
  b = Larger(a, b);
  a = low;
}

inline void Measure(const HartleyBox& box, const float* origin, std::size_t count, float* to)
{
  for (std::size_t first = 0; first < count; first += 8)
  {
    const Float8 column = Float8{ 0, 1, 2, 3, 4, 5, 6, 7 } + Splat8(static_cast<float>(first));
    Float8 enter[3], leave[3], breaks[8];
    Float8 begin = Splat8(-1e30f);
    Float8 end = Splat8(1e30f);
    for (int i = 0; i < 3; ++i)
    {
      // Of the middle of the box, in steps along the ray.
      const Float8 middle =
        (Splat8(origin[i]) + column * Splat8(box.Column[i])) * Splat8(-box.PerVoxel[i]);
      const Float8 voxel = Splat8(box.PerVoxel[i] < 0 ? -box.PerVoxel[i] : box.PerVoxel[i]);
      const Float8 reach = Splat8(box.HalfSize[i]) * voxel;
      enter[i] = middle - reach;
      leave[i] = middle + reach;
      begin = Larger(begin, enter[i]);
      end = Smaller(end, leave[i]);
      breaks[1 + i] = enter[i] + voxel;
      breaks[4 + i] = leave[i] - voxel;
    }
    if (ToBits(Int8(begin < end)) == 0)
    {
      for (std::size_t k = first; k < count && k < first + 8; ++k)
      {
        to[k] = 0;
      }
      continue;
    }
    end = Larger(begin, end);
    breaks[0] = begin;
    breaks[7] = end;
    for (int i = 1; i < 7; ++i)
    {
      breaks[i] = Smaller(Larger(breaks[i], begin), end);
    }
    // Sorts the six between.
    constexpr int pairs[12][2] = { { 1, 6 }, { 2, 4 }, { 3, 5 }, { 2, 3 }, { 4, 5 }, { 1, 4 },
      { 3, 6 }, { 1, 2 }, { 3, 4 }, { 5, 6 }, { 2, 3 }, { 4, 5 } };
    for (const auto& pair : pairs)
    {
      Order(breaks[pair[0]], breaks[pair[1]]);
    }
    Float8 total{};
    for (int piece = 0; piece < 7; ++piece)
    {
      const Float8 half = (breaks[piece + 1] - breaks[piece]) * Splat8(0.5f);
      const Float8 mid = breaks[piece] + half;
      const Float8 offset = half * Splat8(0.5773502691896258f);
      for (const Float8& place : { mid - offset, mid + offset })
      {
        Float8 weight = half;
        for (int i = 0; i < 3; ++i)
        {
          const Float8 inside =
            Smaller(place - enter[i], leave[i] - place) * Splat8(box.PerStep[i]);
          weight *= Smaller(Larger(inside, Float8{}), Splat8(1.0f));
        }
        total += weight;
      }
    }
    for (std::size_t k = first; k < count && k < first + 8; ++k)
    {
      to[k] = total[k - first];
    }
  }
}

//------------------------------------------------------------------------------
constexpr HartleyLaneLoops MakeHartleyLanes()
{
  return { Transform, Turn, Transpose, Separate, Join, ToHalf, FromHalf, StoreRows, Sample,
    Resample, Measure };
}
}
}

#endif
