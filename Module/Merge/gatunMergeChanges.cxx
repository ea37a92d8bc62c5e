// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunMergeChanges.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace gatun
{
MergeChanges::MergeChanges(std::shared_ptr<const MergeTree> tree)
  : Tree(std::move(tree))
  , First(Tree->GetNumberOfPoints() + std::size_t{ 1 }, 0)
  , List(Tree->GetMerges().size())
{
  const auto& merges = this->Tree->GetMerges();
  for (const Merge& merge : merges)
  {
    ++this->First[merge.Into + std::size_t{ 1 }];
  }
  std::partial_sum(this->First.begin(), this->First.end(), this->First.begin());
  std::vector<std::uint32_t> next = this->First;
  for (std::size_t i = 0; i < merges.size(); ++i)
  {
    this->List[next[merges[i].Into]++] = static_cast<std::uint32_t>(i);
  }
}

std::vector<std::uint32_t> MergeChanges::Find(std::size_t from, std::size_t to) const
{
  const auto& merges = this->Tree->GetMerges();
  const std::size_t begin = std::min({ from, to, merges.size() });
  const std::size_t end = std::min(std::max(from, to), merges.size());
  // A point that is merged in between changes, and so do those that were merged into it before.
  // Those that are merged into it in between are in the list themselves.
  std::vector<std::uint32_t> changed;
  for (std::size_t i = begin; i < end; ++i)
  {
    changed.push_back(merges[i].Point);
    for (std::size_t next = changed.size() - 1; next < changed.size(); ++next)
    {
      const std::uint32_t point = changed[next];
      const std::size_t last = this->First[point + std::size_t{ 1 }];
      for (std::size_t j = this->First[point]; j < last && this->List[j] < begin; ++j)
      {
        changed.push_back(merges[this->List[j]].Point);
      }
    }
  }
  return changed;
}
}
