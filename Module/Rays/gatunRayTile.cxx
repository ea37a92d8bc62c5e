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
  for (int slot = 0; slot < Slots; ++slot)
  {
    this->Begin[slot].fill(-Never);
    this->End[slot].fill(Never);
    for (int pixel = 0; pixel < Pixels; ++pixel)
    {
      this->Clear(slot, pixel);
    }
  }
  for (int pixel = 0; pixel < Pixels; ++pixel)
  {
    if (pixel % Size < width && pixel / Size < height)
    {
      this->Far[ToCell(pixel)] = Always;
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
void RayTile::Clear(int slot, int pixel)
{
  const int cell = ToCell(pixel);
  this->Begin[slot][cell] = -Never;
  this->End[slot][cell] = Never;
  this->Sums[slot][pixel] = { 0, 0, 0, 1 };
  this->Firsts[slot][pixel] = -Never;
}

//------------------------------------------------------------------------------
Fragment RayTile::Get(int slot, int pixel) const
{
  const int cell = ToCell(pixel);
  return { this->Begin[slot][cell], this->End[slot][cell], this->Firsts[slot][pixel],
    static_cast<std::uint32_t>(pixel), this->Sums[slot][pixel] };
}

//------------------------------------------------------------------------------
void RayTile::SetAside(int slot, int pixel)
{
  if (this->Others.size() >= this->MostOthers)
  {
    this->Consolidate();
  }
  this->Others.push_back(this->Get(slot, pixel));
  this->Clear(slot, pixel);
}

//------------------------------------------------------------------------------
void RayTile::MergeSlots(int pixel)
{
  const int cell = ToCell(pixel);
  const bool firstInFront = this->End[0][cell] == this->Begin[1][cell];
  Fragment merged = this->Get(firstInFront ? 0 : 1, pixel);
  merged.Append(this->Get(firstInFront ? 1 : 0, pixel));
  this->Begin[0][cell] = merged.Begin;
  this->End[0][cell] = merged.End;
  this->Sums[0][pixel] = merged.Sum;
  this->Firsts[0][pixel] = merged.First;
  this->Clear(1, pixel);
}

//------------------------------------------------------------------------------
void RayTile::Consolidate()
{
  auto& others = this->Others;
  // A counting sort by pixel, then the few fragments of each pixel by depth.
  std::array<std::uint32_t, Pixels + 1> places{};
  for (const Fragment& fragment : others)
  {
    ++places[fragment.Pixel + 1];
  }
  for (std::size_t pixel = 0; pixel < Pixels; ++pixel)
  {
    places[pixel + 1] += places[pixel];
  }
  std::vector<Fragment> sorted(others.size());
  for (const Fragment& fragment : others)
  {
    sorted[places[fragment.Pixel]++] = fragment;
  }
  auto first = sorted.begin();
  for (std::size_t pixel = 0; pixel < Pixels; ++pixel)
  {
    const auto last = sorted.begin() + places[pixel];
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
    if (n != 0 && others[n - 1].Pixel == next.Pixel && others[n - 1].End == next.Begin)
    {
      others[n - 1].Append(next);
    }
    else
    {
      others[n++] = next;
    }
  }
  others.resize(n);
  // The work stays proportional to the number of samples, however many fragments remain.
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
