// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunChunkSet.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace gatun
{
//------------------------------------------------------------------------------
ChunkSet::ChunkSet(const FileReader::Internals& content, std::vector<std::uint32_t> chunks,
  std::vector<std::uint32_t> universe, bool withUnusedPoints, PieceForm form)
  : Content(content)
  , Chunks(std::move(chunks))
  , Universe(std::move(universe))
  , WithUnused(withUnusedPoints)
  , Form(content.Cells ? form : PieceForm::Tetrahedra)
{
  const auto& tables = this->Content.GetTables();
  std::vector<std::uint32_t> needed;
  for (const auto c : this->Chunks)
  {
    const auto entry = tables.GetChunk(c);
    for (const auto& part : entry->Shared)
    {
      needed.push_back(part.Block);
    }
  }
  std::sort(needed.begin(), needed.end());
  needed.erase(std::unique(needed.begin(), needed.end()), needed.end());
  for (const auto index : needed)
  {
    this->Blocks.push_back(
      { index, std::vector<std::uint64_t>(tables.GetBlock(index)->Groups.size(), Absent) });
  }
  for (const auto c : this->Chunks)
  {
    const auto entry = tables.GetChunk(c);
    for (const auto& part : entry->Shared)
    {
      this->Blocks[this->FindBlock(part.Block)].GroupStart[part.Group] = 0;
    }
  }
  for (auto& block : this->Blocks)
  {
    const auto entry = tables.GetBlock(block.Index);
    for (std::size_t g = 0; g < block.GroupStart.size(); ++g)
    {
      if (block.GroupStart[g] != Absent)
      {
        block.GroupStart[g] = this->Points;
        this->Points += entry->Groups[g].Points;
      }
    }
  }
  for (const auto c : this->Chunks)
  {
    this->FirstOwn.push_back(this->Points);
    const auto& info = tables.GetChunks()[c];
    this->Points += info.OwnPoints;
    this->Begins.push_back(this->Ends);
    if (this->Form == PieceForm::Tetrahedra)
    {
      this->Ends.Cells += info.Tets;
      this->Ends.Corners += 4 * info.Tets;
    }
    else
    {
      const auto sizes = tables.GetSizes(c);
      this->Ends.Cells += sizes.Cells;
      this->Ends.Corners += sizes.Corners;
      this->Ends.FaceValues += std::uint64_t{ sizes.FaceValues } + sizes.Polyhedra;
    }
  }
  this->FirstUnused = this->Points;
  const auto unused = this->Content.Meta.UnusedPoints;
  if (this->WithUnused && unused > 0)
  {
    this->Points += unused;
    this->Blocks.push_back({ static_cast<std::uint32_t>(tables.GetNumberOfBlocks()), {} });
  }
}

//------------------------------------------------------------------------------
std::uint64_t ChunkSet::GetNumberOfCells(std::size_t i) const
{
  const auto end = i + 1 < this->Begins.size() ? this->Begins[i + 1].Cells : this->Ends.Cells;
  return end - this->Begins[i].Cells;
}

//------------------------------------------------------------------------------
std::size_t ChunkSet::FindBlock(std::uint32_t index) const
{
  return static_cast<std::size_t>(
    std::lower_bound(this->Blocks.begin(), this->Blocks.end(), index,
      [](const Block& block, std::uint32_t wanted) { return block.Index < wanted; }) -
    this->Blocks.begin());
}

//------------------------------------------------------------------------------
bool ChunkSet::IsWhole() const
{
  const auto& content = this->Content;
  return this->Chunks.size() == content.GetTables().GetChunks().size() &&
    (this->WithUnused || content.Meta.UnusedPoints == 0);
}

//------------------------------------------------------------------------------
void ChunkSet::MarkOwners(unsigned char* ghosts) const
{
  std::memset(ghosts, 0, static_cast<std::size_t>(this->Points));
  for (const auto& block : this->Blocks)
  {
    const auto entry = this->Content.GetTables().GetBlock(block.Index);
    for (std::size_t g = 0; g < block.GroupStart.size(); ++g)
    {
      const auto& group = entry->Groups[g];
      if (block.GroupStart[g] != Absent && !this->Owns(group))
      {
        std::memset(ghosts + block.GroupStart[g], 1, group.Points);
      }
    }
  }
}

//------------------------------------------------------------------------------
bool ChunkSet::Owns(const SharedGroup& group) const
{
  const auto has = [](const std::vector<std::uint32_t>& set, std::uint32_t chunk)
  { return std::binary_search(set.begin(), set.end(), chunk); };
  const auto owner = this->Universe.empty()
    ? group.Chunks.begin()
    : std::find_if(group.Chunks.begin(), group.Chunks.end(),
        [&](std::uint32_t chunk) { return has(this->Universe, chunk); });
  return owner != group.Chunks.end() && has(this->Chunks, *owner);
}

//------------------------------------------------------------------------------
std::vector<std::uint64_t> ChunkSet::Locate(const ChunkSet& part) const
{
  const auto& tables = this->Content.GetTables();
  std::vector<std::uint64_t> places(static_cast<std::size_t>(part.Points));
  const auto copy = [&](std::uint64_t from, std::uint64_t to, std::uint64_t count)
  {
    for (std::uint64_t i = 0; i < count; ++i)
    {
      places[static_cast<std::size_t>(from + i)] = to + i;
    }
  };
  for (const auto& block : part.Blocks)
  {
    const auto entry = tables.GetBlock(block.Index);
    for (std::size_t g = 0; g < block.GroupStart.size(); ++g)
    {
      if (block.GroupStart[g] != Absent)
      {
        copy(block.GroupStart[g], this->Blocks[this->FindBlock(block.Index)].GroupStart[g],
          entry->Groups[g].Points);
      }
    }
  }
  for (std::size_t i = 0, j = 0; j < part.Chunks.size(); ++i)
  {
    if (this->Chunks[i] == part.Chunks[j])
    {
      copy(part.FirstOwn[j], this->FirstOwn[i], tables.GetChunks()[part.Chunks[j]].OwnPoints);
      ++j;
    }
  }
  if (part.WithUnused)
  {
    copy(part.FirstUnused, this->FirstUnused, this->Content.Meta.UnusedPoints);
  }
  return places;
}
}
