// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPlaceGrid_h
#define gatunPlaceGrid_h

#include "gatunMeasure.h"
#include "gatunPolygonModels.h"
#include "gatunTopology.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

namespace gatun
{
/** Finds vertices around a place. They are in buckets by the cells of four grids. */
class PlaceGrid
{
public:
  explicit PlaceGrid(std::size_t vertices)
    : Bits(std::clamp(static_cast<unsigned>(std::bit_width(vertices)), 4u, 20u))
  {
    for (auto& level : this->Levels)
    {
      level.Heads.assign(std::size_t{ 1 } << this->Bits, NoVertex);
      level.Next.reserve(vertices);
    }
  }

  /** Adds the next vertex. */
  void Add(const LatticePoint& place)
  {
    const auto id = static_cast<Vertex>(this->Levels[0].Next.size());
    for (unsigned i = 0; i < Count; ++i)
    {
      auto& level = this->Levels[i];
      auto& head =
        level.Heads[this->GetBucket(ToCell(place.X, i), ToCell(place.Y, i), ToCell(place.Z, i))];
      level.Next.push_back(head);
      head = id;
    }
  }

  std::size_t GetSize() const { return this->Levels[0].Next.size(); }

  /** Calls use(vertex) for all vertices within a distance of a place, and for others. */
  template <typename Use>
  void ForEachAround(const LatticePoint& place, float distance, Use&& use) const
  {
    constexpr unsigned most = 64;
    unsigned number = 0;
    while (number + 1 < Count && !(distance <= GetSize(number)))
    {
      ++number;
    }
    const auto& level = this->Levels[number];
    const float reach = std::min(distance, GetSize(number));
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
  static constexpr unsigned Count = 4; // of grids

  struct Level
  {
    std::vector<Vertex> Heads; // the latest vertex of each bucket
    std::vector<Vertex> Next;  // the one before each vertex in its bucket
  };

  /** The side of a cell: 1, 4, 16, 64. */
  static float GetSize(unsigned level) { return static_cast<float>(1u << (2 * level)); }

  static std::uint32_t ToCell(float coordinate, unsigned level)
  {
    const float clamped = coordinate > 0 ? (coordinate < 255 ? coordinate : 255) : 0;
    return static_cast<std::uint32_t>(clamped) >> (2 * level);
  }

  std::uint32_t GetBucket(std::uint32_t x, std::uint32_t y, std::uint32_t z) const
  {
    return (x * 0x9e3779b1u + y * 0x85ebca6bu + z * 0xc2b2ae35u) >> (32 - this->Bits);
  }

  unsigned Bits; // of the numbers of buckets
  std::array<Level, Count> Levels;
};
}

#endif
