// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunMergeCut.h"

#include "gatunError.h"

#include <algorithm>
#include <numeric>

namespace gatun
{
//------------------------------------------------------------------------------
MergeCut::MergeCut(const MergeTree& tree, std::size_t merges)
  : Done(tree.GetMerges().size(), false)
{
  std::fill_n(this->Done.begin(), std::min(merges, this->Done.size()), true);
  this->FindAncestors(tree);
}

//------------------------------------------------------------------------------
MergeCut::MergeCut(
  const MergeTree& tree, const MergeDependencies& dependencies, std::vector<bool> wanted)
  : Done(std::move(wanted))
{
  const std::size_t merges = tree.GetMerges().size();
  if (this->Done.size() != merges || dependencies.GetNumberOfMerges() != merges)
  {
    ThrowInvalid("the merges that are wanted are not those of the tree");
  }
  for (std::size_t i = 0; i < merges; ++i)
  {
    const auto earlier = dependencies.Get(i);
    this->Done[i] = this->Done[i] &&
      std::all_of(
        earlier.begin(), earlier.end(), [&](std::uint32_t merge) { return this->Done[merge]; });
  }
  this->FindAncestors(tree);
}

//------------------------------------------------------------------------------
MergeCut::MergeCut(const MergeTree& tree, std::vector<bool> done)
  : Done(std::move(done))
{
  if (this->Done.size() != tree.GetMerges().size())
  {
    ThrowInvalid("the merges are not those of the tree");
  }
  this->FindAncestors(tree);
}

//------------------------------------------------------------------------------
void MergeCut::FindAncestors(const MergeTree& tree)
{
  this->Ancestors.resize(tree.GetNumberOfPoints());
  std::iota(this->Ancestors.begin(), this->Ancestors.end(), 0u);
  // Backwards, as in MergeTree::FindAncestors.
  for (std::size_t i = this->Done.size(); i > 0; --i)
  {
    if (this->Done[i - 1])
    {
      const Merge& merge = tree.GetMerges()[i - 1];
      this->Ancestors[merge.Point] = this->Ancestors[merge.Into];
      this->Last = std::max(this->Last, i);
      ++this->Number;
    }
  }
}
}
