// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunJoinedRaySource.h"

#include <numeric>

namespace gatun
{
//------------------------------------------------------------------------------
JoinedRaySource::JoinedRaySource(std::vector<std::shared_ptr<RaySource>> sources)
  : Sources(std::move(sources))
{
  for (std::size_t source = 0; source < this->Sources.size(); ++source)
  {
    for (std::size_t block = 0; block < this->Sources[source]->GetNumberOfBlocks(); ++block)
    {
      this->Places.emplace_back(source, block);
    }
  }
}

//------------------------------------------------------------------------------
const Bounds& JoinedRaySource::GetBounds(std::size_t block) const
{
  const auto& [source, place] = this->Places[block];
  return this->Sources[source]->GetBounds(place);
}

//------------------------------------------------------------------------------
Range JoinedRaySource::GetRange(std::size_t block) const
{
  const auto& [source, place] = this->Places[block];
  return this->Sources[source]->GetRange(place);
}

//------------------------------------------------------------------------------
double JoinedRaySource::GetSimplifyTime() const
{
  return std::accumulate(this->Sources.begin(), this->Sources.end(), 0.0,
    [](double sum, const auto& source) { return sum + source->GetSimplifyTime(); });
}

//------------------------------------------------------------------------------
RaySource::Blocks JoinedRaySource::GetBlocks(
  std::span<const std::size_t> blocks, const Progress& progress)
{
  Blocks result(blocks.size());
  for (std::size_t source = 0; source < this->Sources.size(); ++source)
  {
    std::vector<std::size_t> wanted;
    std::vector<std::size_t> where;
    for (std::size_t i = 0; i < blocks.size(); ++i)
    {
      if (this->Places[blocks[i]].first == source)
      {
        wanted.push_back(this->Places[blocks[i]].second);
        where.push_back(i);
      }
    }
    if (wanted.empty())
    {
      continue;
    }
    auto made = this->Sources[source]->GetBlocks(wanted, progress);
    for (std::size_t i = 0; i < made.size(); ++i)
    {
      result[where[i]] = std::move(made[i]);
    }
  }
  return result;
}
}
