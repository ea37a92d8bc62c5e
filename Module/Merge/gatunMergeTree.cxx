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
}
