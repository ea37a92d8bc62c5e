// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunNearestPicker.h"
#include "gatunNeighborLists.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gatun
{
namespace
{
/** The last cells at each corner. */
class LastCells
{
public:
  static constexpr std::size_t Kept = 16;

  explicit LastCells(std::span<const std::uint32_t> corners)
    : Counts(
        corners.empty() ? 0 : *std::max_element(corners.begin(), corners.end()) + std::size_t{ 1 })
    , Cells(this->Counts.size())
  {
  }

  void Add(std::uint32_t corner, Vertex cell)
  {
    auto& count = this->Counts[corner];
    this->Cells[corner][count % Kept] = cell;
    ++count;
  }

  std::span<const Vertex> Of(std::uint32_t corner) const
  {
    return { this->Cells[corner].data(), std::min<std::size_t>(this->Counts[corner], Kept) };
  }

private:
  std::vector<std::uint32_t> Counts;
  std::vector<std::array<Vertex, Kept>> Cells;
};
}

//------------------------------------------------------------------------------
NeighborLists NeighborLists::OfCells(
  std::span<const std::uint32_t> starts, std::span<const std::uint32_t> corners, Places places)
{
  LastCells last(corners);
  NeighborLists lists(places.size(), MaxCells);
  NearestPicker candidates(places.size(), MaxCells);
  for (Vertex cell = 0; cell < places.size(); ++cell)
  {
    candidates.Begin(cell);
    const auto own = corners.subspan(starts[cell], starts[cell + 1] - starts[cell]);
    const bool isSmall = own.size() <= NearestPicker::MaxCandidates / LastCells::Kept;
    for (const auto corner : isSmall ? own : own.first(0))
    {
      for (const Vertex other : last.Of(corner))
      {
        candidates.Add(other);
      }
    }
    lists.Append(candidates, places);
    for (const auto corner : own)
    {
      last.Add(corner, cell);
    }
  }
  return lists;
}
}
