// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunRayDrawer_h
#define gatunRayDrawer_h

// Draws tetrahedra into a tile of the image. Part of gatunRayLoops.h, see there.

#include "gatunRayKernel.h"
#include "gatunSimd.h"

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace gatun
{
namespace GATUN_SIMD
{
/** The length of the ray of a pixel from the eye to depth 1, in a perspective projection. */
GATUN_INLINE double GetLengthPerDepth(const RayView& view, double x, double y)
{
  const double u = (x - view.CenterX) * view.ScaleX;
  const double v = (y - view.CenterY) * view.ScaleY;
  return __builtin_sqrt(1 + u * u + v * v);
}

/**
 * A ray is inside a tetrahedron from the farthest plane through which it enters to the nearest one
 * through which it leaves. The samples in between belong to the tetrahedron. Eight pixels are
 * processed together, four by two. Samples go into a queue, so that a single loop without
 * unpredictable branches looks up the colors of many. Each sample has the index of the sum to which
 * it is added, and the queue keeps the order of the samples of each sum.
 *
 * A tetrahedron directly behind the fragment of a pixel extends that fragment. Any other begins a
 * fragment of its own, and fragments that touch are merged. So the order of the tetrahedra affects
 * the speed, not the image.
 */
template <bool Perspective, RayMode Mode, bool Shaded>
class RayDrawer
{
public:
  RayDrawer(const DrawContext& context, RayTile& tile)
    : Context(context)
    , Tile(tile)
  {
    if constexpr (Perspective)
    {
      const RayView& view = *context.View;
      for (int cell = 0; cell < RayTile::Cells; ++cell)
      {
        const int x = context.X + cell % RayTile::Stride;
        const int y = context.Y + cell / RayTile::Stride;
        this->SamplesPerDepth[cell] =
          static_cast<float>(GetLengthPerDepth(view, x, y) / view.SampleDistance);
      }
    }
  }

  void Draw(const TetItems& list)
  {
    this->Shades = list.Shades;
    const TetItem* const items = list.Items;
    for (std::size_t i = 0; i < list.Count; ++i)
    {
      if constexpr (Shaded)
      {
        this->Shade = static_cast<std::int32_t>(list.Origins[i]);
      }
      switch (items[i].Entries)
      {
        case 0: // the eye is within
          this->DrawItem<0>(items[i]);
          break;
        case 1:
          this->DrawItem<1>(items[i]);
          break;
        case 2:
          this->DrawItem<2>(items[i]);
          break;
        case 3:
          this->DrawItem<3>(items[i]);
          break;
        default: // degenerate: rays would only enter it
          break;
      }
    }
    this->Flush();
    float limit = RayTile::Never;
    for (int y = 0; y < RayTile::Size; ++y)
    {
      for (int x = 0; x < RayTile::Size; ++x)
      {
        const float far = this->Tile.Far[y * RayTile::Stride + x];
        limit = far > limit ? far : limit;
      }
    }
    this->Tile.Limit = limit;
  }

private:
  static constexpr bool HasFragments = Mode == RayMode::Composite || Mode == RayMode::Area;
  static constexpr float Endless = 1e30f;
  static constexpr unsigned Most = 1024; // samples in the queue

  /** Four by two pixels that a tetrahedron covers. */
  struct Block
  {
    int Cell;
    int Pixel;
    unsigned Bits; // which of them are hit
    Float8 Begin, End;
    Float8 T, TPerSample;
    Int8 Sums; // to which sum each adds, the slots' one after the other
  };

  static Float8 LoadCells(const float* cells, int first)
  {
    return Load44(cells + first, cells + first + RayTile::Stride);
  }

  static void StoreCells(float* cells, int first, Float8 v)
  {
    Store44(cells + first, cells + first + RayTile::Stride, v);
  }

  template <int Entries>
  void DrawItem(const TetItem& item)
  {
    for (int y = item.FirstY; y <= item.LastY; y += 2)
    {
      for (int x = item.FirstX; x <= item.LastX; x += 4)
      {
        this->DrawBlock<Entries>(item, x, y);
      }
    }
  }

  template <int Entries>
  GATUN_INLINE void DrawBlock(const TetItem& item, int x, int y)
  {
    const auto xs = Float8{ 0, 1, 2, 3, 0, 1, 2, 3 } + Splat8(static_cast<float>(x));
    const auto ys = Float8{ 0, 0, 0, 0, 1, 1, 1, 1 } + Splat8(static_cast<float>(y));
    const auto getDepth = [&](int face) {
      return Splat8(item.Base[face]) + xs * Splat8(item.StepX[face]) +
        ys * Splat8(item.StepY[face]);
    };
    Float8 in = Splat8(-Endless);
    Float8 out = Splat8(Endless);
    for (int face = 0; face < Entries; ++face)
    {
      in = Larger(getDepth(face), in);
    }
    for (int face = Entries; face < 4; ++face)
    {
      out = Smaller(getDepth(face), out);
    }
    Int8 hits = in < out;
    if (ToBits(hits) == 0)
    {
      return; // most blocks around a tetrahedron
    }

    Block block;
    block.Cell = y * RayTile::Stride + x;
    const auto across = xs * Splat8(item.TX) + ys * Splat8(item.TY);
    if constexpr (Perspective)
    {
      hits &= in < Splat8(0);
      const auto samples = LoadCells(this->SamplesPerDepth, block.Cell);
      in = Entries == 0 ? Splat8(0) : -samples / in; // from the eye on
      out = out < Splat8(0) ? -samples / out : Splat8(Endless);
      block.T = Splat8(item.T);
      block.TPerSample = (Splat8(item.TK) + across) / samples;
    }
    else
    {
      block.T = Splat8(item.T) + across;
      block.TPerSample = Splat8(item.TK);
    }
    const auto near = LoadCells(this->Tile.Near.data(), block.Cell);
    const auto far = LoadCells(this->Tile.Far.data(), block.Cell);
    block.Begin = Smaller(Larger(in, near), far);
    block.End = Smaller(Larger(out, near), far);
    if constexpr (Mode != RayMode::Area)
    {
      block.Begin = RoundUp(block.Begin);
      block.End = RoundUp(block.End);
    }
    hits &= block.Begin < block.End;
    block.Bits = ToBits(hits);
    if (block.Bits == 0)
    {
      return;
    }

    constexpr int row = RayTile::Size;
    block.Pixel = y * row + x;
    block.Sums = Int8{ 0, 1, 2, 3, row, row + 1, row + 2, row + 3 } + block.Pixel;
    if constexpr (Mode == RayMode::Maximum)
    {
      this->KeepLargest(item, block, hits);
      return;
    }
    if constexpr (HasFragments)
    {
      const unsigned touching = this->Place(block, hits);
      this->Sample(item, block);
      if (touching != 0) [[unlikely]]
      {
        this->Merge(block, touching);
      }
    }
    else
    {
      this->Sample(item, block);
    }
  }

  GATUN_INLINE static Float8 GetPlaceInTable(
    const TetItem& item, const Block& block, Float8 samples)
  {
    // Rounding must not lead out of the values that the tetrahedron has.
    const auto t = block.T + block.TPerSample * samples;
    return Smaller(Larger(t, Splat8(item.TMin)), Splat8(item.TMax));
  }

  GATUN_INLINE void Sample(const TetItem& item, const Block& block)
  {
    if (item.Transparent)
    {
      return;
    }
    if constexpr (Mode == RayMode::Area)
    {
      const auto middle = (block.Begin + block.End) * Splat8(0.5f);
      const auto length = block.End - block.Begin;
      this->Wait(block, block.Bits, GetPlaceInTable(item, block, middle), block.Begin, length);
    }
    else
    {
      auto sample = block.Begin;
      unsigned bits = block.Bits;
      do
      {
        this->Wait(block, bits, GetPlaceInTable(item, block, sample), sample, sample);
        sample += Splat8(1);
        bits &= ToBits(sample < block.End);
      } while (bits != 0);
    }
  }

  GATUN_INLINE void Wait(
    const Block& block, unsigned bits, Float8 places, Float8 samples, Float8 lengths)
  {
    const Packer packer(bits);
    packer.Store(places, this->Places + this->Waiting);
    packer.Store(block.Sums, this->Sums + this->Waiting);
    packer.Store(samples, this->Samples + this->Waiting);
    if constexpr (Mode == RayMode::Area)
    {
      packer.Store(lengths, this->Lengths + this->Waiting);
    }
    if constexpr (Shaded)
    {
      Store(this->ShadesOf + this->Waiting, Int8{} + this->Shade);
    }
    this->Waiting += static_cast<unsigned>(__builtin_popcount(bits));
    if (this->Waiting > Most) [[unlikely]]
    {
      this->Flush();
    }
  }

  /** Adds the samples in the queue to their sums. */
  void Flush()
  {
    RayTile& tile = this->Tile;
    auto* const sums = tile.Sums[0].data();
    for (unsigned i = 0; i < this->Waiting; ++i)
    {
      const float place = this->Places[i];
      const auto index = static_cast<int>(place);
      const RayTable::Cell& cell = this->Context.Table[index];
      const auto fraction = Splat4(place - static_cast<float>(index));
      auto color = Load<Float4>(&cell.Value) + fraction * Load<Float4>(&cell.Change);
      const auto at = this->Sums[i];
      auto sum = Load<Float4>(&sums[at]);
      if constexpr (Mode == RayMode::XRay)
      {
        sum += color;
      }
      else
      {
        if constexpr (Mode == RayMode::Area)
        {
          const float opacity = 1 - std::exp(-color[3] * this->Lengths[i]);
          color = color * Splat4(opacity);
          color[3] = -opacity;
        }
        if constexpr (Shaded)
        {
          // Not brighter than white.
          const RayShade& shade = this->Shades[this->ShadesOf[i]];
          const auto opacity = Splat4(-color[3]);
          color = Smaller(
            color * Load<Float4>(&shade.Scale) + opacity * Load<Float4>(&shade.Add), opacity);
        }
        const auto before = __builtin_shufflevector(sum, sum, 3, 3, 3, 3);
        sum += before * color;
        if (before[0] == 1 && sum[3] != 1) [[unlikely]]
        {
          tile.Firsts[0].data()[at] = this->Samples[i];
        }
        if (sum[3] < this->Context.Opaque) [[unlikely]]
        {
          const float length = Mode == RayMode::Area ? this->Lengths[i] : 1;
          this->HideFrom(RayTile::ToCell(at % RayTile::Pixels), this->Samples[i] + length);
        }
      }
      Store(&sums[at], sum);
    }
    this->Waiting = 0;
  }

  /** Skips everything behind an opaque sample. */
  void HideFrom(int cell, float end)
  {
    float& far = this->Tile.Far[cell];
    far = end < far ? end : far;
  }

  /** Finds or begins the fragment of each pixel. Returns the pixels with two fragments that touch.
   */
  GATUN_INLINE unsigned Place(Block& block, Int8 hits)
  {
    RayTile& tile = this->Tile;
    const auto end = LoadCells(tile.End[0].data(), block.Cell);
    const auto fresh = hits & (end == Splat8(RayTile::Never));
    const auto longer = fresh | (hits & (end == block.Begin));
    StoreCells(tile.End[0].data(), block.Cell, longer ? block.End : end);
    if (ToBits(fresh) != 0)
    {
      const auto begin = LoadCells(tile.Begin[0].data(), block.Cell);
      StoreCells(tile.Begin[0].data(), block.Cell, fresh ? block.Begin : begin);
    }
    const auto next = LoadCells(tile.Begin[1].data(), block.Cell);
    unsigned touching = ToBits(longer & (next == block.End));
    unsigned others = block.Bits & ~ToBits(longer);
    for (; others != 0; others &= others - 1)
    {
      const auto lane = static_cast<unsigned>(__builtin_ctz(others));
      const int cell = block.Cell + ToCell(lane);
      this->PlaceElsewhere(cell, block.Pixel + ToPixel(lane), block.Begin[lane], block.End[lane]);
      block.Sums[lane] += RayTile::Pixels;
      touching |= tile.Begin[0][cell] == block.End[lane] ? 1u << lane : 0u;
    }
    return touching;
  }

  static int ToCell(unsigned lane)
  {
    return static_cast<int>(lane / 4 * RayTile::Stride + lane % 4);
  }
  static int ToPixel(unsigned lane)
  {
    return static_cast<int>(lane / 4 * RayTile::Size + lane % 4);
  }

  /** Extends the fragment in slot 1, or begins one there. */
  void PlaceElsewhere(int cell, int pixel, float begin, float end)
  {
    RayTile& tile = this->Tile;
    if (tile.End[1][cell] != begin)
    {
      if (tile.End[1][cell] != RayTile::Never)
      {
        this->Flush();
        tile.SetAside(1, pixel);
      }
      tile.Begin[1][cell] = begin;
    }
    tile.End[1][cell] = end;
  }

  void Merge(const Block& block, unsigned touching)
  {
    this->Flush();
    for (; touching != 0; touching &= touching - 1)
    {
      const auto lane = static_cast<unsigned>(__builtin_ctz(touching));
      const int cell = block.Cell + ToCell(lane);
      this->Tile.MergeSlots(block.Pixel + ToPixel(lane));
      if (this->Tile.Sums[0][block.Pixel + ToPixel(lane)][3] < this->Context.Opaque)
      {
        this->HideFrom(cell, this->Tile.End[0][cell]);
      }
    }
  }

  /** Values are linear, so the largest one is at an end. */
  GATUN_INLINE void KeepLargest(const TetItem& item, const Block& block, Int8 hits)
  {
    const auto first = GetPlaceInTable(item, block, block.Begin);
    const auto last = GetPlaceInTable(item, block, block.End - Splat8(1));
    auto* const largest = this->Tile.End[0].data();
    const auto before = LoadCells(largest, block.Cell);
    const auto now = hits ? Larger(first, last) : before;
    StoreCells(largest, block.Cell, Larger(before, now));
  }

  const DrawContext& Context;
  RayTile& Tile;
  const RayShade* Shades = nullptr;
  std::int32_t Shade = 0; // of the tetrahedron that is being drawn
  unsigned Waiting = 0;
  float Places[Most + 16]; // in the table
  std::int32_t Sums[Most + 16];
  float Samples[Most + 16];
  float Lengths[Mode == RayMode::Area ? Most + 16 : 1];
  std::int32_t ShadesOf[Shaded ? Most + 16 : 1];
  float SamplesPerDepth[Perspective ? RayTile::Cells : 1];
};
}
}

#endif
