// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunMergeTriangles.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gatun
{
namespace
{
bool IsFinite(const std::array<double, 3>& point)
{
  return std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2]);
}
}

//------------------------------------------------------------------------------
MergePlaces::MergePlaces(const SurfaceMergeInput& input)
{
  const std::size_t points = input.Points.size();
  std::vector<bool> isUsed(points, false);
  for (const auto& cell : input.Cells)
  {
    isUsed[cell[0]] = isUsed[cell[1]] = isUsed[cell[2]] = true;
  }
  std::vector<std::uint32_t> places(points);
  for (std::uint32_t point = 0; point < points; ++point)
  {
    const bool isSame = point > 0 && isUsed[point - 1] && isUsed[point] &&
      input.Points[point - 1] == input.Points[point] && IsFinite(input.Points[point]);
    if (!isSame)
    {
      this->First.push_back(point);
    }
    places[point] = static_cast<std::uint32_t>(this->First.size() - 1);
  }
  this->First.push_back(static_cast<std::uint32_t>(points));
  this->Cells.reserve(input.Cells.size());
  for (const auto& cell : input.Cells)
  {
    this->Cells.push_back({ places[cell[0]], places[cell[1]], places[cell[2]] });
  }
}

//------------------------------------------------------------------------------
MergeTriangles::MergeTriangles(const SurfaceMergeInput& input, bool keepBorder)
  : MergeTriangles(input, MergePlaces(input), keepBorder)
{
}

//------------------------------------------------------------------------------
MergeTriangles::MergeTriangles(
  const SurfaceMergeInput& input, MergePlaces&& places, bool keepBorder)
  : MergeRings(places.First.size() - 1, places.Cells)
  , Places(std::move(places))
  , Seams(this->Places.First.size() - 1 < input.Points.size())
  , IsKept(this->GetNumberOfPlaces(), Free)
{
  if (this->Seams)
  {
    this->Corners.assign(input.Cells.begin(), input.Cells.end());
  }
  for (std::uint32_t place = 0; place < this->IsKept.size() && !input.IsKept.empty(); ++place)
  {
    const auto first = input.IsKept.begin() + this->GetFirstPoint(place);
    const bool isMarked = std::any_of(
      first, first + this->CountPoints(place), [](std::uint8_t mark) { return mark != 0; });
    this->IsKept[place] = isMarked ? Marked : Free;
  }
  this->FindKept(keepBorder);
  std::vector<Cell>().swap(this->Places.Cells);
}

//------------------------------------------------------------------------------
void MergeTriangles::FindKept(bool keepBorder)
{
  for (std::uint32_t place = 0; place < this->IsKept.size(); ++place)
  {
    const Fan fan = this->FindFan(place);
    if (fan == Fan::None)
    {
      this->IsKept[place] = Irregular;
    }
    else if (fan == Fan::Open && keepBorder)
    {
      this->IsKept[place] = Marked;
    }
  }
  // Triangles that the rings do not have stay as they are.
  for (const Cell& cell : this->Places.Cells)
  {
    if (cell[0] == cell[1] || cell[1] == cell[2] || cell[2] == cell[0])
    {
      for (const auto place : cell)
      {
        this->IsKept[place] = Irregular;
      }
    }
  }
}

//------------------------------------------------------------------------------
MergeTriangles::Fan MergeTriangles::FindFan(std::uint32_t place) const
{
  const auto ring = this->GetRing(place);
  if (ring.size() == 2 || ring.empty())
  {
    // Two triangles with the same corners are no fan.
    const auto hasSameCorners = [&]
    {
      Cell a = this->GetCell(ring[0]);
      Cell b = this->GetCell(ring[1]);
      std::sort(a.begin(), a.end());
      std::sort(b.begin(), b.end());
      return a == b;
    };
    if (ring.empty() || hasSameCorners())
    {
      return ring.empty() ? Fan::Open : Fan::None;
    }
  }
  // The far ends of the edges of the place, with their triangles.
  struct End
  {
    std::uint32_t Place;
    std::uint32_t Slot; // of the triangle in the ring
    bool operator<(const End& other) const
    {
      return std::pair(this->Place, this->Slot) < std::pair(other.Place, other.Slot);
    }
  };
  std::vector<End> ends;
  ends.reserve(2 * ring.size());
  for (std::uint32_t slot = 0; slot < ring.size(); ++slot)
  {
    for (const auto corner : this->GetCell(ring[slot]))
    {
      if (corner != place)
      {
        ends.push_back({ corner, slot });
      }
    }
  }
  std::sort(ends.begin(), ends.end());
  // Each triangle has two edges; who shares an edge is next to it.
  std::vector<std::array<std::uint32_t, 2>> next(ring.size(), { None, None });
  std::uint32_t border = None;
  const auto link = [&](std::uint32_t slot, std::uint32_t other)
  { next[slot][next[slot][0] == None ? 0 : 1] = other; };
  unsigned borders = 0;
  for (std::size_t i = 0; i < ends.size();)
  {
    const bool isPair = i + 1 < ends.size() && ends[i + 1].Place == ends[i].Place;
    if (isPair && i + 2 < ends.size() && ends[i + 2].Place == ends[i].Place)
    {
      return Fan::None; // an edge with three triangles
    }
    if (isPair)
    {
      link(ends[i].Slot, ends[i + 1].Slot);
      link(ends[i + 1].Slot, ends[i].Slot);
    }
    else
    {
      border = ends[i].Slot;
      ++borders;
    }
    i += isPair ? 2 : 1;
  }
  if (borders > 2)
  {
    return Fan::None;
  }
  std::size_t found = 1;
  std::uint32_t before = None;
  const std::uint32_t start = border == None ? 0 : border;
  for (std::uint32_t slot = start; found <= ring.size(); ++found)
  {
    const auto& links = next[slot];
    const std::uint32_t to = links[0] != before ? links[0] : links[1];
    if (to == None || to == start)
    {
      break;
    }
    before = slot;
    slot = to;
  }
  return found != ring.size() ? Fan::None : borders > 0 ? Fan::Open : Fan::Closed;
}

//------------------------------------------------------------------------------
std::span<const MergeTriangles::Pair> MergeTriangles::Merge(std::uint32_t place, std::uint32_t into)
{
  this->Pairs.clear();
  const std::uint32_t first = this->GetFirstPoint(place);
  if (!this->Seams)
  {
    this->Pairs.push_back({ first, this->GetFirstPoint(into) });
    this->MergeRings::Merge(place, into);
    return this->Pairs;
  }
  for (std::uint32_t i = 0; i < this->CountPoints(place); ++i)
  {
    this->Pairs.push_back({ first + i, None });
  }
  const auto ring = this->GetRing(place);
  std::uint32_t any = None;
  for (const auto cell : ring)
  {
    const Cell& corners = this->GetCell(cell);
    const unsigned other = FindCorner(corners, into);
    if (other < 3)
    {
      any = this->Corners[cell][other];
      this->Pairs[this->Corners[cell][FindKnownCorner(corners, place)] - first][1] = any;
    }
  }
  for (Pair& pair : this->Pairs)
  {
    // Points whose triangles have all vanished have no choice.
    pair[1] = pair[1] == None ? any : pair[1];
  }
  for (const auto cell : ring)
  {
    std::uint32_t& corner = this->Corners[cell][FindKnownCorner(this->GetCell(cell), place)];
    corner = this->Pairs[corner - first][1];
  }
  this->MergeRings::Merge(place, into);
  return this->Pairs;
}
}
