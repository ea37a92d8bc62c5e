// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunWriterPart.h"

#include "gatunError.h"

namespace gatun
{
//------------------------------------------------------------------------------
void WriterPart::PlaceShared(
  const MeshTable& table, const std::map<ChunkGroup, std::vector<std::uint32_t>>& groups)
{
  const auto add = [&](const SharedGroup& group)
  {
    const auto points = groups.find(group.Chunks);
    if (points == groups.end() || points->second.size() != group.Points)
    {
      ThrowInvalid("a part has changed since it was surveyed");
    }
    this->SharedPoints.insert(
      this->SharedPoints.end(), points->second.begin(), points->second.end());
  };
  const auto end = this->Place.FirstBlock + this->Place.Blocks;
  for (auto b = this->Place.FirstBlock; b < end; ++b)
  {
    for (const auto& group : table.Blocks[b].Groups)
    {
      add(group);
    }
  }
  for (std::size_t c = 0; c < this->Layout.GetChunkCount(); ++c)
  {
    for (const auto& part : table.Chunks[this->Place.FirstChunk + c].Shared)
    {
      if ((part.Block < this->Place.FirstBlock || part.Block >= end) &&
        this->OtherGroups.try_emplace({ part.Block, part.Group }, this->SharedPoints.size()).second)
      {
        add(table.Blocks[part.Block].Groups[part.Group]);
      }
    }
  }
}

//------------------------------------------------------------------------------
std::span<const std::uint32_t> WriterPart::GetBlockPoints(
  const MeshTable& table, std::size_t block) const
{
  const auto& first = table.Blocks[this->Place.FirstBlock];
  const auto& entry = table.Blocks[this->Place.FirstBlock + block];
  return std::span(this->SharedPoints)
    .subspan(static_cast<std::size_t>(entry.FirstPoint - first.FirstPoint),
      static_cast<std::size_t>(entry.Points));
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> WriterPart::GetSharedPoints(
  const MeshTable& table, std::size_t chunk) const
{
  std::vector<std::uint32_t> points;
  for (const auto& part : table.Chunks[this->Place.FirstChunk + chunk].Shared)
  {
    const auto& group = table.Blocks[part.Block].Groups[part.Group];
    const auto other = this->OtherGroups.find({ part.Block, part.Group });
    const auto found = other != this->OtherGroups.end()
      ? std::span(this->SharedPoints).subspan(other->second, group.Points)
      : this->GetBlockPoints(table, part.Block - this->Place.FirstBlock)
          .subspan(static_cast<std::size_t>(part.FirstInBlock), group.Points);
    points.insert(points.end(), found.begin(), found.end());
  }
  return points;
}
}
