// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunIntervalTree.h"

#include <algorithm>
#include <numeric>

namespace gatun
{
//------------------------------------------------------------------------------
IntervalTree::IntervalTree(std::span<const Range> ranges)
  : Count(ranges.size())
{
  std::vector<std::uint32_t> members;
  for (std::size_t i = 0; i < ranges.size(); ++i)
  {
    if (ranges[i].Min < ranges[i].Max) // else nothing passes through
    {
      members.push_back(static_cast<std::uint32_t>(i));
    }
  }
  this->Root = this->Build(ranges, std::move(members));
}

//------------------------------------------------------------------------------
std::int32_t IntervalTree::Build(std::span<const Range> ranges, std::vector<std::uint32_t> members)
{
  if (members.empty())
  {
    return -1;
  }
  // The median of the upper ends: the range that has it is passed through there, so every node
  // takes at least one range.
  std::vector<double> ends(members.size());
  std::transform(
    members.begin(), members.end(), ends.begin(), [&](std::uint32_t i) { return ranges[i].Max; });
  const auto middle = ends.begin() + static_cast<std::ptrdiff_t>(ends.size() / 2);
  std::nth_element(ends.begin(), middle, ends.end());

  Node node;
  node.Center = *middle;
  const auto above = std::partition(
    members.begin(), members.end(), [&](std::uint32_t i) { return ranges[i].Min < node.Center; });
  const auto here = std::partition(
    members.begin(), above, [&](std::uint32_t i) { return ranges[i].Max < node.Center; });
  node.Begin = this->ByMin.size();
  for (auto it = here; it != above; ++it)
  {
    this->ByMin.push_back({ ranges[*it].Min, *it });
    this->ByMax.push_back({ ranges[*it].Max, *it });
  }
  node.End = this->ByMin.size();
  const auto begin = static_cast<std::ptrdiff_t>(node.Begin);
  std::sort(this->ByMin.begin() + begin, this->ByMin.end(),
    [](const Entry& a, const Entry& b) { return a.Bound < b.Bound; });
  std::sort(this->ByMax.begin() + begin, this->ByMax.end(),
    [](const Entry& a, const Entry& b) { return a.Bound > b.Bound; });

  const auto place = this->Nodes.size();
  this->Nodes.push_back(node);
  const std::int32_t below = this->Build(ranges, { members.begin(), here });
  const std::int32_t over = this->Build(ranges, { above, members.end() });
  this->Nodes[place].Below = below;
  this->Nodes[place].Above = over;
  return static_cast<std::int32_t>(place);
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> IntervalTree::FindAny(std::span<const double> values) const
{
  std::vector<bool> found(this->Count, false);
  for (const double value : values)
  {
    this->Find(value, [&](std::uint32_t i) { found[i] = true; });
  }
  std::vector<std::uint32_t> all;
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    if (found[i])
    {
      all.push_back(static_cast<std::uint32_t>(i));
    }
  }
  return all;
}
}
