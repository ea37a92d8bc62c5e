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
    for (const float far : this->Tile.Far)
    {
      limit = far > limit ? far : limit;
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
    if (L::ToBits(hits) == 0)
    {
      return; // most blocks around a tetrahedron
    }

    RayTile& tile = this->Tile;
    RayLine<L> line;
    const auto across = xs * L::Splat(item.TX) + ys * L::Splat(item.TY);
    if constexpr (Perspective)
    {
      const auto length = L::Load(&tile.LengthPerDepth[cell]);
      in = Entries == 0 ? L::Splat(0) : -length / in; // from the eye on
      out = L::Select(L::Less(out, L::Splat(0)), -length / out, L::Splat(Endless));
      line.T = L::Splat(item.T);
      line.PerLength = (L::Splat(item.TK) + across) * L::Load(&tile.DepthPerLength[cell]);
    }
    else
    {
      line.T = L::Splat(item.T) + across;
      line.PerLength = L::Splat(item.TK);
    }
    const auto near = L::Load(&tile.Near[cell]);
    const auto far = L::Load(&tile.Far[cell]);
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
      this->KeepLargest<L>(item, line, begin, end, hits, cell);
    }
    else if constexpr (HasFragments)
    {
      this->Extend<L>(item, line, begin, end, hits, cell);
    }
    else if (!item.Transparent)
    {
      auto sums = this->LoadSums<L>(cell);
      auto first = begin;
      this->Integrate<L>(item, line, begin, end, hits, sums, first);
      this->StoreSums<L>(cell, sums);
    }
  }

  /** Values are linear, so the largest one is at an end. */
  template <typename L>
  GATUN_INLINE void KeepLargest(const TetItem& item, const RayLine<L>& line,
    typename L::Float begin, typename L::Float end, typename L::Mask hits, int cell)
  {
    const auto low = L::Splat(item.TMin);
    const auto high = L::Splat(item.TMax);
    const auto largest = L::Max(line.Get(begin, low, high), line.Get(end, low, high));
    float* const kept = &this->Tile.End[0][cell];
    const auto before = L::Load(kept);
    L::Store(kept, L::Select(hits, L::Max(before, largest), before));
  }

  template <typename L>
  GATUN_INLINE RaySums<L> LoadSums(int cell) const
  {
    const auto& sums = this->Tile.Sums[0];
    return { L::Load(&sums[0][cell]), L::Load(&sums[1][cell]), L::Load(&sums[2][cell]),
      L::Load(&sums[3][cell]) };
  }

  template <typename L>
  GATUN_INLINE void StoreSums(int cell, const RaySums<L>& sums)
  {
    auto& to = this->Tile.Sums[0];
    L::Store(&to[0][cell], sums.R);
    L::Store(&to[1][cell], sums.G);
    L::Store(&to[2][cell], sums.B);
    L::Store(&to[3][cell], sums.Through);
  }

  template <typename L>
  GATUN_INLINE void Integrate(const TetItem& item, const RayLine<L>& line, typename L::Float begin,
    typename L::Float end, typename L::Mask some, RaySums<L>& sums, typename L::Float& first)
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
    typename L::Float end, typename L::Mask hits, int cell)
  {
    RayTile& tile = this->Tile;
    const auto last = L::Load(&tile.End[0][cell]);
    const auto fresh = L::And(hits, L::Equal(last, L::Splat(RayTile::Never)));
    const auto longer = L::Or(fresh, L::And(hits, L::Equal(last, begin)));
    L::Store(&tile.End[0][cell], L::Select(longer, end, last));
    if (L::ToBits(fresh) != 0)
    {
      float* const begins = &tile.Begin[0][cell];
      L::Store(begins, L::Select(fresh, begin, L::Load(begins)));
    }
    const auto next = L::Load(&tile.Begin[1][cell]);
    unsigned touching = L::ToBits(L::And(longer, L::Equal(next, end)));
    const auto others = L::Without(hits, longer);
    if (!item.Transparent)
    {
      auto sums = this->LoadSums<L>(cell);
      const auto before = sums.Through;
      auto first = begin;
      this->Integrate<L>(item, line, begin, end, longer, sums, first);
      this->StoreSums<L>(cell, sums);
      const auto one = L::Splat(1);
      const auto seen =
        L::Without(L::And(longer, L::Equal(before, one)), L::Equal(sums.Through, one));
      const auto opaque = L::And(longer, L::Less(sums.Through, L::Splat(this->Context.Opaque)));
      if (L::ToBits(L::Or(seen, opaque)) != 0)
      {
        float* const firsts = &tile.Firsts[0][cell];
        L::Store(firsts, L::Select(seen, first, L::Load(firsts)));
        // Skips everything behind.
        const auto far = L::Load(&tile.Far[cell]);
        L::Store(&tile.Far[cell], L::Select(opaque, L::Min(end, far), far));
      }
    }
    if (L::ToBits(others) != 0) [[unlikely]]
    {
      touching |= this->PlaceElsewhere<L>(item, line, begin, end, others, cell);
    }
    if (touching != 0) [[unlikely]]
    {
      this->Merge(cell, touching);
    }
  }

  /** Extends fragments in slot 1, or begins them there. Returns those that touch slot 0. */
  template <typename L>
  [[gnu::noinline]] unsigned PlaceElsewhere(const TetItem& item, const RayLine<L>& line,
    typename L::Float begin, typename L::Float end, typename L::Mask others, int cell)
  {
    RaySums<L> sums{ L::Splat(0), L::Splat(0), L::Splat(0), L::Splat(1) };
    auto first = begin;
    if (!item.Transparent)
    {
      this->Integrate<L>(item, line, begin, end, others, sums, first);
    }
    RayTile& tile = this->Tile;
    unsigned touching = 0;
    for (unsigned bits = L::ToBits(others); bits != 0; bits &= bits - 1)
    {
      const auto lane = static_cast<unsigned>(__builtin_ctz(bits));
      const auto at = static_cast<std::size_t>(cell) + lane;
      if (tile.End[1][at] != begin[lane])
      {
        if (tile.End[1][at] != RayTile::Never)
        {
          tile.SetAside(1, static_cast<int>(at));
        }
        tile.Begin[1][at] = begin[lane];
      }
      tile.End[1][at] = end[lane];
      auto& to = tile.Sums[1];
      const float through = to[3][at];
      to[0][at] += through * sums.R[lane];
      to[1][at] += through * sums.G[lane];
      to[2][at] += through * sums.B[lane];
      to[3][at] = through * sums.Through[lane];
      if (through == 1 && to[3][at] != 1)
      {
        tile.Firsts[1][at] = first[lane];
      }
      if (to[3][at] < this->Context.Opaque)
      {
        this->HideFrom(at, end[lane]);
      }
      touching |= tile.Begin[0][at] == end[lane] ? 1u << lane : 0u;
    }
    return touching;
  }

  void Merge(int cell, unsigned touching)
  {
    for (; touching != 0; touching &= touching - 1)
    {
      const int at = cell + __builtin_ctz(touching);
      this->Tile.MergeSlots(at);
      if (this->Tile.Sums[0][3][at] < this->Context.Opaque)
      {
        this->HideFrom(static_cast<std::size_t>(at), this->Tile.End[0][at]);
      }
    }
  }

  /** Skips everything behind an opaque fragment. */
  void HideFrom(std::size_t cell, float end)
  {
    float& far = this->Tile.Far[cell];
    far = end < far ? end : far;
  }

  const DrawContext& Context;
  RayTile& Tile;
  const RayShade* Shade = nullptr; // of the tetrahedron that is being drawn
};
}
}

#endif
