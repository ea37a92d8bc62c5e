// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunMeshTable.h"

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace gatun
{
//------------------------------------------------------------------------------
void CheckGroups(const ChunkEntry& entry, const GetGroupFunction& groupOf)
{
  std::uint64_t members = 0;
  for (const auto& part : entry.Shared)
  {
    members += groupOf(part).Chunks.size();
  }
  Check(members <= MaxGroupsOfChunk, "a chunk shares points with too many others");
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> FindNeighbors(
  const ChunkEntry& entry, std::uint32_t chunk, const GetGroupFunction& groupOf)
{
  std::vector<std::uint32_t> near;
  for (const auto& part : entry.Shared)
  {
    const auto& users = groupOf(part).Chunks;
    near.insert(near.end(), users.begin(), users.end());
  }
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  std::erase(near, chunk);
  near.shrink_to_fit();
  return near;
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> FindSharedUsers(
  const ChunkEntry& entry, std::uint32_t chunk, const GetGroupFunction& groupOf)
{
  const auto near = FindNeighbors(entry, chunk, groupOf);
  std::vector<std::uint32_t> users;
  users.reserve(static_cast<std::size_t>(entry.Info.SharedPoints));
  for (const auto& part : entry.Shared)
  {
    const auto& group = groupOf(part);
    std::uint32_t mask = 0;
    // Bit 31 is the last to be set, because the group's chunks and the neighbors ascend.
    for (auto c = group.Chunks.begin(); c != group.Chunks.end() && mask >> 31 == 0; ++c)
    {
      if (*c != chunk)
      {
        const auto place = std::lower_bound(near.begin(), near.end(), *c) - near.begin();
        mask |= 1u << std::min<std::ptrdiff_t>(place, 31);
      }
    }
    users.insert(users.end(), group.Points, mask);
  }
  return users;
}

//------------------------------------------------------------------------------
void MeshTable::LinkGroups()
{
  std::uint64_t point = 0;
  for (std::uint32_t b = 0; b < this->Blocks.size(); ++b)
  {
    auto& block = this->Blocks[b];
    block.FirstPoint = point;
    std::uint64_t inBlock = 0;
    for (std::uint32_t g = 0; g < block.Groups.size(); ++g)
    {
      const auto& group = block.Groups[g];
      Check(group.Chunks.back() < this->Chunks.size(), "a group names a chunk that is not there");
      for (const auto c : group.Chunks)
      {
        this->Chunks[c].Shared.push_back({ b, g, group.Points, inBlock, point + inBlock });
        this->Chunks[c].Info.SharedPoints += group.Points;
      }
      inBlock += group.Points;
    }
    point += block.Points;
  }
  for (const auto& chunk : this->Chunks)
  {
    std::uint64_t groups = 0;
    for (auto part = chunk.Shared.begin(); part != chunk.Shared.end(); ++part)
    {
      const bool isFirst = part == chunk.Shared.begin() || std::prev(part)->Block != part->Block;
      groups += isFirst ? this->Blocks[part->Block].Groups.size() : 0;
    }
    Check(groups <= MaxGroupsOfChunk, "a chunk shares points with too many others");
    CheckGroups(
      chunk, [&](const auto& part) -> const SharedGroup& { return this->GetGroup(part); });
  }
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> MeshTable::GetSharedUsers(std::uint32_t chunk) const
{
  return FindSharedUsers(this->Chunks[chunk], chunk,
    [&](const auto& part) -> const SharedGroup& { return this->GetGroup(part); });
}

//------------------------------------------------------------------------------
std::uint64_t MeshTable::GetSharedPoints() const
{
  return this->Blocks.empty() ? 0 : this->Blocks.back().FirstPoint + this->Blocks.back().Points;
}
}
