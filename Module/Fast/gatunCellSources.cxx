// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunCellSources.h"

#include <algorithm>

namespace gatun
{
//------------------------------------------------------------------------------
SourceFinder::SourceFinder(std::size_t count, const CodedCells& cells, const CellUsers& users,
  const std::vector<std::uint32_t>& numbers)
  : Coded(cells)
  , Users(users)
  , Numbers(numbers)
  , Ranks(count, CodedCells::None)
  , Common(count, 0)
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
  const auto openOfExpected = open.size();
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
  this->AreKnown = std::equal(this->From.begin(), this->From.begin() + used, expected.begin());
  this->Last = this->From;
  this->Ranks[cell] = static_cast<std::uint32_t>(this->Coded.Items.size());
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
/** Collects coded cells around a cell: those with the most corners in common first, of these the
 * last ones. */
void SourceFinder::FindNearCells(std::uint32_t cell, std::span<const std::uint32_t> points)
{
  this->Near.clear();
  Ids cells;
  for (const auto point : CellUsers::GetFirst(points))
  {
    for (const auto other : this->Users.Get(point))
    {
      if (other != cell && this->Ranks[other] != CodedCells::None && this->Common[other]++ == 0)
      {
        cells.push_back(other);
      }
    }
  }
  for (const auto other : cells)
  {
    this->Near.emplace_back(std::exchange(this->Common[other], 0), this->Ranks[other]);
  }
  std::sort(this->Near.rbegin(), this->Near.rend());
}

//------------------------------------------------------------------------------
/** The cell that has most of the open vertices. */
std::uint32_t SourceFinder::FindBest(
  const Ids& open, std::uint32_t expected, std::size_t reach) const
{
  std::uint32_t best = CodedCells::None;
  std::size_t most = 0;
  for (const auto& [common, source] : this->Near)
  {
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
