// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunRayRefresh.h"

#include <algorithm>
#include <utility>

namespace gatun
{
//------------------------------------------------------------------------------
RayRefresh::RayRefresh(MakeCaster makeCaster)
  : Maker(std::move(makeCaster))
{
}

//------------------------------------------------------------------------------
double RayRefresh::Draw(
  std::shared_ptr<RaySource> source, float* rgba, const RaySource::Progress& progress)
{
  const auto last = std::exchange(this->Last, nullptr);
  auto before = std::exchange(this->Fingerprints, {});
  const auto caster = this->Maker();
  std::vector<std::uint8_t> differs(caster->GetNumberOfTiles(), 1);
  std::vector<std::uint64_t> fingerprints;
  if (last)
  {
    if (before.empty())
    {
      before = this->Maker()->GetFingerprints(*last, progress);
    }
    fingerprints = this->Maker()->GetFingerprints(*source, progress);
    for (std::size_t tile = 0; tile < differs.size(); ++tile)
    {
      differs[tile] = fingerprints[tile] == before[tile] ? 0 : 1;
    }
    caster->Restrict(differs);
  }
  caster->Draw(*source, progress);
  caster->Finish(rgba);
  this->Last = std::move(source);
  this->Fingerprints = std::move(fingerprints);
  return static_cast<double>(std::count(differs.begin(), differs.end(), 1)) /
    static_cast<double>(differs.size());
}
}
