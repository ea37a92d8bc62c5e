// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunCoarseLayout.h"

#include "gatunError.h"
#include "gatunFileReaderInternals.h"

#include <algorithm>
#include <numeric>

namespace gatun
{
namespace
{
void SortUnique(std::vector<std::uint32_t>& list)
{
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
  list.shrink_to_fit();
}

std::vector<std::uint32_t> ListAll(std::size_t chunks)
{
  std::vector<std::uint32_t> all(chunks);
  std::iota(all.begin(), all.end(), 0u);
  return all;
}
}

//------------------------------------------------------------------------------
CoarseLayout::CoarseLayout(
  std::shared_ptr<const FileReader> file, const MergeTree& tree, MergeCut cut)
  : CoarseLayout(file, tree, std::move(cut), ListAll(file->GetChunks().size()))
{
}

CoarseLayout::CoarseLayout(std::shared_ptr<const FileReader> file, const MergeTree& tree,
  MergeCut cut, std::span<const std::uint32_t> chunks)
  : File(std::move(file))
  , Cut(std::move(cut))
  , Sources(File->GetChunks().size())
  , Given(File->GetChunks().size())
{
  this->Check(tree);
  const TablePages& tables = InternalsOf(*this->File).GetTables();
  for (std::size_t b = 0; b < tables.GetNumberOfBlocks(); ++b)
  {
    const auto& block = this->Blocks.emplace_back(tables.GetBlock(b));
    auto point = block->FirstPoint;
    for (const SharedGroup& group : block->Groups)
    {
      this->Groups.emplace_back(static_cast<std::uint32_t>(point), &group);
      point += group.Points;
    }
  }
  for (const auto chunk : chunks)
  {
    this->FindSources(chunk);
  }
  std::for_each(this->Given.begin(), this->Given.end(), SortUnique);
}

//------------------------------------------------------------------------------
void CoarseLayout::Check(const MergeTree& tree) const
{
  const auto used = this->File->GetNumberOfPoints() - this->File->GetNumberOfUnusedPoints();
  const auto end = this->File->IsSurface() ? this->File->GetNumberOfPoints() : used;
  if (this->Cut.GetAncestors().size() != this->File->GetNumberOfPoints() ||
    this->Cut.GetDone().size() != tree.GetMerges().size())
  {
    ThrowInvalid("the merges are those of another mesh", this->File->GetPath());
  }
  for (std::size_t i = 0; i < this->Cut.GetLast(); ++i)
  {
    // A point that no cell has may be merged in a surface, but none may be merged into it.
    if (tree.GetMerges()[i].Point >= end || tree.GetMerges()[i].Into >= used)
    {
      ThrowInvalid("the tree merges points that no cell has", this->File->GetPath());
    }
  }
}

//------------------------------------------------------------------------------
void CoarseLayout::FindSources(std::uint32_t chunk)
{
  std::vector<std::uint32_t> foreign;
  this->EachRun(chunk,
    [&](std::uint32_t first, std::uint32_t last)
    {
      for (auto point = first; point < last; ++point)
      {
        const auto ancestor = this->GetAncestors()[point];
        if ((ancestor < first || ancestor >= last) && !this->Has(chunk, ancestor))
        {
          foreign.push_back(ancestor);
        }
      }
    });
  SortUnique(foreign);
  for (const auto ancestor : foreign)
  {
    const auto giver = this->GetGiver(ancestor);
    this->Sources[chunk].push_back(giver);
    this->Given[giver].push_back(ancestor);
  }
  SortUnique(this->Sources[chunk]);
}

//------------------------------------------------------------------------------
/** The box of a chunk and of those whose points are ancestors of its points encloses it after the
 * merges, and so does the one that the file has for all merges up to the last one. */
Bounds CoarseLayout::GetBounds(std::uint32_t chunk, std::size_t step) const
{
  Bounds box = this->File->GetChunkBounds(chunk, this->Cut.GetLast(), step);
  if (!this->Cut.IsUniform())
  {
    Bounds parts = this->File->GetChunkBounds(chunk, 0, step);
    for (const auto source : this->GetSources(chunk))
    {
      parts.Include(this->File->GetChunkBounds(source, 0, step));
    }
    for (std::size_t axis = 0; axis < box.size(); ++axis)
    {
      box[axis].Min = std::max(box[axis].Min, parts[axis].Min);
      box[axis].Max = std::min(box[axis].Max, parts[axis].Max);
    }
  }
  return box;
}

//------------------------------------------------------------------------------
double CoarseLayout::GetShareLeft(std::uint32_t chunk) const
{
  std::uint64_t all = 0;
  std::uint64_t left = 0;
  this->EachRun(chunk,
    [&](std::uint32_t first, std::uint32_t last)
    {
      all += last - first;
      for (auto point = first; point < last; ++point)
      {
        left += this->GetAncestors()[point] == point ? 1 : 0;
      }
    });
  return all > 0 ? static_cast<double>(left) / static_cast<double>(all) : 1;
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> CoarseLayout::FindChanges(const CoarseLayout& other) const
{
  const auto& before = other.GetAncestors();
  std::vector<std::uint32_t> changes;
  for (std::uint32_t chunk = 0; chunk < this->Given.size(); ++chunk)
  {
    bool isSame = true;
    this->EachRun(chunk,
      [&](std::uint32_t first, std::uint32_t last)
      {
        const auto begin = this->GetAncestors().begin() + first;
        isSame = isSame && std::equal(begin, begin + (last - first), before.begin() + first);
      });
    if (!isSame)
    {
      changes.push_back(chunk);
    }
  }
  return changes;
}

//------------------------------------------------------------------------------
void CoarseLayout::EachRun(const FileReader& file, std::uint32_t chunk,
  const std::function<void(std::uint32_t, std::uint32_t)>& use)
{
  const auto entry = InternalsOf(file).GetTables().GetChunk(chunk);
  for (const auto& part : entry->Shared)
  {
    const auto first = static_cast<std::uint32_t>(part.FirstPoint);
    use(first, first + part.Points);
  }
  const auto first = static_cast<std::uint32_t>(entry->Info.FirstPoint);
  use(first, first + static_cast<std::uint32_t>(entry->Info.OwnPoints));
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> CoarseLayout::GetPoints(std::uint32_t chunk) const
{
  std::vector<std::uint32_t> points;
  this->EachRun(chunk,
    [&](std::uint32_t first, std::uint32_t last)
    {
      const auto count = points.size();
      points.resize(count + (last - first));
      std::iota(points.begin() + static_cast<std::ptrdiff_t>(count), points.end(), first);
    });
  return points;
}

//------------------------------------------------------------------------------
bool CoarseLayout::Has(std::uint32_t chunk, std::uint32_t point) const
{
  if (const SharedGroup* const group = this->FindGroup(point))
  {
    return std::binary_search(group->Chunks.begin(), group->Chunks.end(), chunk);
  }
  const ChunkInfo& info = this->File->GetChunks()[chunk];
  return point >= info.FirstPoint && point < info.FirstPoint + info.OwnPoints;
}

//------------------------------------------------------------------------------
const SharedGroup* CoarseLayout::FindGroup(std::uint32_t point) const
{
  if (point >= this->File->GetNumberOfSharedPoints())
  {
    return nullptr;
  }
  const auto next = std::partition_point(this->Groups.begin(), this->Groups.end(),
    [&](const auto& group) { return group.first <= point; });
  return std::prev(next)->second;
}

//------------------------------------------------------------------------------
std::uint32_t CoarseLayout::GetGiver(std::uint32_t point) const
{
  if (const SharedGroup* const group = this->FindGroup(point))
  {
    return group->Chunks.front();
  }
  const auto& chunks = this->File->GetChunks();
  const auto next = std::partition_point(chunks.begin(), chunks.end(),
    [&](const ChunkInfo& chunk) { return chunk.FirstPoint <= point; });
  return static_cast<std::uint32_t>(std::prev(next) - chunks.begin());
}
}
