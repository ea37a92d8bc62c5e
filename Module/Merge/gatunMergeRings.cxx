// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunMergeRings.h"

namespace gatun
{
//------------------------------------------------------------------------------
template <std::size_t Corners>
MergeRings<Corners>::MergeRings(std::size_t points, std::span<const Cell> cells)
  : Cells(cells.begin(), cells.end())
  , Rings(points)
{
  for (Cell& cell : this->Cells)
  {
    auto sorted = cell;
    std::sort(sorted.begin(), sorted.end());
    if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
    {
      cell[0] = None;
      continue;
    }
    for (const auto corner : cell)
    {
      ++this->Rings[corner].Count;
    }
  }
  for (Ring& ring : this->Rings)
  {
    ring.First = this->Used;
    this->Used += ring.Count;
    ring.Count = 0;
  }
  this->Pool.resize(this->Used);
  for (std::uint32_t cell = 0; cell < this->Cells.size(); ++cell)
  {
    if (this->Cells[cell][0] == None)
    {
      continue;
    }
    for (const auto corner : this->Cells[cell])
    {
      Ring& ring = this->Rings[corner];
      this->Pool[ring.First + ring.Count++] = cell;
    }
  }
}

//------------------------------------------------------------------------------
/** The last cell of the ring takes the place of the removed one. */
template <std::size_t Corners>
void MergeRings<Corners>::RemoveFromRing(std::uint32_t point, std::uint32_t cell)
{
  Ring& ring = this->Rings[point];
  std::uint32_t* const first = this->Pool.data() + ring.First;
  std::uint32_t* const last = first + ring.Count;
  std::uint32_t* const found = std::find(first, last, cell);
  if (found != last)
  {
    *found = last[-1];
    --ring.Count;
    --this->Used;
  }
}

//------------------------------------------------------------------------------
template <std::size_t Corners>
void MergeRings<Corners>::MergeRing(std::uint32_t point, std::uint32_t into, bool isLazy)
{
  this->Moved.clear();
  for (const auto cell : this->GetRing(point))
  {
    Cell& corners = this->Cells[cell];
    if (isLazy && corners[0] == None)
    {
      continue;
    }
    if (HasCorner(corners, into))
    {
      for (const auto corner : corners)
      {
        if (!isLazy && corner != point && corner != into)
        {
          this->RemoveFromRing(corner, cell);
        }
      }
      corners[0] = None;
    }
    else
    {
      corners[FindKnownCorner(corners, point)] = into;
      this->Moved.push_back(cell);
    }
  }
  this->Used -= this->Rings[point].Count + this->Rings[into].Count;
  for (const auto cell : this->GetRing(into))
  {
    if (this->Cells[cell][0] != None)
    {
      this->Moved.push_back(cell);
    }
  }
  this->Used += this->Moved.size();
  this->Rings[point].Count = 0;
  this->Rings[into] = { this->Pool.size(), static_cast<std::uint32_t>(this->Moved.size()) };
  this->Pool.insert(this->Pool.end(), this->Moved.begin(), this->Moved.end());
  if (this->Pool.size() > 2 * this->Used + 1024)
  {
    this->Compact();
  }
}

//------------------------------------------------------------------------------
template <std::size_t Corners>
void MergeRings<Corners>::Compact()
{
  LargeArray<std::uint32_t> pool;
  for (std::uint32_t point = 0; point < this->Rings.size(); ++point)
  {
    const auto ring = this->GetRing(point);
    this->Rings[point].First = pool.size();
    pool.insert(pool.end(), ring.begin(), ring.end());
  }
  this->Pool = std::move(pool);
  this->Used = this->Pool.size();
}

template class MergeRings<3>;
template class MergeRings<4>;
}
