// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunSurfaceMergeBuilder.h"

#include "gatunMergeInputCheck.h"
#include "gatunMergeOrder.h"
#include "gatunMergeRounds.h"
#include "gatunSurfaceCosts.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace gatun
{
namespace
{
/** The merges of points that are those of their places. */
MergeTree MakeTree(
  const LocalMergeInput<3>& local, const std::vector<Merge>& merges, const MergeSurface& mesh)
{
  std::vector<Merge> all;
  std::vector<bool> isBound;
  all.reserve(mesh.Pairs.size());
  isBound.reserve(mesh.Pairs.size());
  bool hasBonds = false;
  for (const Merge& merge : merges)
  {
    for (std::uint32_t i = mesh.CountPoints(merge.Point); i > 0; --i)
    {
      const auto& pair = mesh.Pairs[all.size()];
      all.push_back({ pair[0], pair[1], merge.Error });
      isBound.push_back(i > 1);
      hasBonds = hasBonds || i > 1;
    }
  }
  return local.MakeTree(std::move(all), hasBonds ? std::move(isBound) : std::vector<bool>());
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
  return MakeTree(local, merges, mesh);
}
}
