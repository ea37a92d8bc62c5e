// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunMergeTree.h"

#include "gatunError.h"

#include <algorithm>
#include <bit>
#include <numeric>

namespace gatun
{
namespace
{
/** To the next float of which only the upper half is not zero. */
float RoundUp(float error)
{
  constexpr std::uint32_t low = 0xffff;
  return std::bit_cast<float>((std::bit_cast<std::uint32_t>(error) + low) & ~low);
}
}

//------------------------------------------------------------------------------
MergeTree::MergeTree(std::uint32_t points, std::vector<Merge> merges, std::vector<bool> isBound)
  : Points(points)
  , Merges(std::move(merges))
  , IsBound(std::move(isBound))
{
  if (!this->IsBound.empty() &&
    (this->IsBound.size() != this->Merges.size() || this->IsBound.back()))
  {
    throw Error(ErrorCode::InvalidInput, "there is no merge that belongs to the last one");
  }
  std::vector<bool> gone(points, false);
  float largest = 0;
  for (Merge& merge : this->Merges)
  {
    const bool isValid = merge.Point < points && merge.Into < points && merge.Point != merge.Into &&
      !gone[merge.Point] && !gone[merge.Into] && merge.Error >= 0;
    if (!isValid)
    {
      throw Error(ErrorCode::InvalidInput, "the merges of points do not follow from each other");
    }
    gone[merge.Point] = true;
    largest = std::max(largest, RoundUp(merge.Error));
    merge.Error = largest;
  }
}

//------------------------------------------------------------------------------
std::size_t MergeTree::CountWholeMerges(std::size_t merges) const
{
  std::size_t whole = std::min(merges, this->Merges.size());
  while (whole > 0 && !this->IsBound.empty() && this->IsBound[whole - 1])
  {
    --whole;
  }
  return whole;
}

//------------------------------------------------------------------------------
std::size_t MergeTree::CountMergesForPoints(std::uint64_t pointsLeft) const
{
  const std::uint64_t gone = this->Points - std::min<std::uint64_t>(pointsLeft, this->Points);
  return std::min<std::size_t>(gone, this->Merges.size());
}

//------------------------------------------------------------------------------
std::size_t MergeTree::CountMergesForError(double error) const
{
  const auto& all = this->Merges;
  return static_cast<std::size_t>(std::partition_point(all.begin(), all.end(),
                                    [=](const Merge& merge) { return merge.Error <= error; }) -
    all.begin());
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> MergeTree::FindAncestors(std::size_t merges) const
{
  std::vector<std::uint32_t> ancestors(this->Points);
  std::iota(ancestors.begin(), ancestors.end(), 0u);
  // Backwards: who is merged into is itself merged later, if at all, so that its ancestor is known.
  for (auto i = std::min(merges, this->Merges.size()); i > 0; --i)
  {
    const Merge& merge = this->Merges[i - 1];
    ancestors[merge.Point] = ancestors[merge.Into];
  }
  return ancestors;
}

const MergeTree::Children& MergeTree::GetChildren() const
{
  Children& sorted = *this->Sorted;
  std::call_once(sorted.Once,
    [&]
    {
      std::vector<std::uint32_t> first(this->Points + std::size_t{ 1 }, 0);
      for (const Merge& merge : this->Merges)
      {
        ++first[merge.Into + std::size_t{ 1 }];
      }
      std::partial_sum(first.begin(), first.end(), first.begin());
      std::vector<std::uint32_t> list(this->Merges.size());
      std::vector<std::uint32_t> next = first;
      for (std::size_t i = 0; i < this->Merges.size(); ++i)
      {
        list[next[this->Merges[i].Into]++] = static_cast<std::uint32_t>(i);
      }
      sorted.First = std::move(first);
      sorted.List = std::move(list);
    });
  return sorted;
}

std::vector<std::uint32_t> MergeTree::FindChanges(std::size_t from, std::size_t to) const
{
  const std::size_t begin = std::min({ from, to, this->Merges.size() });
  const std::size_t end = std::min(std::max(from, to), this->Merges.size());
  if (begin == end)
  {
    return {};
  }
  // A point that is merged in between changes, and so do those that were merged into it before.
  // Those that are merged into it in between are in the list themselves.
  const Children& children = this->GetChildren();
  std::vector<std::uint32_t> changed;
  for (std::size_t i = begin; i < end; ++i)
  {
    changed.push_back(this->Merges[i].Point);
    for (std::size_t next = changed.size() - 1; next < changed.size(); ++next)
    {
      const std::uint32_t point = changed[next];
      for (std::size_t j = children.First[point]; j < children.First[point + std::size_t{ 1 }]; ++j)
      {
        if (children.List[j] >= begin)
        {
          break;
        }
        changed.push_back(this->Merges[children.List[j]].Point);
      }
    }
  }
  return changed;
}
}
