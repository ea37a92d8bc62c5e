// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunRayTile.h"

#include <algorithm>

namespace gatun
{
//------------------------------------------------------------------------------
RayTile::RayTile(int width, int height)
{
  for (RayPixels& block : this->Blocks)
  {
    block.Near.fill(0);
    block.Far.fill(Never);
    block.LengthPerDepth.fill(1);
    block.DepthPerLength.fill(1);
  }
  for (int cell = 0; cell < Pixels; ++cell)
  {
    this->Clear(0, cell);
    this->Clear(1, cell);
    if (ToX(cell) < width && ToY(cell) < height)
    {
      this->GetBlock(cell).Far[ToLane(cell)] = Always;
    }
  }
}

//------------------------------------------------------------------------------
std::size_t RayTile::CountFragments() const
{
  auto count = this->Others.size();
  for (const RayPixels& block : this->Blocks)
  {
    for (const RayPixels::Slot& slot : block.Slots)
    {
      count += slot.End.size() -
        static_cast<std::size_t>(std::count(slot.End.begin(), slot.End.end(), Never));
    }
  }
  return count;
}

//------------------------------------------------------------------------------
void RayTile::Clear(unsigned slot, int cell)
{
  this->Set(slot, { -Never, Never, -Never, static_cast<std::uint32_t>(cell), { 0, 0, 0, 1 } });
}

//------------------------------------------------------------------------------
Fragment RayTile::Get(unsigned slot, int cell) const
{
  const RayPixels::Slot& from = this->GetBlock(cell).Slots[slot];
  const unsigned lane = ToLane(cell);
  return { from.Begin[lane], from.End[lane], from.First[lane], static_cast<std::uint32_t>(cell),
    { from.Sums[0][lane], from.Sums[1][lane], from.Sums[2][lane], from.Sums[3][lane] } };
}

//------------------------------------------------------------------------------
void RayTile::Set(unsigned slot, const Fragment& fragment)
{
  const auto cell = static_cast<int>(fragment.Cell);
  RayPixels::Slot& to = this->GetBlock(cell).Slots[slot];
  const unsigned lane = ToLane(cell);
  to.Begin[lane] = fragment.Begin;
  to.End[lane] = fragment.End;
  to.First[lane] = fragment.First;
  for (unsigned channel = 0; channel < 4; ++channel)
  {
    to.Sums[channel][lane] = fragment.Sum[channel];
  }
}

//------------------------------------------------------------------------------
void RayTile::SetAside(unsigned slot, int cell)
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
  const Fragment first = this->Get(0, cell);
  const Fragment second = this->Get(1, cell);
  const bool firstInFront = first.End == second.Begin;
  Fragment merged = firstInFront ? first : second;
  merged.Append(firstInFront ? second : first);
  this->Set(0, merged);
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
