// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunBrickDivision.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace gatun
{
namespace
{
/** Both sides of a cut have this part of the tetrahedra, or more. */
constexpr double LeastPart = 0.3;

/** What it costs to part neighbors that were parted before, beside others. */
constexpr double PartedTwice = 4;

bool DoMeet(const Bounds& a, const Bounds& b)
{
  bool meets = true;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    meets = meets && a[axis].Min <= b[axis].Max && b[axis].Min <= a[axis].Max;
  }
  return meets;
}

double GetCenter(const Bounds& box, std::size_t axis)
{
  return box[axis].Min / 2 + box[axis].Max / 2;
}
}

//------------------------------------------------------------------------------
BrickDivision::BrickDivision(std::vector<Bounds> boxes)
  : Boxes(std::move(boxes))
  , Neighbors(this->Boxes.size())
{
  // Along the first axis, only those can meet that begin before another one ends.
  std::vector<std::uint32_t> order(this->Boxes.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
    [&](std::uint32_t a, std::uint32_t b)
    { return this->Boxes[a][0].Min < this->Boxes[b][0].Min; });
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const Bounds& box = this->Boxes[order[i]];
    for (std::size_t j = i + 1; j < order.size() && this->Boxes[order[j]][0].Min <= box[0].Max; ++j)
    {
      if (DoMeet(box, this->Boxes[order[j]]))
      {
        this->Neighbors[order[i]].push_back({ order[j] });
        this->Neighbors[order[j]].push_back({ order[i] });
      }
    }
  }
}

//------------------------------------------------------------------------------
/** Sorts bricks along the longest axis of the box of their centers. */
void BrickDivision::Sort(Group& bricks) const
{
  Bounds box;
  for (const auto brick : bricks)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      box[axis].Include(GetCenter(this->Boxes[brick], axis));
    }
  }
  std::size_t longest = 0;
  for (std::size_t axis = 1; axis < 3; ++axis)
  {
    const auto length = [&](std::size_t a) { return box[a].Max - box[a].Min; };
    longest = length(axis) > length(longest) ? axis : longest;
  }
  const auto key = [&](std::uint32_t brick)
  { return std::pair(GetCenter(this->Boxes[brick], longest), brick); };
  std::sort(bricks.begin(), bricks.end(),
    [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
}

//------------------------------------------------------------------------------
/** Returns how many of the sorted bricks come before the best cut. */
std::size_t BrickDivision::FindCut(const Group& bricks, std::span<const std::uint64_t> tets) const
{
  double all = 0;
  std::vector<std::int8_t> side(this->Boxes.size(), 0); // 1: behind the cut, -1: before it
  for (const auto brick : bricks)
  {
    all += static_cast<double>(tets[brick]);
    side[brick] = 1;
  }
  std::size_t best = 0;
  double least = std::numeric_limits<double>::max();
  double parted = 0;
  double before = 0;
  for (std::size_t i = 0; i + 1 < bricks.size(); ++i)
  {
    const auto brick = bricks[i];
    side[brick] = -1;
    for (const Neighbor& neighbor : this->Neighbors[brick])
    {
      parted += side[neighbor.Brick] * (neighbor.WasParted ? PartedTwice : 1);
    }
    before += static_cast<double>(tets[brick]);
    const double part = before / all;
    // Large bricks may leave no place in the middle.
    const double outside = std::max(0., std::abs(part - 0.5) - (0.5 - LeastPart));
    const double cost = parted * (1 + std::abs(part - 0.5)) + outside * 1e6 * (1 + parted);
    if (cost < least)
    {
      least = cost;
      best = i + 1;
    }
  }
  return best;
}

//------------------------------------------------------------------------------
std::vector<BrickDivision::Group> BrickDivision::Divide(
  std::span<const std::uint64_t> tets, std::uint64_t most)
{
  std::vector<Group> groups;
  std::vector<Group> rest(1); // to be divided, the first one last
  for (std::uint32_t brick = 0; brick < this->Boxes.size(); ++brick)
  {
    if (tets[brick] > 0)
    {
      rest[0].push_back(brick);
    }
  }
  while (!rest.empty())
  {
    Group group = std::move(rest.back());
    rest.pop_back();
    const auto add = [&](std::uint64_t sum, std::uint32_t brick) { return sum + tets[brick]; };
    const auto all = std::accumulate(group.begin(), group.end(), std::uint64_t{ 0 }, add);
    if (all <= most || group.size() == 1)
    {
      std::sort(group.begin(), group.end());
      groups.push_back(std::move(group));
      continue;
    }
    this->Sort(group);
    const auto cut = group.begin() + static_cast<std::ptrdiff_t>(this->FindCut(group, tets));
    rest.emplace_back(cut, group.end());
    rest.emplace_back(group.begin(), cut);
  }
  std::vector<std::uint32_t> groupOf(this->Boxes.size(), 0);
  for (std::uint32_t g = 0; g < groups.size(); ++g)
  {
    for (const auto brick : groups[g])
    {
      groupOf[brick] = g;
    }
  }
  for (std::uint32_t brick = 0; brick < this->Boxes.size(); ++brick)
  {
    for (Neighbor& neighbor : this->Neighbors[brick])
    {
      neighbor.WasParted = groupOf[brick] != groupOf[neighbor.Brick];
    }
  }
  return groups;
}
}
