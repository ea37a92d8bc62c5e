// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunSharedGroups.h"

#include "gatunError.h"

#include <utility>

namespace gatun
{
namespace
{
// Smaller groups are stored together with others of the same first chunk.
constexpr std::int64_t LargeGroup = 256;

void AddGroup(BlockEntry& block, const ChunkGroup& chunks, std::int64_t points)
{
  block.Points += static_cast<std::uint64_t>(points);
  if (block.Points >= std::uint64_t{ 1 } << 32)
  {
    ThrowInvalid("more than 2^32 points belong to the same chunks; make chunks smaller");
  }
  block.Groups.push_back({ chunks, static_cast<std::uint32_t>(points) });
}
}

//------------------------------------------------------------------------------
void SharedGroups::Add(const ChunkGroup& chunks, std::int64_t points)
{
  const auto group = this->Points.try_emplace(chunks, 0).first;
  group->second += points;
  if (group->second == 0)
  {
    this->Points.erase(group);
  }
}

//------------------------------------------------------------------------------
void SharedGroups::Put(ByteWriter& out, std::uint32_t firstChunk) const
{
  out.PutVarint(this->Points.size());
  for (const auto& [chunks, points] : this->Points)
  {
    out.PutVarint(chunks.size());
    for (const auto chunk : chunks)
    {
      out.PutVarint(firstChunk + chunk);
    }
    out.Put(points);
  }
}

//------------------------------------------------------------------------------
void SharedGroups::Add(ByteReader& in)
{
  ChunkGroup chunks;
  for (auto count = in.GetCount(1); count > 0; --count)
  {
    chunks.resize(static_cast<std::size_t>(in.GetCount(1)));
    for (auto& chunk : chunks)
    {
      chunk = static_cast<std::uint32_t>(in.GetVarint());
    }
    this->Add(chunks, in.Get<std::int64_t>());
  }
}

//------------------------------------------------------------------------------
std::vector<BlockEntry> SharedGroups::MakeBlocks() const
{
  std::vector<BlockEntry> blocks;
  for (auto first = this->Points.begin(); first != this->Points.end();)
  {
    BlockEntry rest;
    auto last = first;
    for (; last != this->Points.end() && last->first[0] == first->first[0]; ++last)
    {
      const auto& [chunks, points] = *last;
      AddGroup(points >= LargeGroup ? blocks.emplace_back() : rest, chunks, points);
    }
    if (!rest.Groups.empty())
    {
      blocks.push_back(std::move(rest));
    }
    first = last;
  }
  return blocks;
}
}
