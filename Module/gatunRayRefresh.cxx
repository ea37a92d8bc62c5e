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
std::size_t RayRefresh::Draw(RaySource& source, float* rgba, const RaySource::Progress& progress)
{
  const auto before = std::exchange(this->Fingerprints, {});
  auto fingerprints = this->Maker()->GetFingerprints(source, progress);
  std::vector<std::uint8_t> differs(fingerprints.size(), 1);
  for (std::size_t tile = 0; tile < before.size(); ++tile)
  {
    differs[tile] = fingerprints[tile] == before[tile] ? 0 : 1;
  }
  const auto caster = this->Maker();
  caster->Restrict(differs);
  caster->Draw(source, progress);
  caster->Finish(rgba);
  this->Fingerprints = std::move(fingerprints);
  return static_cast<std::size_t>(std::count(differs.begin(), differs.end(), 1));
}
}
