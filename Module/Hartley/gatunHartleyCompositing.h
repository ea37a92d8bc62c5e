// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyCompositing_h
#define gatunHartleyCompositing_h

// Blocks to slabs, and slabs to pixels. Compiled once for each instruction set; see gatunSimd.h.

#include "gatunHartleyKernel.h"
#include "gatunHartleyLaneLoops.h"
#include "gatunSimd.h"

namespace gatun
{
namespace GATUN_SIMD
{
// Rays with fewer samples in a block do not determine its mean density.
constexpr float FewestSamples = 0.005f;

//------------------------------------------------------------------------------
/** The transmittance of an optical depth, which is not negative, and the opacity. */
struct Shade
{
  Float8 Transmittance, Opacity;
};

GATUN_INLINE Shade ToShade(const Float8& depth)
{
  // exp(-depth) = 2^-whole * 2^part, part from -1/2 to 1/2.
  const Float8 power = Smaller(depth * Splat8(1.4426950408889634f), Splat8(126.0f));
  const Int8 whole = __builtin_convertvector(power + Splat8(0.5f), Int8);
  const Float8 part = __builtin_convertvector(whole, Float8) - power;
  // The Taylor series of 2^part - 1; its error is 1e-8 of part.
  Float8 less = Splat8(1.5252734e-5f);
  less = less * part + Splat8(1.5403530e-4f);
  less = less * part + Splat8(1.3333558e-3f);
  less = less * part + Splat8(9.6181291e-3f);
  less = less * part + Splat8(5.5504109e-2f);
  less = less * part + Splat8(2.4022651e-1f);
  less = less * part + Splat8(6.9314718e-1f);
  less *= part;
  const Float8 scale = reinterpret_cast<Float8>((127 - whole) << 23);
  // If whole is 0, the opacity has no rounding errors of a difference.
  return { scale + scale * less, (Splat8(1.0f) - scale) - scale * less };
}

//------------------------------------------------------------------------------
GATUN_INLINE Float8 Gather(const float* from, const Int8& places)
{
#if defined(__AVX2__)
  return _mm256_i32gather_ps(from, reinterpret_cast<__m256i>(places), 4);
#else
  Float8 found{};
  for (int i = 0; i < 8; ++i)
  {
    found[i] = from[places[i]];
  }
  return found;
#endif
}

GATUN_INLINE void AddTo(float* to, const Float8& value)
{
  Store(to, Load<Float8>(to) + value);
}

//------------------------------------------------------------------------------
template <HartleyOpacityModel Model, std::size_t Colors>
inline void AddColors(const HartleyOpacity& opacities, const float* image, const float* unit,
  std::size_t count, float* planes, std::size_t plane)
{
  constexpr bool exponential = Model == HartleyOpacityModel::Exponential;
  const Float8 one = Splat8(1.0f);
  for (std::size_t i = 0; i < count; i += 8)
  {
    const Float8 samples = Load<Float8>(unit + i);
    Int8 counts = samples >= Splat8(FewestSamples);
    const Float8 first = image ? Load<Float8>(image + i) : Float8{};
    Float8 depth{};
    if constexpr (exponential)
    {
      // Equation 6: the opacity does not depend on the mean.
      depth =
        Splat8(opacities.Extinction) * Larger(first + samples * Splat8(opacities.Zero), Float8{});
      counts &= depth > Float8{};
    }
    if (ToBits(counts) == 0)
    {
      continue;
    }
    const Float8 mean = first / (counts ? samples : one) + Splat8(opacities.Base);
    const Float8 clamped = Smaller(Larger(mean, Splat8(opacities.Least)), Splat8(opacities.Most));
    const Float8 at =
      (clamped - Splat8(opacities.First)) * Splat8(opacities.PerDensity) + Splat8(0.5f);
    const Int8 entry = __builtin_convertvector(
      Smaller(Larger(at, Float8{}), Splat8(static_cast<float>(HartleyOpacity::TableSize - 1))),
      Int8);
    float* const last = planes + Colors * plane + i;
    const Float8 behind = Load<Float8>(last);
    Float8 weight;
    if constexpr (exponential)
    {
      depth = counts ? depth : Float8{};
      weight = ToShade(Larger(behind, Float8{})).Transmittance * ToShade(depth).Opacity;
      // The optical depth is linear in the densities.
      Store(last, behind + depth);
    }
    else
    {
      // Equation 7: 1 - (1 - O)^n.
      depth = counts ? samples * Gather(opacities.Table + Colors * HartleyOpacity::TableSize, entry)
                     : depth;
      weight = (one - behind) * ToShade(depth).Opacity;
      Store(last, behind + weight);
    }
    // Equations 8 to 10.
    for (std::size_t color = 0; color < Colors; ++color)
    {
      AddTo(planes + color * plane + i,
        weight * Gather(opacities.Table + color * HartleyOpacity::TableSize, entry));
    }
  }
}

//------------------------------------------------------------------------------
inline void AddSums(
  const float* image, const float* unit, std::size_t count, float* planes, std::size_t plane)
{
  for (std::size_t i = 0; i < count; i += 8)
  {
    const Float8 samples = Larger(Load<Float8>(unit + i), Float8{});
    if (image)
    {
      AddTo(planes + i, samples > Float8{} ? Load<Float8>(image + i) : Float8{});
    }
    AddTo(planes + plane + i, samples);
  }
}

inline void AddBlock(const HartleyOpacity& opacities, const float* image, const float* unit,
  std::size_t count, float* planes, std::size_t plane)
{
  constexpr auto exponential = HartleyOpacityModel::Exponential;
  constexpr auto transfer = HartleyOpacityModel::TransferFunction;
  switch (opacities.Model)
  {
    case HartleyOpacityModel::XRay:
      return AddSums(image, unit, count, planes, plane);
    case exponential:
      return opacities.Planes == 2
        ? AddColors<exponential, 1>(opacities, image, unit, count, planes, plane)
        : AddColors<exponential, 3>(opacities, image, unit, count, planes, plane);
    case transfer:
      return opacities.Planes == 2
        ? AddColors<transfer, 1>(opacities, image, unit, count, planes, plane)
        : AddColors<transfer, 3>(opacities, image, unit, count, planes, plane);
  }
}

//------------------------------------------------------------------------------
/** Where eight pixels are in a lattice, and the weights of four points across and down. */
struct PixelPlaces
{
  std::int32_t First[8]; // of the four by four points
  Float8 Across[8];      // of each pixel, twice
  float Down[4][8];
};

/** R. G. Keys: Cubic convolution interpolation for digital image processing. IEEE Transactions on
 * Acoustics, Speech, and Signal Processing 29(6), 1981. */
GATUN_INLINE void GetCubicWeights(const Float8& x, Float8* weights)
{
  const Float8 y = Splat8(1.0f) - x;
  const Float8 half = Splat8(-0.5f), one = Splat8(1.0f);
  weights[0] = half * x * y * y;
  weights[1] = one + x * x * (Splat8(1.5f) * x - Splat8(2.5f));
  weights[2] = one + y * y * (Splat8(1.5f) * y - Splat8(2.5f));
  weights[3] = half * y * x * x;
}

GATUN_INLINE Float8 Join(const Float4& low, const Float4& high)
{
  return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
}

/** The whole part and the rest of eight positions from 1 to highest. Rounding may put the first and
 * the last one just outside. */
GATUN_INLINE void Divide(double first, double step, double highest, Int8& whole, Float8& part)
{
  Int4 wholes[2];
  Float4 parts[2];
  for (int half = 0; half < 2; ++half)
  {
    const double begin = 4.0 * half;
    const Double4 lanes{ begin, begin + 1, begin + 2, begin + 3 };
    const Double4 at =
      Smaller(Larger(SplatD(first) + lanes * SplatD(step), SplatD(1.0)), SplatD(highest));
    wholes[half] = __builtin_convertvector(at, Int4);
    parts[half] =
      __builtin_convertvector(at - __builtin_convertvector(wholes[half], Double4), Float4);
  }
  whole = __builtin_shufflevector(wholes[0], wholes[1], 0, 1, 2, 3, 4, 5, 6, 7);
  part = Join(parts[0], parts[1]);
}

GATUN_INLINE void Place(
  const HartleyPlanes& slab, const HartleyRow& row, std::size_t first, PixelPlaces& places)
{
  const auto number = static_cast<double>(first);
  Int8 column, line;
  Float8 x, y, weights[8];
  Divide(row.X + number * row.StepX, row.StepX, slab.HighestX, column, x);
  Divide(row.Y + number * row.StepY, row.StepY, slab.HighestY, line, y);
  Store(places.First, (line - 1) * static_cast<std::int32_t>(slab.Stride) + column - 1);
  GetCubicWeights(x, places.Across);
  for (std::size_t i = 0; i < 4; ++i)
  {
    places.Across[4 + i] = places.Across[i];
  }
  Transpose8(places.Across);
  GetCubicWeights(y, weights);
  for (std::size_t i = 0; i < 4; ++i)
  {
    Store(places.Down[i], weights[i]);
  }
}

//------------------------------------------------------------------------------
/** Sums of neighbors in two vectors. */
GATUN_INLINE Float8 AddPairs(const Float8& a, const Float8& b)
{
  return __builtin_shufflevector(a, b, 0, 2, 8, 10, 4, 6, 12, 14) +
    __builtin_shufflevector(a, b, 1, 3, 9, 11, 5, 7, 13, 15);
}

/** Interpolates two planes at eight pixels. */
GATUN_INLINE void Interpolate(
  const float* from, const HartleyPlanes& slab, const PixelPlaces& places, Float8* channels)
{
  Float8 sums[8];
  for (std::size_t i = 0; i < 8; ++i)
  {
    const float* const low = from + places.First[i];
    const float* const high = low + slab.Plane;
    Float8 sum{};
    for (std::size_t k = 0; k < 4; ++k)
    {
      sum += Splat8(places.Down[k][i]) *
        Join(Load<Float4>(low + k * slab.Stride), Load<Float4>(high + k * slab.Stride));
    }
    sums[i] = sum * places.Across[i];
  }
  const Float8 one = AddPairs(AddPairs(sums[0], sums[1]), AddPairs(sums[2], sums[3]));
  const Float8 two = AddPairs(AddPairs(sums[4], sums[5]), AddPairs(sums[6], sums[7]));
  channels[0] = __builtin_shufflevector(one, two, 0, 1, 2, 3, 8, 9, 10, 11);
  channels[1] = __builtin_shufflevector(one, two, 4, 5, 6, 7, 12, 13, 14, 15);
}

//------------------------------------------------------------------------------
/** Composites eight pixels. */
template <HartleyOpacityModel Model, std::size_t Colors>
GATUN_INLINE void AddPixels(const Float8* channels, float* pixels, std::size_t plane)
{
  if constexpr (Model == HartleyOpacityModel::XRay)
  {
    AddTo(pixels, channels[0]);
    AddTo(pixels + plane, channels[1]);
    return;
  }
  const Float8 opaque = Larger(channels[Colors], Float8{});
  if (ToBits(Int8(opaque > Float8{})) == 0)
  {
    return;
  }
  const Float8 opacity = Model == HartleyOpacityModel::Exponential ? ToShade(opaque).Opacity
                                                                   : Smaller(opaque, Splat8(1.0f));
  const Float8 through = Load<Float8>(pixels + Colors * plane);
  for (std::size_t color = 0; color < Colors; ++color)
  {
    // The interpolation overshoots at edges; a premultiplied color must not exceed the opacity.
    AddTo(pixels + color * plane, through * Smaller(Larger(channels[color], Float8{}), opacity));
  }
  Store(pixels + Colors * plane, through * (Splat8(1.0f) - opacity));
}

template <HartleyOpacityModel Model, std::size_t Colors>
inline void AddRow(
  const HartleyPlanes& slab, const HartleyRow& row, float* pixels, std::size_t plane)
{
  constexpr std::size_t planes = Colors + 1;
  PixelPlaces places;
  Float8 channels[planes];
  for (std::size_t i = 0; i < row.Count; i += 8)
  {
    Place(slab, row, i, places);
    for (std::size_t k = 0; k < planes; k += 2)
    {
      Interpolate(slab.Values + k * slab.Plane, slab, places, channels + k);
    }
    if (i + 8 <= row.Count)
    {
      AddPixels<Model, Colors>(channels, pixels + i, plane);
      continue;
    }
    float rest[8 * planes] = {};
    for (std::size_t k = 0; k < planes; ++k)
    {
      for (std::size_t p = i; p < row.Count; ++p)
      {
        rest[8 * k + p - i] = pixels[k * plane + p];
      }
    }
    AddPixels<Model, Colors>(channels, rest, 8);
    for (std::size_t k = 0; k < planes; ++k)
    {
      for (std::size_t p = i; p < row.Count; ++p)
      {
        pixels[k * plane + p] = rest[8 * k + p - i];
      }
    }
  }
}

inline void AddSlab(const HartleyOpacity& opacities, const HartleyPlanes& slab,
  const HartleyRow& row, float* pixels, std::size_t plane)
{
  constexpr auto exponential = HartleyOpacityModel::Exponential;
  constexpr auto transfer = HartleyOpacityModel::TransferFunction;
  switch (opacities.Model)
  {
    case HartleyOpacityModel::XRay:
      return AddRow<HartleyOpacityModel::XRay, 1>(slab, row, pixels, plane);
    case exponential:
      return opacities.Planes == 2 ? AddRow<exponential, 1>(slab, row, pixels, plane)
                                   : AddRow<exponential, 3>(slab, row, pixels, plane);
    case transfer:
      return opacities.Planes == 2 ? AddRow<transfer, 1>(slab, row, pixels, plane)
                                   : AddRow<transfer, 3>(slab, row, pixels, plane);
  }
}
}
}

#endif
