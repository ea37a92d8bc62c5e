// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunPointNumbers.h"

#include <algorithm>

namespace gatun
{
//------------------------------------------------------------------------------
std::vector<std::uint64_t> PointNumbers::Find(
  const PartPlace& place, std::uint64_t points, const PartJoins& joins)
{
  constexpr std::uint64_t repeated = ~std::uint64_t{ 0 };
  std::vector<std::uint64_t> numbers(static_cast<std::size_t>(points), 0);
  for (const auto point : joins.Dropped)
  {
    numbers[point] = repeated;
  }
  const auto isFirst = [&](std::uint32_t group)
  { return this->Boundaries.GetGroup(group).front() >= place.FirstChunk; };
  for (const auto& [group, members] : joins.Groups)
  {
    for (const auto point : members)
    {
      numbers[point] = isFirst(group) ? 0 : repeated;
    }
  }
  auto next = place.FirstPoint;
  for (auto& number : numbers)
  {
    number = number == repeated ? repeated : next++;
  }
  for (const auto& [group, members] : joins.Groups)
  {
    this->Joined.resize(std::max<std::size_t>(this->Joined.size(), std::size_t{ group } + 1));
    auto& known = this->Joined[group];
    known.resize(members.size());
    for (std::size_t i = 0; i < members.size(); ++i)
    {
      (isFirst(group) ? known[i] : numbers[members[i]]) =
        isFirst(group) ? numbers[members[i]] : known[i];
    }
  }
  return numbers;
}
}
