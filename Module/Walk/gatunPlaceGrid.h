// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPlaceGrid_h
#define gatunPlaceGrid_h

#include "gatunMeasure.h"
#include "gatunTopology.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

namespace gatun
{
/** Finds vertices around a place. They are in buckets by the cells of several grids, each of which
 * is filled when it is needed. */
class PlaceGrid
{
public:
  /** vertices: the most that there will be. */
  explicit PlaceGrid(std::size_t vertices)
    : Bits(std::clamp(static_cast<unsigned>(std::bit_width(vertices)), 4u, 20u))
  {
  }

  /** Calls use(vertex) for all of the first `vertices` vertices within a distance of a place,
   * unless there are too many, and for others. getPlace(vertex) returns the place of a vertex. */
  template <typename GetPlace, typename Use>
  void ForEachAround(
    const LatticePoint& place, float distance, Vertex vertices, GetPlace&& getPlace, Use&& use)
  {
    constexpr unsigned most = 64;
    unsigned number = 0;
    while (number + 1 < this->Levels.size() && !(distance <= GetReach(number)))
    {
      ++number;
    }
    auto& level = this->Levels[number];
    this->Fill(level, number, vertices, getPlace);
    const float reach = std::min(distance, GetReach(number));
    const auto low = [&](float x) { return ToCell(x - reach, number); };
    const auto high = [&](float x) { return ToCell(x + reach, number); };
    for (auto z = low(place.Z); z <= high(place.Z); ++z)
    {
      for (auto y = low(place.Y); y <= high(place.Y); ++y)
      {
        for (auto x = low(place.X); x <= high(place.X); ++x)
        {
          auto v = level.Heads[this->GetBucket(x, y, z)];
          for (unsigned count = 0; v != NoVertex && count < most; ++count)
          {
            use(v);
            v = level.Next[v];
          }
        }
      }
    }
  }

private:
  struct Level
  {
    std::vector<Vertex> Heads; // the latest vertex of each bucket
    std::vector<Vertex> Next;  // the one before each vertex in its bucket
  };

  /** Adds the vertices that a grid does not have. */
  template <typename GetPlace>
  void Fill(Level& level, unsigned number, Vertex vertices, GetPlace&& getPlace) const
  {
    if (level.Heads.empty())
    {
      level.Heads.assign(std::size_t{ 1 } << this->Bits, NoVertex);
    }
    for (auto v = static_cast<Vertex>(level.Next.size()); v < vertices; ++v)
    {
      const LatticePoint& place = getPlace(v);
      auto& head = level.Heads[this->GetBucket(
        ToCell(place.X, number), ToCell(place.Y, number), ToCell(place.Z, number))];
      level.Next.push_back(head);
      head = v;
    }
  }

  /** Half the side of a cell, which is 1 to 128: at most two cells along each axis are as near. */
  static float GetReach(unsigned level) { return 0.5F * static_cast<float>(1u << level); }

  static std::uint32_t ToCell(float coordinate, unsigned level)
  {
    const float clamped = coordinate > 0 ? (coordinate < 255 ? coordinate : 255) : 0;
    return static_cast<std::uint32_t>(clamped) >> level;
  }

  std::uint32_t GetBucket(std::uint32_t x, std::uint32_t y, std::uint32_t z) const
  {
    return (x * 0x9e3779b1u + y * 0x85ebca6bu + z * 0xc2b2ae35u) >> (32 - this->Bits);
  }

  unsigned Bits; // of the numbers of buckets
  std::array<Level, 8> Levels;
};
}

#endif
