// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunMergeRanks.h"

#include <cmath>
#include <numeric>

namespace gatun
{
namespace
{
// A window has so large a part of the points that are left, and one merge of few.
constexpr std::size_t WindowsPerRest = 12;
constexpr std::size_t FewLeft = 4096;
}

//------------------------------------------------------------------------------
void MergeRanks::BeginWindow()
{
  const auto left = this->Next.size() - this->Ranks.size();
  this->WindowEnd = this->Ranks.size() + (left > FewLeft ? left / WindowsPerRest : 1);
  this->FirstRank = this->LastRank + 1;
}

//------------------------------------------------------------------------------
RankedMerges MergeRanks::Arrange(const std::vector<Merge>& merges, double changePerError) const
{
  std::vector<std::uint32_t> places(std::size_t{ this->LastRank } + 2, 0); // of the next of a rank
  for (const auto rank : this->Ranks)
  {
    ++places[rank + 1];
  }
  std::partial_sum(places.begin(), places.end(), places.begin());
  RankedMerges result;
  result.Order.resize(merges.size());
  for (std::uint32_t i = 0; i < merges.size(); ++i)
  {
    result.Order[places[this->Ranks[i]]++] = i;
  }
  result.Merges.reserve(merges.size());
  std::uint32_t last = 0;
  double change = 0;
  for (const auto one : result.Order)
  {
    if (result.Merges.empty() || this->Ranks[one] != last)
    {
      result.Groups.push_back(static_cast<std::uint32_t>(result.Merges.size()));
    }
    last = this->Ranks[one];
    change += this->Changes[one];
    result.Merges.push_back({ merges[one].Point, merges[one].Into,
      static_cast<float>(std::sqrt(change) / changePerError) });
  }
  return result;
}
}
