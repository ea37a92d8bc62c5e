// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunMergeRings_h
#define gatunMergeRings_h

#include "gatunLargeArray.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** The cells around each point of a mesh while its points are merged. A cell with a point twice is
 * none. Cells are triangles (3 corners) or tetrahedra (4). */
template <std::size_t Corners>
class MergeRings
{
public:
  using Cell = std::array<std::uint32_t, Corners>;
  static constexpr std::uint32_t None = 0xffffffffu;

  MergeRings(std::size_t points, std::span<const Cell> cells);

  /** The first corner of a removed cell is None. */
  const Cell& GetCell(std::uint32_t cell) const { return this->Cells[cell]; }
  std::size_t GetNumberOfCells() const { return this->Cells.size(); }
  std::size_t GetNumberOfPoints() const { return this->Rings.size(); }

  /** Returns the cells of a point. */
  std::span<const std::uint32_t> GetRing(std::uint32_t point) const
  {
    const Ring& ring = this->Rings[point];
    return { this->Pool.data() + ring.First, ring.Count };
  }

  /** Returns the place of a point among the corners of a cell, or the number of corners. */
  static unsigned FindCorner(const Cell& cell, std::uint32_t point)
  {
    unsigned at = 0;
    while (at < Corners && cell[at] != point)
    {
      ++at;
    }
    return at;
  }

  /** Whether a point is a corner of a cell, without branches. */
  static bool HasCorner(const Cell& cell, std::uint32_t point)
  {
    bool has = false;
    for (const auto corner : cell)
    {
      has |= corner == point;
    }
    return has;
  }

  /** The place of a point that is a corner, without branches. */
  static unsigned FindKnownCorner(const Cell& cell, std::uint32_t point)
  {
    unsigned at = 0;
    for (unsigned i = 1; i < Corners; ++i)
    {
      at |= cell[i] == point ? i : 0u;
    }
    return at;
  }

  /** Loads the ring of a point into the cache of the processor, and then its cells. They are rarely
   * near the data of the previous point in memory. */
  void PrefetchRing(std::uint32_t point) const
  {
    constexpr std::size_t perLine = 64 / sizeof(std::uint32_t);
    const std::uint32_t* const first = this->Pool.data() + this->Rings[point].First;
    __builtin_prefetch(first);
    __builtin_prefetch(first + perLine);
  }
  void PrefetchCells(std::uint32_t point) const
  {
    for (const auto cell : this->GetRing(point))
    {
      __builtin_prefetch(&this->Cells[cell]);
    }
  }

  /** Loads the places of the rings of the corners of these cells. */
  void PrefetchRings(std::uint32_t point) const
  {
    for (const auto cell : this->GetRing(point))
    {
      for (const auto corner : this->Cells[cell])
      {
        __builtin_prefetch(&this->Rings[corner]);
      }
    }
  }

  /** Loads the data of the corners of these cells. Here, nothing. */
  void PrefetchCorners(std::uint32_t) const {}

  /** Merges a point into a neighbor. */
  void Merge(std::uint32_t point, std::uint32_t into) { this->MergeRing(point, into, false); }

  /** The same, but rings of other points keep the cells that are removed until these are merged,
   * which is faster if few of them are looked at. */
  void MergeLazily(std::uint32_t point, std::uint32_t into) { this->MergeRing(point, into, true); }

private:
  struct Ring
  {
    std::size_t First = 0;
    std::uint32_t Count = 0;
  };

  void MergeRing(std::uint32_t point, std::uint32_t into, bool isLazy);
  void RemoveFromRing(std::uint32_t point, std::uint32_t cell);
  void Compact();

  LargeArray<Cell> Cells;
  LargeArray<Ring> Rings;
  LargeArray<std::uint32_t> Pool; // of the rings
  std::size_t Used = 0;           // of the pool, by rings

  std::vector<std::uint32_t> Moved; // to the ring of another point
};

extern template class MergeRings<3>;
extern template class MergeRings<4>;
}

#endif
