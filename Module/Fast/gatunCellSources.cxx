// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunCellSources.h"

#include <algorithm>
#include <utility>

namespace gatun
{
//------------------------------------------------------------------------------
SourceFinder::SourceFinder(std::size_t count, const CodedCells& cells, const CellUsers& users,
  const std::vector<std::uint32_t>& numbers)
  : Coded(cells)
  , Users(users)
  , Numbers(numbers)
  , States(count)
{
}

//------------------------------------------------------------------------------
unsigned SourceFinder::Find(
  std::uint32_t cell, std::span<const std::uint32_t> points, std::size_t reach)
{
  SourceCells expected{};
  std::transform(this->Last.begin(), this->Last.end(), expected.begin(),
    [](std::uint32_t last) { return last + 1; });
  this->From = expected;
  this->FindKnown(points);
  auto open = this->Known;
  unsigned used = 0; // of the expected ones
  for (unsigned s = 0; s < expected.size() && !open.empty(); ++s)
  {
    used = this->Cover(open, expected[s], reach) > 0 ? s + 1 : used;
  }
  if (const auto openOfExpected = open.size(); openOfExpected > 0)
  {
    this->FindNearCells(cell, points);
    open = this->Known;
    unsigned count = 0;
    SourceCells best{};
    while (count < best.size() && !open.empty())
    {
      const auto source = this->FindBest(open, expected[count], reach);
      if (source == CodedCells::None)
      {
        break;
      }
      this->Cover(open, source, reach);
      best[count++] = source;
    }
    if (openOfExpected > open.size())
    {
      std::copy_n(best.begin(), count, this->From.begin());
      used = count;
    }
  }
  this->AreKnown = std::equal(this->From.begin(), this->From.begin() + used, expected.begin());
  this->Last = this->From;
  this->States[cell].Rank = static_cast<std::uint32_t>(this->Coded.Items.size());
  return used;
}

//------------------------------------------------------------------------------
/** Collects the vertices of a cell that were met before. */
void SourceFinder::FindKnown(std::span<const std::uint32_t> points)
{
  this->Known.clear();
  for (const auto point : CellUsers::GetFirst(points))
  {
    const auto vertex = this->Numbers[point];
    if (vertex != CodedCells::None &&
      std::find(this->Known.begin(), this->Known.end(), vertex) == this->Known.end())
    {
      this->Known.push_back(vertex);
    }
  }
}

//------------------------------------------------------------------------------
/** Collects coded cells around a cell. */
void SourceFinder::FindNearCells(std::uint32_t cell, std::span<const std::uint32_t> points)
{
  this->Others.clear();
  for (const auto point : CellUsers::GetFirst(points))
  {
    for (const auto other : this->Users.Get(point))
    {
      auto& state = this->States[other];
      if (state.Rank != CodedCells::None && other != cell && state.Common++ == 0)
      {
        this->Others.push_back(other);
      }
    }
  }
  this->Near.clear();
  this->Sorted = 0;
  for (const auto other : this->Others)
  {
    auto& state = this->States[other];
    this->Near.push_back({ std::exchange(state.Common, 0), state.Rank });
  }
}

//------------------------------------------------------------------------------
/** Sorts those of the near cells that have the most corners in common of those that are not sorted:
 * the last ones first. Few have many, and the others are rarely looked at. */
void SourceFinder::SortMore()
{
  const auto begin = this->Near.begin() + static_cast<std::ptrdiff_t>(this->Sorted);
  const auto most = std::max_element(begin, this->Near.end(),
    [](const NearCell& l, const NearCell& r) {
      return l.Common < r.Common;
    })->Common;
  const auto end = std::partition(
    begin, this->Near.end(), [most](const NearCell& near) { return near.Common == most; });
  std::sort(begin, end, [](const NearCell& l, const NearCell& r) { return l.Rank > r.Rank; });
  this->Sorted = static_cast<std::size_t>(end - this->Near.begin());
}

//------------------------------------------------------------------------------
/** The cell that has most of the open vertices. */
std::uint32_t SourceFinder::FindBest(const Ids& open, std::uint32_t expected, std::size_t reach)
{
  std::uint32_t best = CodedCells::None;
  std::size_t most = 0;
  for (std::size_t i = 0; i < this->Near.size(); ++i)
  {
    if (i == this->Sorted)
    {
      this->SortMore();
    }
    const auto& [common, source] = this->Near[i];
    if (common < most || most == open.size())
    {
      break;
    }
    const auto count = static_cast<std::size_t>(std::count_if(open.begin(), open.end(),
      [&, from = source](std::uint32_t vertex) { return this->IsCovered(vertex, from, reach); }));
    if (count > most || (count == most && count > 0 && source == expected))
    {
      most = count;
      best = source;
    }
  }
  return best;
}

//------------------------------------------------------------------------------
bool SourceFinder::IsCovered(std::uint32_t vertex, std::uint32_t source, std::size_t reach) const
{
  const auto corners = this->Coded.GetCorners(source);
  const auto end = corners.begin() + static_cast<std::ptrdiff_t>(std::min(corners.size(), reach));
  return std::find(corners.begin(), end, vertex) != end;
}

//------------------------------------------------------------------------------
/** Removes the vertices of a cell, if it is there. Returns how many there were. */
std::size_t SourceFinder::Cover(Ids& open, std::uint32_t source, std::size_t reach) const
{
  if (source >= this->Coded.Items.size())
  {
    return 0;
  }
  return std::erase_if(
    open, [&](std::uint32_t vertex) { return this->IsCovered(vertex, source, reach); });
}
}
