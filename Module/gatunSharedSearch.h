// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunSharedSearch_h
#define gatunSharedSearch_h

#include "gatunGate.h"
#include "gatunMeasure.h"
#include "gatunTopology.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** Finds the shared vertices, not met yet, that lie in front of a gate and near it. */
class SharedSearch
{
public:
  static constexpr unsigned Most = 8;
  static constexpr unsigned Patience = 1024; // cells and vertices looked at in a search

  struct Hits
  {
    std::array<RankedVertex, Most> List; // Id is the index of a shared vertex
    unsigned Count = 0;
  };

  explicit SharedSearch(std::span<const SharedVertex> vertices);

  /**
   * The vertices in front of the gate a, b, c whose distance to its centroid is at most reach times
   * its longest edge: the Most nearest, the nearest first. The search goes outwards over the cells
   * of a grid and gives up, with what it has, when it runs out of patience.
   */
  Hits Find(const GatePlane& plane, const LatticePoint& a, const LatticePoint& b,
    const LatticePoint& c, double reach) const;

  void Remove(std::uint32_t index);
  bool IsGone(std::uint32_t index) const { return this->PlaceOf[index] == Gone; }

private:
  static constexpr std::uint32_t Gone = 0xffffffffu;

  struct Entry
  {
    LatticePoint Place;
    std::uint32_t Index; // Gone when met
  };

  int CellOf(double coordinate) const
  {
    return static_cast<int>(static_cast<unsigned>(coordinate) >> this->Shift);
  }

  std::size_t CellOf(int x, int y, int z) const
  {
    const auto count = static_cast<std::size_t>(this->Count);
    return (static_cast<std::size_t>(z) * count + static_cast<std::size_t>(y)) * count +
      static_cast<std::size_t>(x);
  }

  std::size_t CellOf(const LatticePoint& p) const
  {
    return this->CellOf(this->CellOf(p.X), this->CellOf(p.Y), this->CellOf(p.Z));
  }

  struct Query;

  std::vector<std::uint32_t> PlaceOf; // of each vertex its place among the entries
  std::vector<Entry> Entries;         // by cell, then by index
  std::vector<std::uint32_t> CellStart;
  unsigned Shift = 16;
  int Count = 1; // cells along each axis
};
}

#endif
