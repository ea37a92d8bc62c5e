// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunRayTile.h"

#include <algorithm>

namespace gatun
{
//------------------------------------------------------------------------------
RayTile::RayTile(int width, int height)
{
  this->Near.fill(0);
  this->Far.fill(Never);
  this->LengthPerDepth.fill(1);
  this->DepthPerLength.fill(1);
  for (int slot = 0; slot < Slots; ++slot)
  {
    for (int cell = 0; cell < Pixels; ++cell)
    {
      this->Clear(slot, cell);
    }
  }
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      this->Far[ToCell(x, y)] = Always;
    }
  }
}

//------------------------------------------------------------------------------
std::size_t RayTile::CountFragments() const
{
  auto count = this->Others.size();
  for (const Cellwise& ends : this->End)
  {
    count += ends.size() - static_cast<std::size_t>(std::count(ends.begin(), ends.end(), Never));
  }
  return count;
}

//------------------------------------------------------------------------------
void RayTile::Clear(int slot, int cell)
{
  this->Begin[slot][cell] = -Never;
  this->End[slot][cell] = Never;
  this->Firsts[slot][cell] = -Never;
  for (unsigned channel = 0; channel < 4; ++channel)
  {
    this->Sums[slot][channel][cell] = channel < 3 ? 0.0f : 1.0f;
  }
}

//------------------------------------------------------------------------------
Fragment RayTile::Get(int slot, int cell) const
{
  const auto& sums = this->Sums[slot];
  return { this->Begin[slot][cell], this->End[slot][cell], this->Firsts[slot][cell],
    static_cast<std::uint32_t>(cell),
    { sums[0][cell], sums[1][cell], sums[2][cell], sums[3][cell] } };
}

//------------------------------------------------------------------------------
void RayTile::SetAside(int slot, int cell)
{
  if (this->Others.size() >= this->MostOthers)
  {
    this->Consolidate();
  }
  this->Others.push_back(this->Get(slot, cell));
  this->Clear(slot, cell);
}

//------------------------------------------------------------------------------
void RayTile::MergeSlots(int cell)
{
  const bool firstInFront = this->End[0][cell] == this->Begin[1][cell];
  Fragment merged = this->Get(firstInFront ? 0 : 1, cell);
  merged.Append(this->Get(firstInFront ? 1 : 0, cell));
  this->Begin[0][cell] = merged.Begin;
  this->End[0][cell] = merged.End;
  this->Firsts[0][cell] = merged.First;
  for (unsigned channel = 0; channel < 4; ++channel)
  {
    this->Sums[0][channel][cell] = merged.Sum[channel];
  }
  this->Clear(1, cell);
}

//------------------------------------------------------------------------------
void RayTile::Consolidate()
{
  auto& others = this->Others;
  // A counting sort by pixel, then the few fragments of each pixel by depth.
  std::array<std::uint32_t, Pixels + 1> places{};
  for (const Fragment& fragment : others)
  {
    ++places[fragment.Cell + 1];
  }
  for (std::size_t cell = 0; cell < Pixels; ++cell)
  {
    places[cell + 1] += places[cell];
  }
  std::vector<Fragment> sorted(others.size());
  for (const Fragment& fragment : others)
  {
    sorted[places[fragment.Cell]++] = fragment;
  }
  auto first = sorted.begin();
  for (std::size_t cell = 0; cell < Pixels; ++cell)
  {
    const auto last = sorted.begin() + places[cell];
    if (last - first > 1)
    {
      std::sort(
        first, last, [](const Fragment& a, const Fragment& b) { return a.Begin < b.Begin; });
    }
    first = last;
  }
  others.swap(sorted);
  std::size_t n = 0;
  for (const Fragment& next : others)
  {
    if (n != 0 && others[n - 1].Cell == next.Cell && others[n - 1].End == next.Begin)
    {
      others[n - 1].Append(next);
    }
    else
    {
      others[n++] = next;
    }
  }
  others.resize(n);
  // The work stays proportional to the number of segments, however many fragments remain.
  this->MostOthers = std::max<std::size_t>(this->MostOthers, 2 * n);
}

//------------------------------------------------------------------------------
void Fragment::Append(const Fragment& behind)
{
  for (unsigned i = 0; i < 3; ++i)
  {
    this->Sum[i] += this->Sum[3] * behind.Sum[i];
  }
  this->Sum[3] *= behind.Sum[3];
  this->First = std::min(this->First, behind.First);
  this->End = behind.End;
}
}
