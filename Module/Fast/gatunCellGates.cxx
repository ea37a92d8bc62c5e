// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunCellGates.h"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <limits>

namespace gatun
{
namespace
{
using Places = std::vector<TreePlace>;

std::uint64_t SumDistances(const Places& places, const Places& others)
{
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      sum += static_cast<std::uint64_t>(std::abs(places[i][axis] - others[i][axis]));
    }
  }
  return sum;
}

/** The bits of all residuals to a + b - (c + d) / 2, or least if they are not fewer. */
unsigned CountBits(const Places& places, const std::array<const Places*, 4>& gate, unsigned least)
{
  const auto& [a, b, c, d] = gate;
  unsigned bits = 0;
  for (std::size_t i = 0; i < places.size() && bits < least; ++i)
  {
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      const auto residual =
        (*a)[i][axis] + (*b)[i][axis] - ((*c)[i][axis] + (*d)[i][axis]) / 2 - places[i][axis];
      bits += static_cast<unsigned>(std::bit_width(static_cast<std::uint32_t>(std::abs(residual))));
    }
  }
  return std::min(bits, least);
}
}

//------------------------------------------------------------------------------
std::optional<CellTemplate::Gate> GateFinder::Find(
  const std::vector<TreePlace>& places, const std::vector<Candidate>& candidates)
{
  constexpr std::size_t near = 6;
  if (places.empty() || candidates.empty())
  {
    return std::nullopt;
  }
  std::vector<std::pair<std::uint64_t, const Candidate*>> sorted;
  for (const auto& candidate : candidates)
  {
    const auto distance = SumDistances(places, candidate.Places);
    // The same vertices may have several names.
    if (std::none_of(sorted.begin(), sorted.end(),
          [&](const auto& other)
          { return other.first == distance && other.second->Places == candidate.Places; }))
    {
      sorted.emplace_back(distance, &candidate);
    }
  }
  std::stable_sort(sorted.begin(), sorted.end(),
    [](const auto& one, const auto& other) { return one.first < other.first; });
  const auto ends = std::min(near, sorted.size());
  unsigned least = std::numeric_limits<unsigned>::max();
  CellTemplate::Gate best{};
  const auto consider =
    [&](const Candidate& a, const Candidate& b, const Candidate& c, const Candidate& d)
  {
    const auto bits = CountBits(places, { &a.Places, &b.Places, &c.Places, &d.Places }, least);
    if (bits < least)
    {
      least = bits;
      best = { a.Name, b.Name, c.Name, d.Name };
    }
  };
  for (std::size_t a = 0; a < ends; ++a)
  {
    for (std::size_t b = 0; b <= a; ++b)
    {
      for (std::size_t c = 0; c < sorted.size(); ++c)
      {
        if ((c == a || c == b) && a != b)
        {
          continue; // a copy, which a = b = c is, too
        }
        consider(*sorted[a].second, *sorted[b].second, *sorted[c].second, *sorted[c].second);
      }
      // The middle of an edge.
      consider(*sorted[a].second, *sorted[b].second, *sorted[a].second, *sorted[b].second);
    }
  }
  return best;
}
}
