// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunMergeTree.h"

#include "gatunError.h"

#include <algorithm>
#include <bit>
#include <functional>
#include <iterator>
#include <numeric>
#include <utility>

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
MergeTree::MergeTree(std::uint32_t points, std::vector<Merge> merges, std::vector<bool> isBound,
  std::vector<std::uint32_t> rounds)
  : Points(points)
  , Merges(std::move(merges))
  , IsBound(std::move(isBound))
  , Rounds(std::move(rounds))
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
  this->CheckRounds();
  // From the last one on: each round begins where the errors of the next one are right.
  auto end = this->Merges.end();
  for (auto round = this->Rounds.rbegin(); round != this->Rounds.rend(); ++round)
  {
    const auto first = this->Merges.begin() + *round;
    std::for_each(
      first, end, [error = std::prev(end)->Error](Merge& merge) { merge.Error = error; });
    end = first;
  }
}

//------------------------------------------------------------------------------
void MergeTree::CheckRounds() const
{
  const auto& rounds = this->Rounds;
  const bool isRight = rounds.empty() ||
    (rounds.front() == 0 && rounds.back() < this->Merges.size() &&
      std::adjacent_find(rounds.begin(), rounds.end(), std::greater_equal()) == rounds.end() &&
      std::all_of(rounds.begin(), rounds.end(),
        [this](std::uint32_t first) { return this->CountWholeMerges(first) == first; }));
  if (!isRight)
  {
    throw Error(ErrorCode::InvalidInput, "the rounds of merges do not follow from each other");
  }
}

//------------------------------------------------------------------------------
std::size_t MergeTree::CountMergesOfRounds(std::size_t merges) const
{
  const auto all = this->Merges.size();
  if (merges >= all)
  {
    return all;
  }
  if (!this->Rounds.empty())
  {
    const auto next = std::lower_bound(this->Rounds.begin(), this->Rounds.end(), merges);
    return next == this->Rounds.end() ? all : *next;
  }
  while (merges > 0 && !this->IsBound.empty() && this->IsBound[merges - 1])
  {
    ++merges;
  }
  return merges;
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
  return this->CountMergesOfRounds(static_cast<std::size_t>(gone));
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

//------------------------------------------------------------------------------
MergeTree SortRounds(const MergeTree& tree, std::span<const std::uint32_t> numbers,
  std::span<const std::uint32_t> ends)
{
  const auto& all = tree.GetMerges();
  const auto& isBound = tree.GetBonds();
  if (tree.GetRounds().empty())
  {
    return tree;
  }
  std::vector<std::uint32_t> rounds;
  std::set_union(tree.GetRounds().begin(), tree.GetRounds().end(), ends.begin(), ends.end(),
    std::back_inserter(rounds));
  std::vector<Merge> merges;
  std::vector<bool> bonds;
  merges.reserve(all.size());
  bonds.reserve(isBound.size());
  std::vector<std::uint32_t> groups; // the first merges of those that belong together
  for (std::size_t round = 0; round < rounds.size(); ++round)
  {
    const auto end = round + 1 < rounds.size() ? rounds[round + 1] : all.size();
    groups.clear();
    for (auto i = rounds[round]; i < end; ++i)
    {
      if (i == rounds[round] || isBound.empty() || !isBound[i - 1])
      {
        groups.push_back(i);
      }
    }
    std::sort(groups.begin(), groups.end(),
      [&](std::uint32_t a, std::uint32_t b)
      { return numbers[all[a].Point] < numbers[all[b].Point]; });
    for (auto merge : groups)
    {
      bool goesOn = true;
      for (; goesOn && merge < end; ++merge)
      {
        goesOn = !isBound.empty() && isBound[merge];
        merges.push_back(all[merge]);
        if (!isBound.empty())
        {
          bonds.push_back(goesOn);
        }
      }
    }
  }
  return { tree.GetNumberOfPoints(), std::move(merges), std::move(bonds), tree.GetRounds() };
}
}
