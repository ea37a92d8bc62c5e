// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunSurfaceMergeBuilder.h"

#include "gatunMergeInputCheck.h"
#include "gatunMergeOrder.h"
#include "gatunMergeRounds.h"
#include "gatunSurfaceCosts.h"

#include <algorithm>
#include <utility>

namespace gatun
{
namespace
{
/** The merges of points that are those of their places. */
std::vector<Merge> ExpandMerges(const std::vector<Merge>& merges, const MergeSurface& mesh)
{
  std::vector<Merge> all;
  all.reserve(mesh.Pairs.size());
  for (const Merge& merge : merges)
  {
    for (std::uint32_t i = mesh.CountPoints(merge.Point); i > 0; --i)
    {
      const auto& pair = mesh.Pairs[all.size()];
      all.push_back({ pair[0], pair[1], merge.Error });
    }
  }
  return all;
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
  const auto merges =
    MergeRounds<MergeSurface, SurfaceCosts>(mesh, workers, mesh.GetIsKept(), progress).Run();
  return local.MakeTree(ExpandMerges(merges, mesh));
}

//------------------------------------------------------------------------------
std::size_t CountWholeMerges(const MergeTree& tree, std::size_t merges,
  const std::function<bool(std::uint32_t, std::uint32_t)>& areTogether)
{
  const auto& all = tree.GetMerges();
  std::size_t whole = std::min(merges, all.size());
  while (whole > 0 && whole < all.size() && areTogether(all[whole - 1].Point, all[whole].Point))
  {
    --whole;
  }
  return whole;
}
}
