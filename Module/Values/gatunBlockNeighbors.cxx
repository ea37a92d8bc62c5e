// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunNearestPicker.h"
#include "gatunNeighborLists.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace gatun
{
namespace
{
/** Points in the cells of a grid, as far as they are known. Points of blocks lie on surfaces. */
class PointGrid
{
public:
  explicit PointGrid(NeighborLists::Places places)
    : Places(places)
    , Next(places.size(), NoVertex)
  {
    while (this->Size < MaxSize && this->Size * this->Size * 4 * PerCell <= places.size())
    {
      this->Size *= 2;
    }
    this->Last.assign(this->Size * this->Size * this->Size, NoVertex);
    double extent = 0;
    for (unsigned k = 0; k < 3; ++k)
    {
      double low = std::numeric_limits<double>::infinity();
      double high = -low;
      for (const auto& place : places)
      {
        low = place[k] < low ? place[k] : low;
        high = place[k] > high ? place[k] : high;
      }
      this->Low[k] = low;
      extent = high - low > extent ? high - low : extent;
    }
    const double scale = static_cast<double>(this->Size) / extent;
    this->Scale = scale <= std::numeric_limits<double>::max() ? scale : 0;
  }

  void Add(Vertex v)
  {
    const auto at = this->Locate(v);
    auto& last = this->Last[this->GetIndex(at[0], at[1], at[2])];
    this->Next[v] = last;
    last = v;
  }

  /** Calls use for known points around a point. */
  template <typename Use>
  void EachAround(Vertex v, Use&& use) const
  {
    const auto at = this->Locate(v);
    std::array<std::size_t, 3> low, high;
    for (unsigned k = 0; k < 3; ++k)
    {
      low[k] = at[k] - std::min<std::size_t>(at[k], 1);
      high[k] = std::min(at[k] + 1, this->Size - 1);
    }
    for (std::size_t z = low[2]; z <= high[2]; ++z)
    {
      for (std::size_t y = low[1]; y <= high[1]; ++y)
      {
        for (std::size_t x = low[0]; x <= high[0]; ++x)
        {
          Vertex u = this->Last[this->GetIndex(x, y, z)];
          for (unsigned i = 0; i < MostOfCell && u != NoVertex; ++i)
          {
            use(u);
            u = this->Next[u];
          }
        }
      }
    }
  }

private:
  static constexpr std::size_t MaxSize = 64; // of the grid
  static constexpr std::size_t PerCell = 6;  // if they lie on two sides of the grid
  static constexpr unsigned MostOfCell = 32;

  std::array<std::size_t, 3> Locate(Vertex v) const
  {
    std::array<std::size_t, 3> at;
    for (unsigned k = 0; k < 3; ++k)
    {
      const double index = (this->Places[v][k] - this->Low[k]) * this->Scale;
      const auto last = static_cast<double>(this->Size - 1);
      at[k] = index > 0 ? static_cast<std::size_t>(index < last ? index : last) : 0;
    }
    return at;
  }

  std::size_t GetIndex(std::size_t x, std::size_t y, std::size_t z) const
  {
    return (z * this->Size + y) * this->Size + x;
  }

  const NeighborLists::Places Places;
  std::size_t Size = 1;
  std::array<double, 3> Low{};
  double Scale = 0;         // 0 if there is none
  std::vector<Vertex> Last; // of each cell
  std::vector<Vertex> Next; // the one before in the same cell
};
}

//------------------------------------------------------------------------------
NeighborLists NeighborLists::OfBlock(Places places)
{
  PointGrid grid(places);
  NeighborLists lists(places.size(), MaxNeighbors);
  NearestPicker candidates(places.size(), MaxNeighbors);
  for (Vertex v = 0; v < places.size(); ++v)
  {
    candidates.Begin(v);
    constexpr Vertex before = 8;
    for (Vertex u = v - std::min(v, before); u < v; ++u)
    {
      candidates.Add(u);
    }
    grid.EachAround(v, [&](Vertex u) { candidates.Add(u); });
    lists.Append(candidates, places);
    grid.Add(v);
  }
  return lists;
}
}
