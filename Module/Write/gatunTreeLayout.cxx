// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunTreeLayout.h"

#include "gatunParallel.h"

#include <algorithm>

namespace gatun
{
namespace
{
// Coarser meshes need no merge counts: their chunks extend over the whole mesh.
constexpr std::uint32_t FewPoints = 256;
}

//------------------------------------------------------------------------------
TreeLayout::TreeLayout(MergeTree tree, const MeshTable& mesh)
  : Tree(std::move(tree))
{
  const auto merges = static_cast<std::uint32_t>(this->Tree.GetMerges().size());
  const auto used = this->Tree.GetNumberOfPoints() - static_cast<std::uint32_t>(mesh.Unused.Points);
  for (auto left = used / 2; left >= FewPoints && used - left < merges; left /= 2)
  {
    this->MergeCounts.push_back(used - left);
  }
  if (merges > 0)
  {
    this->MergeCounts.push_back(merges);
  }
  auto own = mesh.GetSharedPoints();
  for (const ChunkEntry& chunk : mesh.Chunks)
  {
    auto& runs = this->Runs.emplace_back();
    for (const auto& part : chunk.Shared)
    {
      runs.emplace_back(part.FirstPoint, part.FirstPoint + part.Points);
    }
    runs.emplace_back(own, own + chunk.Info.OwnPoints);
    own += chunk.Info.OwnPoints;
  }
}

//------------------------------------------------------------------------------
std::vector<Range> TreeLayout::FindRanges(std::uint32_t merges, const GetValue& getValue) const
{
  // For each point, the range over all points that it is merged into.
  std::vector<Range> ways(this->Tree.GetNumberOfPoints());
  for (std::uint32_t i = 0; i < ways.size(); ++i)
  {
    const double value = getValue(i);
    if (value == value)
    {
      ways[i] = { value, value };
    }
  }
  // Backwards, because a point that is merged into is itself merged later.
  for (auto i = merges; i > 0; --i)
  {
    const Merge& merge = this->Tree.GetMerges()[i - 1];
    ways[merge.Point].Include(ways[merge.Into]);
  }
  std::vector<Range> chunks(this->Runs.size());
  for (std::size_t c = 0; c < chunks.size(); ++c)
  {
    for (const auto& [first, last] : this->Runs[c])
    {
      for (auto i = first; i < last; ++i)
      {
        chunks[c].Include(ways[static_cast<std::size_t>(i)]);
      }
    }
  }
  return chunks;
}

//------------------------------------------------------------------------------
std::vector<std::vector<Range>> TreeLayout::FindRanges(const GetValue& getValue) const
{
  std::vector<std::vector<Range>> ranges(
    this->Runs.size(), std::vector<Range>(this->MergeCounts.size()));
  ParallelFor(this->MergeCounts.size(),
    [&](std::size_t mergeCount)
    {
      const auto chunks = this->FindRanges(this->MergeCounts[mergeCount], getValue);
      for (std::size_t c = 0; c < chunks.size(); ++c)
      {
        ranges[c][mergeCount] = chunks[c];
      }
    });
  return ranges;
}
}
