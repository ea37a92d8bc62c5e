// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunMergeBuilder.h"

#include "gatunMergeFields.h"
#include "gatunMergeInputCheck.h"
#include "gatunMergeOrder.h"
#include "gatunTetRounds.h"

#include <utility>

namespace gatun
{
template class MergeRounds<MergeMesh, MergeCosts<0>>;
template class MergeRounds<MergeMesh, MergeCosts<1>>;

namespace
{
template <std::size_t NumberOfFields>
MergeTree FindMerges(const LocalMergeInput<4>& local, const MergeSettings& settings,
  const std::function<bool(double)>& progress)
{
  using Costs = MergeCosts<NumberOfFields>;
  const MergeInput& input = local.Get();
  MergeMesh mesh(input.Points.size(), input.Cells);
  const MergeFields fields(mesh, input);
  const auto workers = MakeMergeWorkers<Costs>(mesh, fields, settings);
  MergeRounds<MergeMesh, Costs> rounds(mesh, workers, input.IsKept, progress, settings.PartAtOnce);
  auto merged = rounds.Run();
  return local.MakeTree(std::move(merged.Merges), {}, std::move(merged.Groups));
}
}

//------------------------------------------------------------------------------
MergeTree BuildMergeTree(const MergeInput& input, const MergeSettings& settings,
  const std::function<bool(double)>& progress)
{
  CheckMergeInput(input);
  CheckMergeSettings(settings);
  const LocalMergeInput<4> local(input);
  // One field, which is frequent, is faster if its loops are known when they are compiled.
  return input.Fields.size() == 1 ? FindMerges<1>(local, settings, progress)
                                  : FindMerges<0>(local, settings, progress);
}
}
