// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunRayDrawer_h
#define gatunRayDrawer_h

// Draws tetrahedra into a tile of the image. Part of gatunRayLoops.h, see there.

#include "gatunRayIntegrator.h"
#include "gatunRayKernel.h"
#include "gatunRayLanes.h"

#include <cstddef>
#include <cstdint>
#include <type_traits>

// Without AVX, lanes are emulated and take several times the code. Functions that do not depend on
// the number of entries then are there once, not four times.
#if defined(__AVX2__)
#define GATUN_DRAW_INLINE GATUN_INLINE
#elif defined(__clang__)
#define GATUN_DRAW_INLINE [[gnu::noinline]]
#else
#define GATUN_DRAW_INLINE [[gnu::noinline, gnu::noclone]]
#endif

namespace gatun
{
namespace GATUN_SIMD
{
/**
 * A ray is inside a tetrahedron from the farthest plane through which it enters to the nearest one
 * through which it leaves. The pixels of a block are processed together.
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
  }

  void Draw(const TetItems& list)
  {
    for (std::size_t i = 0; i < list.Count; ++i)
    {
      const TetItem& item = list.Items[i];
      if constexpr (Shaded)
      {
        this->Shade = &list.Shades[list.Origins[i]];
      }
      switch (item.Entries)
      {
        case 0: // the eye is within
          this->DrawItem<0>(item);
          break;
        case 1:
          this->DrawItem<1>(item);
          break;
        case 2:
          this->DrawItem<2>(item);
          break;
        case 3:
          this->DrawItem<3>(item);
          break;
        default: // degenerate: rays would only enter it
          break;
      }
    }
    float limit = RayTile::Never;
    for (const RayPixels& block : this->Tile.Blocks)
    {
      for (const float far : block.Far)
      {
        limit = far > limit ? far : limit;
      }
    }
    this->Tile.Limit = limit;
  }

private:
  static constexpr bool HasFragments = Mode == RayMode::Composite || Mode == RayMode::Sampled;
  static constexpr float Endless = 1e30f;

  template <int Entries>
  GATUN_INLINE void DrawItem(const TetItem& item)
  {
    if constexpr (Mode != RayMode::Sampled && !std::is_same_v<WideLanes, Lanes8>)
    {
      // Most tetrahedra that are smaller than a few pixels fit into half a wide block.
      if ((item.FirstY ^ item.LastY) > 1 || (item.FirstX ^ item.LastX) > 3)
      {
        return this->DrawBlocks<WideLanes, Entries>(item);
      }
    }
    this->DrawBlocks<Lanes8, Entries>(item);
  }

  template <typename L, int Entries>
  void DrawBlocks(const TetItem& item)
  {
    for (int y = item.FirstY & -L::Rows; y <= item.LastY; y += L::Rows)
    {
      const auto ys = L::GetY() + L::Splat(static_cast<float>(y));
      typename L::Float rows[4];
      for (unsigned face = 0; face < 4; ++face)
      {
        rows[face] = L::Splat(item.Base[face]) + ys * L::Splat(item.StepY[face]);
      }
      for (int x = item.FirstX & -4; x <= item.LastX; x += 4)
      {
        const auto xs = L::GetX() + L::Splat(static_cast<float>(x));
        this->DrawBlock<L, Entries>(item, rows, xs, ys, RayTile::ToCell(x, y));
      }
    }
  }

  template <typename L, int Entries>
  GATUN_INLINE void DrawBlock(const TetItem& item, const typename L::Float* rows,
    typename L::Float xs, typename L::Float ys, int cell)
  {
    const auto getDepth = [&](unsigned face)
    { return rows[face] + xs * L::Splat(item.StepX[face]); };
    auto in = L::Splat(-Endless);
    auto out = L::Splat(Endless);
    for (unsigned face = 0; face < Entries; ++face)
    {
      in = face == 0 ? getDepth(face) : L::Max(getDepth(face), in);
    }
    for (unsigned face = Entries; face < 4; ++face)
    {
      out = face == Entries ? getDepth(face) : L::Min(getDepth(face), out);
    }
    auto hits = L::Less(in, out);
    if constexpr (Perspective)
    {
      hits = L::And(hits, L::Less(in, L::Splat(0)));
    }
    if (L::ToBits(hits) != 0) // not so for most blocks around a tetrahedron
    {
      this->DrawHits<L>(item, Entries == 0, in, out, hits, xs, ys, cell);
    }
  }

  /** Draws where rays hit the tetrahedron, in which the eye may be. */
  template <typename L>
  GATUN_DRAW_INLINE void DrawHits(const TetItem& item, bool isAround, typename L::Float in,
    typename L::Float out, typename L::Mask hits, typename L::Float xs, typename L::Float ys,
    int cell)
  {
    RayPixels& block = this->Tile.GetBlock(cell);
    const unsigned lane = L::Rows == 4 ? 0 : RayTile::ToLane(cell);
    RayLine<L> line;
    const auto across = xs * L::Splat(item.TX) + ys * L::Splat(item.TY);
    if constexpr (Perspective)
    {
      const auto length = L::Load(&block.LengthPerDepth[lane]);
      in = isAround ? L::Splat(0) : -length / in; // from the eye on
      out = L::Select(L::Less(out, L::Splat(0)), -length / out, L::Splat(Endless));
      line.T = L::Splat(item.T);
      line.PerLength = (L::Splat(item.TK) + across) * L::Load(&block.DepthPerLength[lane]);
    }
    else
    {
      line.T = L::Splat(item.T) + across;
      line.PerLength = L::Splat(item.TK);
    }
    const auto near = L::Load(&block.Near[lane]);
    const auto far = L::Load(&block.Far[lane]);
    auto begin = L::Min(L::Max(in, near), far);
    auto end = L::Min(L::Max(out, near), far);
    if constexpr (Mode == RayMode::Sampled)
    {
      begin = RoundUp(begin);
      end = RoundUp(end);
    }
    hits = L::And(hits, L::Less(begin, end));
    if (L::ToBits(hits) == 0)
    {
      return;
    }
    if constexpr (Mode == RayMode::Maximum)
    {
      KeepLargest<L>(item, line, begin, end, hits, block.Slots[0].End.data() + lane);
    }
    else if constexpr (HasFragments)
    {
      this->Extend<L>(item, line, begin, end, hits, block, lane, cell);
    }
    else if (!item.Transparent)
    {
      auto sums = LoadSums<L>(block.Slots[0], lane);
      auto first = begin;
      this->Integrate<L>(item, line, begin, end, hits, sums, first);
      StoreSums<L>(block.Slots[0], lane, sums);
    }
  }

  /** Values are linear, so the largest one is at an end. */
  template <typename L>
  GATUN_INLINE static void KeepLargest(const TetItem& item, const RayLine<L>& line,
    typename L::Float begin, typename L::Float end, typename L::Mask hits, float* kept)
  {
    const auto low = L::Splat(item.TMin);
    const auto high = L::Splat(item.TMax);
    const auto largest = L::Max(line.Get(begin, low, high), line.Get(end, low, high));
    const auto before = L::Load(kept);
    L::Store(kept, L::Select(hits, L::Max(before, largest), before));
  }

  template <typename L>
  GATUN_INLINE static RaySums<L> LoadSums(const RayPixels::Slot& slot, unsigned lane)
  {
    return { L::Load(&slot.Sums[0][lane]), L::Load(&slot.Sums[1][lane]),
      L::Load(&slot.Sums[2][lane]), L::Load(&slot.Sums[3][lane]) };
  }

  template <typename L>
  GATUN_INLINE static void StoreSums(RayPixels::Slot& slot, unsigned lane, const RaySums<L>& sums)
  {
    L::Store(&slot.Sums[0][lane], sums.R);
    L::Store(&slot.Sums[1][lane], sums.G);
    L::Store(&slot.Sums[2][lane], sums.B);
    L::Store(&slot.Sums[3][lane], sums.Through);
  }

  template <typename L>
  GATUN_DRAW_INLINE void Integrate(const TetItem& item, const RayLine<L>& line,
    typename L::Float begin, typename L::Float end, typename L::Mask some, RaySums<L>& sums,
    typename L::Float& first)
  {
    if constexpr (Mode == RayMode::Sampled)
    {
      AddSamples<Shaded>(
        this->Context.Table, this->Shade, item, line, begin, end, some, sums, first);
    }
    else
    {
      RayIntegrator<L, Mode, Shaded>(this->Context.Pieces, this->Shade)
        .Add(item, line, begin, end, some, sums, first);
    }
  }

  /** Extends the fragments in slot 0, or begins them. */
  template <typename L>
  GATUN_INLINE void Extend(const TetItem& item, const RayLine<L>& line, typename L::Float begin,
    typename L::Float end, typename L::Mask hits, RayPixels& block, unsigned lane, int cell)
  {
    RayPixels::Slot& slot = block.Slots[0];
    const auto last = L::Load(&slot.End[lane]);
    const auto fresh = L::And(hits, L::Equal(last, L::Splat(RayTile::Never)));
    const auto longer = L::Or(fresh, L::And(hits, L::Equal(last, begin)));
    L::Store(&slot.End[lane], L::Select(longer, end, last));
    if (L::ToBits(fresh) != 0)
    {
      L::Store(&slot.Begin[lane], L::Select(fresh, begin, L::Load(&slot.Begin[lane])));
    }
    const auto next = L::Load(&block.Slots[1].Begin[lane]);
    unsigned touching = L::ToBits(L::And(longer, L::Equal(next, end)));
    const auto others = L::Without(hits, longer);
    this->Grow<L>(item, line, begin, end, longer, block, slot, lane);
    if (L::ToBits(others) != 0) [[unlikely]]
    {
      touching |= this->PlaceElsewhere<L>(item, line, begin, end, others, block, lane, cell);
    }
    if (touching != 0) [[unlikely]]
    {
      this->Merge(cell, touching);
    }
  }

  /** Adds the segments in a tetrahedron to some fragments of a slot. Notes where they begin to be
   * visible, and skips everything behind opaque ones. */
  template <typename L>
  GATUN_INLINE void Grow(const TetItem& item, const RayLine<L>& line, typename L::Float begin,
    typename L::Float end, typename L::Mask some, RayPixels& block, RayPixels::Slot& slot,
    unsigned lane)
  {
    if (item.Transparent)
    {
      return;
    }
    auto first = begin;
    auto sums = LoadSums<L>(slot, lane);
    const auto before = sums.Through;
    this->Integrate<L>(item, line, begin, end, some, sums, first);
    StoreSums<L>(slot, lane, sums);
    const auto one = L::Splat(1);
    const auto seen = L::Without(L::And(some, L::Equal(before, one)), L::Equal(sums.Through, one));
    const auto opaque = L::And(some, L::Less(sums.Through, L::Splat(this->Context.Opaque)));
    if (L::ToBits(L::Or(seen, opaque)) != 0)
    {
      L::Store(&slot.First[lane], L::Select(seen, first, L::Load(&slot.First[lane])));
      const auto far = L::Load(&block.Far[lane]);
      L::Store(&block.Far[lane], L::Select(opaque, L::Min(end, far), far));
    }
  }

  /** Extends fragments in slot 1, or begins them there. Returns those that touch slot 0. */
  template <typename L>
  [[gnu::noinline]] unsigned PlaceElsewhere(const TetItem& item, const RayLine<L>& line,
    typename L::Float begin, typename L::Float end, typename L::Mask others, RayPixels& block,
    unsigned lane, int cell)
  {
    RayPixels::Slot& slot = block.Slots[1];
    const auto never = L::Splat(RayTile::Never);
    const auto last = L::Load(&slot.End[lane]);
    const auto apart = L::Without(others, L::Equal(last, begin));
    for (unsigned bits = L::ToBits(L::Without(apart, L::Equal(last, never))); bits != 0;
         bits &= bits - 1)
    {
      this->Tile.SetAside(1, cell + __builtin_ctz(bits));
    }
    L::Store(&slot.Begin[lane], L::Select(apart, begin, L::Load(&slot.Begin[lane])));
    L::Store(&slot.End[lane], L::Select(others, end, last));
    this->Grow<L>(item, line, begin, end, others, block, slot, lane);
    return L::ToBits(L::And(others, L::Equal(L::Load(&block.Slots[0].Begin[lane]), end)));
  }

  void Merge(int cell, unsigned touching)
  {
    for (; touching != 0; touching &= touching - 1)
    {
      const int at = cell + __builtin_ctz(touching);
      this->Tile.MergeSlots(at);
      RayPixels& block = this->Tile.GetBlock(at);
      const unsigned lane = RayTile::ToLane(at);
      const RayPixels::Slot& merged = block.Slots[0];
      if (merged.Sums[3][lane] < this->Context.Opaque)
      {
        float& far = block.Far[lane];
        far = merged.End[lane] < far ? merged.End[lane] : far;
      }
    }
  }

  const DrawContext& Context;
  RayTile& Tile;
  const RayShade* Shade = nullptr; // of the tetrahedron that is being drawn
};
}
}

#endif
