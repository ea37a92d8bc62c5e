// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunMergeTree.h"

#include "gatunError.h"

#include <algorithm>
#include <numeric>

namespace gatun
{
//------------------------------------------------------------------------------
MergeTree::MergeTree(std::uint32_t points, std::vector<Merge> merges)
  : Points(points)
  , Merges(std::move(merges))
{
  std::vector<bool> gone(points, false);
  float largest = 0;
  this->LargestErrors.reserve(this->Merges.size());
  for (const Merge& merge : this->Merges)
  {
    const bool isValid = merge.Point < points && merge.Into < points && merge.Point != merge.Into &&
      !gone[merge.Point] && !gone[merge.Into] && merge.Error >= 0;
    if (!isValid)
    {
      throw Error(ErrorCode::InvalidInput, "the merges of points do not follow from each other");
    }
    gone[merge.Point] = true;
    largest = std::max(largest, merge.Error);
    this->LargestErrors.push_back(largest);
  }
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
  const auto& errors = this->LargestErrors;
  return static_cast<std::size_t>(
    std::partition_point(errors.begin(), errors.end(), [=](float e) { return e <= error; }) -
    errors.begin());
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
