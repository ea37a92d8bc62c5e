// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunHartleyChunks.h"

#include "gatunParallel.h"

#include <vector>

namespace gatun
{
namespace
{
//------------------------------------------------------------------------------
std::uint64_t GetBytes(const HartleyChunk& chunk)
{
  return chunk.Starts.size() * sizeof(chunk.Starts[0]) +
    chunk.Terms.size() * sizeof(chunk.Terms[0]) + sizeof(chunk);
}
}

//------------------------------------------------------------------------------
void HartleyChunks::Load(std::span<const HartleyLayout::Triple> blocks)
{
  Map wanted;
  for (const auto& place : blocks)
  {
    wanted.try_emplace(this->Layout.GetChunkOfBlock(place));
  }
  std::vector<Map::value_type*> missing;
  for (auto& one : wanted)
  {
    const auto used = this->Used.find(one.first);
    one.second = used != this->Used.end() ? used->second : this->Kept.Find(one.first);
    if (!one.second)
    {
      missing.push_back(&one);
    }
  }
  this->Used.clear();
  ParallelFor(missing.size(),
    [&](std::size_t i) { missing[i]->second = this->Source.GetChunk(missing[i]->first); });
  for (const auto* const one : missing)
  {
    this->Kept.Keep(one->first, one->second, GetBytes(*one->second));
  }
  this->Used = std::move(wanted);
}

//------------------------------------------------------------------------------
std::span<const HartleyTerm> HartleyChunks::GetTerms(const HartleyLayout::Triple& place) const
{
  const std::size_t chunk = this->Layout.GetChunkOfBlock(place);
  const auto box = this->Layout.GetBlocksOfChunk(chunk);
  const std::size_t width = box.End[0] - box.First[0];
  const std::size_t height = box.End[1] - box.First[1];
  const std::size_t number = place[0] - box.First[0] +
    width * (place[1] - box.First[1] + height * (place[2] - box.First[2]));
  return this->Used.at(chunk)->GetBlock(number);
}
}
