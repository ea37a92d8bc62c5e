// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunRayIntegrator_h
#define gatunRayIntegrator_h

// Color and opacity of a segment of each ray in a block of pixels. Part of gatunRayLoops.h, see
// there.

#include "gatunRayKernel.h"
#include "gatunRayLanes.h"

#include <cstdint>

namespace gatun
{
namespace GATUN_SIMD
{
/** Colors along rays through a tetrahedron, linear in the distance: red, green and blue. */
template <typename L>
struct RayHueLine
{
  using Float = typename L::Float;
  Float T[3], PerLength[3];
  float Low[3], High[3];

  GATUN_INLINE Float Get(unsigned channel, Float distance) const
  {
    return L::Min(
      L::Max(this->T[channel] + this->PerLength[channel] * distance, L::Splat(this->Low[channel])),
      L::Splat(this->High[channel]));
  }
};

/** Places in the table along rays through a tetrahedron: linear in the distance. */
template <typename L>
struct RayLine
{
  using Float = typename L::Float;
  Float T, PerLength;
  const RayHueLine<L>* Hues = nullptr; // if colors are not those of the table

  /** Rounding must not lead out of the values that the tetrahedron has. */
  GATUN_INLINE Float Get(Float distance, Float low, Float high) const
  {
    return L::Min(L::Max(this->T + this->PerLength * distance, low), high);
  }
};

/** The sums of fragments: premultiplied color and transmittance. In mode XRay, the last is 1 plus
 * the optical depth. */
template <typename L>
struct RaySums
{
  typename L::Float R, G, B, Through;
};

/**
 * Integrates segments in closed form, without looking up or interpolating anything per pixel.
 *
 * Within a piece of the transfer function, color times extinction and extinction are parabolas of
 * the value, c0 + c1 x + c2 x^2, and the value is linear along the ray. With x the value in the
 * middle of the segment and h half of its change along it, the mean of the parabola is
 * c0 + c1 x + c2 (x^2 + h^2 / 3). The optical depth D is the mean extinction times the length, and
 * the color is the mean color times the length, attenuated by (1 - exp(-D)) / D. Colors of a
 * RayHueLine are linear along the segment, and their mean, weighted by the extinction, is that of
 * the product of a line and a parabola. This assumes that
 * the color does not change much over the length at which light fades. So segments are cut where
 * the value leaves a piece. If D is large, they are cut into equal slices, and the linear term of
 * the color is weighted by the attenuation within the slice.
 */
template <typename L, RayMode Mode, RayLook Look>
class RayIntegrator
{
public:
  using Float = typename L::Float;
  using Mask = typename L::Mask;
  using Piece = RayTable::Piece;

  GATUN_INLINE RayIntegrator(const Piece* pieces, const RayShade* shade, const RayHueLine<L>* hue)
    : Pieces(pieces)
    , Shade(shade)
    , Hue(hue)
  {
  }

  /** Adds the segments from begin to end in some lanes. First becomes the beginning of the first
   * visible part of a segment, in lanes that have one and were fully transparent. */
  GATUN_INLINE void Add(const TetItem& item, const RayLine<L>& line, Float begin, Float end,
    Mask some, RaySums<L>& sums, Float& first) const
  {
    if (item.FirstPiece == item.LastPiece) [[likely]]
    {
      const auto length = L::Select(some, end - begin, L::Splat(0));
      this->AddPart(this->Pieces[item.FirstPiece], item.TMin, item.TMax, line, begin, length, sums);
    }
    else
    {
      this->AddPieces(item, line, begin, end, some, sums, first);
    }
  }

private:
  static constexpr float Thick = 0.25f; // optical depth up to which one term suffices
  static constexpr float Endless = 1e30f;

  /** A part of a segment within a piece: the value in its middle, relative to the piece's center;
   * its mean square; its length; half of the change of the value along it; and where its middle is.
   */
  struct Part
  {
    Float X, Square, Length, HalfChange, Middle;
  };

  GATUN_INLINE static Part MakePart(
    const Piece& piece, float tMin, float tMax, const RayLine<L>& line, Float begin, Float length)
  {
    const auto half = length * L::Splat(0.5f);
    const auto x = line.Get(begin + half, L::Splat(tMin), L::Splat(tMax)) - L::Splat(piece.Center);
    // The value cannot change by more than that of the tetrahedron, whatever rounding says.
    const auto bound = L::Splat(0.5f * (tMax - tMin));
    const auto h = L::Max(L::Min(line.PerLength * half, bound), -bound);
    const auto spread = h * h * L::Splat(1.0f / 3);
    return { x, x * x + spread, length, h, begin + half };
  }

  /** The mean of a channel of a piece. */
  GATUN_INLINE static Float GetMean(const Piece& piece, unsigned channel, const Part& part)
  {
    return L::Splat(piece.C0[channel]) +
      (part.X * L::Splat(piece.C1[channel]) + part.Square * L::Splat(piece.C2[channel]));
  }

  /** The derivative of a channel in the middle. */
  GATUN_INLINE static Float GetSlope(const Piece& piece, unsigned channel, const Part& part)
  {
    return L::Splat(piece.C1[channel]) + part.X * L::Splat(2 * piece.C2[channel]);
  }

  GATUN_INLINE static Float GetDepth(const Piece& piece, const Part& part)
  {
    return L::Max(part.Length * GetMean(piece, 3, part), L::Splat(0));
  }

  /** (1 - exp(-depth)) / depth up to Thick. */
  GATUN_INLINE static Float Attenuate(Float depth)
  {
    auto p = L::Splat(1.0f / 120) - depth * L::Splat(1.0f / 720);
    p = L::Splat(-1.0f / 24) + depth * p;
    p = L::Splat(1.0f / 6) + depth * p;
    p = L::Splat(-0.5f) + depth * p;
    return L::Splat(1) + depth * p;
  }

  /** The same beyond it, by squaring. */
  GATUN_INLINE static Float AttenuateThick(Float depth)
  {
    const auto z = L::Min(depth, L::Splat(60)) * L::Splat(1.0f / 256);
    auto e = L::Splat(1) - z * (L::Splat(1) - z * (L::Splat(0.5f) - z * L::Splat(1.0f / 6)));
    for (int i = 0; i < 8; ++i)
    {
      e = e * e;
    }
    return (L::Splat(1) - e) / depth;
  }

  /** Adds a part with a known optical depth. Weight: the light that passes, attenuated. Corrected:
   * whether the color in front counts for more than that behind, to first order in the depth. */
  template <bool Corrected>
  GATUN_INLINE void Accumulate(
    const Piece& piece, const Part& part, Float depth, Float weight, RaySums<L>& sums) const
  {
    [[maybe_unused]] const auto lever = part.Length * part.HalfChange * L::Splat(1.0f / 6);
    const auto add = [&](unsigned channel, Float& sum)
    {
      if constexpr (Look == RayLook::Hued)
      {
        sum += weight * this->template GetHued<Corrected>(piece, part, depth, channel);
        return;
      }
      auto color = part.Length * GetMean(piece, channel, part);
      if constexpr (Corrected)
      {
        color +=
          lever * (GetSlope(piece, 3, part) * color - GetSlope(piece, channel, part) * depth);
      }
      if constexpr (Look == RayLook::Shaded)
      {
        // Not brighter than white.
        color = L::Min(color * L::Splat(this->Shade->Scale[channel]) +
            depth * L::Splat(this->Shade->Add[channel]),
          depth);
      }
      sum += weight * color;
    };
    add(0, sums.R);
    add(1, sums.G);
    add(2, sums.B);
    if constexpr (Mode == RayMode::XRay)
    {
      sums.Through += depth;
    }
    else
    {
      sums.Through -= weight * depth;
    }
  }

  /** The color of a RayHueLine times the extinction, over a part. Within it, the color is
   * c + u C and the extinction e(u), with u from -1 to 1. */
  template <bool Corrected>
  GATUN_INLINE Float GetHued(
    const Piece& piece, const Part& part, Float depth, unsigned channel) const
  {
    const auto bound = L::Splat(0.5f * (this->Hue->High[channel] - this->Hue->Low[channel]));
    const auto change =
      L::Max(L::Min(this->Hue->PerLength[channel] * part.Length * L::Splat(0.5f), bound), -bound);
    const auto middle = this->Hue->Get(channel, part.Middle);
    const auto slope = part.Length * part.HalfChange * GetSlope(piece, 3, part);
    auto color = middle * depth + change * slope * L::Splat(1.0f / 3);
    if constexpr (Corrected)
    {
      color -= change * depth * depth * L::Splat(1.0f / 6);
    }
    // Not less than black, and not brighter than white.
    return L::Max(L::Min(color, depth), L::Splat(0));
  }

  GATUN_INLINE void AddPart(const Piece& piece, float tMin, float tMax, const RayLine<L>& line,
    Float begin, Float length, RaySums<L>& sums) const
  {
    const Part part = MakePart(piece, tMin, tMax, line, begin, length);
    const auto depth = GetDepth(piece, part);
    if constexpr (Mode == RayMode::XRay)
    {
      this->template Accumulate<false>(piece, part, depth, L::Splat(1), sums);
    }
    else if (L::ToBits(L::Less(L::Splat(Thick), depth)) == 0) [[likely]]
    {
      this->template Accumulate<false>(piece, part, depth, sums.Through * Attenuate(depth), sums);
    }
    else
    {
      this->AddThick(piece, tMin, tMax, line, begin, length, depth, sums);
    }
  }

  /** Adds a part of a large optical depth in thin slices, until nothing passes. */
  [[gnu::noinline]] void AddThick(const Piece& piece, float tMin, float tMax,
    const RayLine<L>& line, Float begin, Float length, Float depth, RaySums<L>& sums) const
  {
    float most = 0;
    for (unsigned lane = 0; lane < sizeof(Float) / sizeof(float); ++lane)
    {
      most = depth[lane] > most ? depth[lane] : most;
    }
    constexpr int mostSlices = 4096;
    const int slices = most * 4 < mostSlices ? static_cast<int>(most * 4) + 1 : mostSlices;
    const auto step = length * L::Splat(1.0f / static_cast<float>(slices));
    const auto used = L::Less(L::Splat(0), length);
    const auto nothing = L::Splat(1e-7f);
    for (int i = 0; i < slices; ++i)
    {
      const auto from = begin + step * L::Splat(static_cast<float>(i));
      const Part part = MakePart(piece, tMin, tMax, line, from, step);
      const auto d = GetDepth(piece, part);
      const auto thick = L::Less(L::Splat(Thick), d);
      const auto attenuation =
        L::ToBits(thick) == 0 ? Attenuate(d) : L::Select(thick, AttenuateThick(d), Attenuate(d));
      this->template Accumulate<true>(piece, part, d, sums.Through * attenuation, sums);
      sums.Through = L::Max(sums.Through, L::Splat(0));
      if (L::ToBits(L::Without(used, L::Less(sums.Through, nothing))) == 0)
      {
        break;
      }
    }
  }

  /** Cuts segments where the value passes from one piece to another. */
  [[gnu::noinline]] void AddPieces(const TetItem& item, const RayLine<L>& line, Float begin,
    Float end, Mask some, RaySums<L>& sums, Float& first) const
  {
    // A constant value falls, but infinitely slowly.
    const auto rises = L::Less(L::Splat(0), line.PerLength);
    const auto perT = L::Splat(1) /
      L::Select(rises, line.PerLength, L::Min(line.PerLength, L::Splat(-1 / Endless)));
    const auto t0 = line.T + line.PerLength * begin;
    const auto t1 = line.T + line.PerLength * end;
    const auto low = L::Min(t0, t1);
    const auto high = L::Max(t0, t1);
    // First the rays along which the value rises, piece by piece upwards, then the others.
    for (const bool up : { true, false })
    {
      const auto these = up ? L::And(some, rises) : L::Without(some, rises);
      if (L::ToBits(these) == 0)
      {
        continue;
      }
      auto from = begin;
      const int last = up ? item.LastPiece : item.FirstPiece;
      for (int i = up ? item.FirstPiece : item.LastPiece;; i += up ? 1 : -1)
      {
        const Piece& piece = this->Pieces[i];
        const auto top = L::Splat(i == item.LastPiece ? Endless : piece.To);
        const auto bottom = L::Splat(i == item.FirstPiece ? -Endless : piece.From);
        const auto reaches = L::Without(L::And(these, L::Less(low, top)), L::Less(high, bottom));
        if (L::ToBits(reaches) != 0)
        {
          auto to = end;
          if (i != last)
          {
            const auto where = (L::Splat(up ? piece.To : piece.From) - line.T) * perT;
            to = L::Min(L::Max(where, from), end);
          }
          const auto before = sums.Through;
          const auto length = L::Select(reaches, to - from, L::Splat(0));
          this->AddPart(piece, item.TMin > piece.From ? item.TMin : piece.From,
            item.TMax < piece.To ? item.TMax : piece.To, line, from, length, sums);
          const auto one = L::Splat(1);
          const auto seen =
            L::Without(L::And(reaches, L::Equal(before, one)), L::Equal(sums.Through, one));
          first = L::Select(seen, from, first);
          from = L::Select(reaches, to, from);
        }
        if (i == last)
        {
          break;
        }
      }
    }
  }

  const Piece* Pieces;
  const RayShade* Shade;
  const RayHueLine<L>* Hue;
};

//------------------------------------------------------------------------------
/** The colors of a table at eight places, one channel in each vector. */
struct Colors8
{
  Float8 R, G, B, A;

  Colors8(const RayTable::Cell* table, Float8 places)
  {
    const auto indices = __builtin_convertvector(places, Int8);
    const auto fractions = places - __builtin_convertvector(indices, Float8);
    Float4 colors[8];
    for (unsigned lane = 0; lane < 8; ++lane)
    {
      const RayTable::Cell& cell = table[indices[lane]];
      colors[lane] =
        Load<Float4>(&cell.Value) + Splat4(fractions[lane]) * Load<Float4>(&cell.Change);
    }
    Float8 pairs[4]; // lanes i and i + 4
    for (unsigned i = 0; i < 4; ++i)
    {
      pairs[i] = __builtin_shufflevector(colors[i], colors[i + 4], 0, 1, 2, 3, 4, 5, 6, 7);
    }
    const auto rg01 = __builtin_shufflevector(pairs[0], pairs[1], 0, 8, 1, 9, 4, 12, 5, 13);
    const auto rg23 = __builtin_shufflevector(pairs[2], pairs[3], 0, 8, 1, 9, 4, 12, 5, 13);
    const auto ba01 = __builtin_shufflevector(pairs[0], pairs[1], 2, 10, 3, 11, 6, 14, 7, 15);
    const auto ba23 = __builtin_shufflevector(pairs[2], pairs[3], 2, 10, 3, 11, 6, 14, 7, 15);
    this->R = __builtin_shufflevector(rg01, rg23, 0, 1, 8, 9, 4, 5, 12, 13);
    this->G = __builtin_shufflevector(rg01, rg23, 2, 3, 10, 11, 6, 7, 14, 15);
    this->B = __builtin_shufflevector(ba01, ba23, 0, 1, 8, 9, 4, 5, 12, 13);
    this->A = __builtin_shufflevector(ba01, ba23, 2, 3, 10, 11, 6, 7, 14, 15);
  }
};

/** Mode Sampled: adds the samples from begin to end, which are whole numbers. First as in
 * RayIntegrator::Add. */
template <RayLook Look>
GATUN_INLINE void AddSamples(const RayTable::Cell* table, const RayShade* shade,
  const RayHueLine<Lanes8>* hue, const TetItem& item, const RayLine<Lanes8>& line, Float8 begin,
  Float8 end, Lanes8::Mask some, RaySums<Lanes8>& sums, Float8& first)
{
  using L = Lanes8;
  const auto zero = L::Splat(0);
  const auto one = L::Splat(1);
  auto sample = begin;
  for (auto these = some; L::ToBits(these) != 0; these = L::And(these, L::Less(sample, end)))
  {
    const Colors8 colors(table, line.Get(sample, L::Splat(item.TMin), L::Splat(item.TMax)));
    const auto before = L::Select(these, sums.Through, zero);
    const auto add = [&](Float8 color, [[maybe_unused]] unsigned channel, Float8& sum)
    {
      if constexpr (Look == RayLook::Hued)
      {
        color = -colors.A * hue->Get(channel, sample);
      }
      if constexpr (Look == RayLook::Shaded)
      {
        // Not brighter than white. The last channel is the opacity, negative.
        color =
          L::Min(color * L::Splat(shade->Scale[channel]) - colors.A * L::Splat(shade->Add[channel]),
            -colors.A);
      }
      sum += before * color;
    };
    add(colors.R, 0, sums.R);
    add(colors.G, 1, sums.G);
    add(colors.B, 2, sums.B);
    sums.Through += before * colors.A;
    first =
      L::Select(L::Without(L::Equal(before, one), L::Equal(sums.Through, one)), sample, first);
    sample += one;
  }
}
}
}

#endif
