// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunSurfaceMergeBuilder.h"

#include "gatunMergeInputCheck.h"
#include "gatunMergeOrder.h"
#include "gatunMergeRounds.h"
#include "gatunSurfaceCosts.h"

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace gatun
{
namespace
{
using SurfaceRounds = MergeRounds<MergeSurface, SurfaceCosts>;

/** The first pair of points of each merge of places, in the order in which they were done. */
std::vector<std::size_t> FindFirstPairs(const RankedMerges& merged, const MergeSurface& mesh)
{
  std::vector<std::size_t> counts(merged.Merges.size());
  for (std::size_t i = 0; i < counts.size(); ++i)
  {
    counts[merged.Order[i]] = mesh.CountPoints(merged.Merges[i].Point);
  }
  std::exclusive_scan(counts.begin(), counts.end(), counts.begin(), std::size_t{ 0 });
  return counts;
}

/** The merges of points that are those of their places. */
MergeTree MakeTree(const LocalMergeInput<3>& local, RankedMerges merged, const MergeSurface& mesh)
{
  std::vector<Merge> all;
  std::vector<bool> isBound;
  all.reserve(mesh.Pairs.size());
  isBound.reserve(mesh.Pairs.size());
  bool hasBonds = false;
  const auto pairs = FindFirstPairs(merged, mesh);
  auto group = merged.Groups.begin();
  for (std::size_t m = 0; m < merged.Merges.size(); ++m)
  {
    const Merge& merge = merged.Merges[m];
    if (group != merged.Groups.end() && *group == m)
    {
      *group++ = static_cast<std::uint32_t>(all.size());
    }
    auto pair = pairs[merged.Order[m]];
    for (std::uint32_t i = mesh.CountPoints(merge.Point); i > 0; --i, ++pair)
    {
      all.push_back({ mesh.Pairs[pair][0], mesh.Pairs[pair][1], merge.Error });
      isBound.push_back(i > 1);
      hasBonds = hasBonds || i > 1;
    }
  }
  return local.MakeTree(
    std::move(all), hasBonds ? std::move(isBound) : std::vector<bool>(), std::move(merged.Groups));
}
}

//------------------------------------------------------------------------------
MergeTree BuildMergeTree(const SurfaceMergeInput& input, const SurfaceMergeSettings& settings,
  const std::function<bool(double)>& progress)
{
  CheckMergeInput(input);
  CheckMergeSettings(settings);
  const LocalMergeInput<3> local(input);
  MergeSurface mesh(local.Get(), settings);
  const auto workers = MakeMergeWorkers<SurfaceCosts>(mesh);
  SurfaceRounds rounds(mesh, workers, mesh.GetIsKept(), progress);
  return MakeTree(local, rounds.Run(), mesh);
}
}
