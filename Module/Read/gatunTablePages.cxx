// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunTablePages.h"

#include "gatunTableParts.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

namespace gatun
{
namespace
{
constexpr const char* MeshName = "the table of chunks";
constexpr const char* StepName = "the table of a time step";

constexpr std::uint64_t KeptBytes = 32u << 20;

// Kinds of pages. Those of time step s are of kind s + FirstStep.
constexpr std::size_t MeshPages = 0;
constexpr std::size_t LinkedChunks = 1;
constexpr std::size_t FirstStep = 2;

/** Provides the groups of a chunk, whose blocks it holds. */
class GroupsOf
{
public:
  GroupsOf(const TablePages& pages, const ChunkEntry& entry)
  {
    for (const auto& part : entry.Shared)
    {
      auto& block = this->Blocks[part.Block];
      block = block ? block : pages.GetBlock(part.Block);
    }
  }

  const SharedGroup& operator()(const ChunkEntry::Part& part) const
  {
    return this->Blocks.at(part.Block)->Groups[part.Group];
  }

private:
  std::map<std::uint32_t, std::shared_ptr<const BlockEntry>> Blocks;
};
}

//------------------------------------------------------------------------------
struct TablePages::LinkedChunk
{
  ChunkEntry Entry;

  std::uint64_t GetBytes() const
  {
    return sizeof(*this) + this->Entry.Shared.capacity() * sizeof(ChunkEntry::Part);
  }
};

//------------------------------------------------------------------------------
TablePages::TablePages(const InputFile& file, const MetaTable& meta, const CellTable* cells)
  : File(file)
  , Meta(meta)
  , Cells(cells)
  , Pages(std::make_shared<CacheBudget>(KeptBytes), CachePolicy::KeepLast)
{
  const auto where = file.FindSection(SectionTable, MeshName);
  file.Guarded(MeshName, where,
    [&]
    {
      this->Index = MeshIndex::Read(file.Read(where, MeshName), meta);
      Check(!cells || cells->Chunks.size() == this->Index.Chunks,
        "the table of cells is not that of the chunks");
      // Each chunk has a stream. A table that claims more chunks is refused later.
      const auto chunks = std::min<std::uint64_t>(this->Index.Chunks, file.GetSize());
      this->Summaries.Infos.reserve(static_cast<std::size_t>(chunks));
      this->Summaries.Lengths.reserve(static_cast<std::size_t>(chunks));
      std::vector<StreamRef> summaries;
      for (const auto& page : this->Index.Pages)
      {
        summaries.push_back(page.Summary);
      }
      file.ReadTogether(summaries,
        [&]
        {
          for (const auto& summary : summaries)
          {
            this->Summaries.Add(file.Read(summary, MeshName), this->Index, cells);
          }
        });
      this->Summaries.Finish(this->Index, meta, file.GetSize());
    });
}

//------------------------------------------------------------------------------
void TablePages::AddStep(const StreamRef& where, std::span<const std::uint8_t> bytes)
{
  this->Steps.push_back(this->File.Guarded(StepName, where,
    [&]
    {
      return StepIndex::Read(
        bytes, this->Meta, this->Index, this->Steps.empty() ? nullptr : &this->Steps.back());
    }));
  if (this->Meta.PointsMove)
  {
    const auto step = this->Steps.size() - 1;
    this->KeyStep = this->Steps.back().Key ? step : this->KeyStep;
    const auto before = step > 0 ? this->PointSteps.back().Step : 0;
    this->PointSteps.push_back(
      { this->Steps.back().PointsMove ? step : before, before >= this->KeyStep ? before : 0 });
  }
}

//------------------------------------------------------------------------------
std::uint64_t TablePages::GetNumberOfCells() const
{
  const auto& chunks = this->GetChunks();
  return chunks.empty() ? 0 : chunks.back().FirstCell + chunks.back().Cells;
}

//------------------------------------------------------------------------------
std::size_t TablePages::GetNumberOfBlocks() const
{
  return static_cast<std::size_t>(this->Index.GetNumberOfBlocks());
}

//------------------------------------------------------------------------------
CellSizes TablePages::GetSizes(std::size_t chunk) const
{
  const auto& info = this->GetChunks().at(chunk);
  const auto cells = static_cast<std::uint32_t>(info.Cells);
  return info.IsTetrahedral ? CellSizes{ true, cells, 4 * cells, 0, 0 }
                            : this->Cells->Chunks[chunk];
}

//------------------------------------------------------------------------------
std::uint64_t TablePages::GetMeshBytes(std::size_t chunk) const
{
  const auto& lengths = this->Summaries.Lengths.at(chunk);
  return std::uint64_t{ lengths.Connectivity } + lengths.Geometry;
}

//------------------------------------------------------------------------------
std::shared_ptr<const MeshPage> TablePages::GetMeshPage(std::size_t page) const
{
  return this->Pages.FindOrMake<MeshPage>({ MeshPages, page },
    [&]
    {
      const auto& where = this->Index.Pages.at(page).Details;
      return this->File.Guarded(MeshName, where,
        [&]
        {
          return MeshPage::Read(this->File.Read(where, MeshName), page, this->Index,
            this->Summaries.Lengths, this->Meta.Keep);
        });
    });
}

//------------------------------------------------------------------------------
std::shared_ptr<const StepPage> TablePages::GetStepPage(std::size_t page, std::size_t step) const
{
  const auto& where = this->Steps.at(step).Pages.at(page);
  return this->Pages.FindOrMake<StepPage>({ step + FirstStep, page },
    [&]
    {
      return this->File.Guarded(StepName, where,
        [&]
        {
          return StepPage::Read(
            this->File.Read(where, StepName), page, this->Steps[step], this->Meta, this->Index);
        });
    });
}

//------------------------------------------------------------------------------
/** The page of a block that is there. */
std::size_t TablePages::FindPage(std::size_t block) const
{
  const auto& pages = this->Index.Pages;
  const auto next = std::partition_point(
    pages.begin(), pages.end(), [&](const MeshPageRef& page) { return page.FirstBlock <= block; });
  return static_cast<std::size_t>(std::prev(next) - pages.begin());
}

//------------------------------------------------------------------------------
std::shared_ptr<const BlockEntry> TablePages::GetBlock(std::size_t block) const
{
  if (block >= this->GetNumberOfBlocks())
  {
    return { std::shared_ptr<const void>(), &this->Index.Unused };
  }
  const auto number = this->FindPage(block);
  const auto page = this->GetMeshPage(number);
  return { page,
    &page->Blocks[block - static_cast<std::size_t>(this->Index.Pages[number].FirstBlock)] };
}

//------------------------------------------------------------------------------
std::shared_ptr<const ChunkEntry> TablePages::GetChunk(std::size_t chunk) const
{
  const auto linked = this->Pages.FindOrMake<LinkedChunk>(
    { LinkedChunks, chunk }, [&] { return this->LinkChunk(chunk); });
  return { linked, &linked->Entry };
}

//------------------------------------------------------------------------------
TablePages::LinkedChunk TablePages::LinkChunk(std::size_t chunk) const
{
  const auto page = this->GetMeshPage(chunk / ChunksPerPage);
  const auto& from = page->Chunks[chunk % ChunksPerPage];
  auto entry = from.Entry;
  entry.Info = this->GetChunks()[chunk];
  entry.Sizes = this->GetSizes(chunk);
  this->File.Guarded(MeshName, this->Index.Pages[chunk / ChunksPerPage].Details,
    [&]
    {
      std::uint64_t groups = 0;
      for (const auto number : from.Blocks)
      {
        const auto block = this->GetBlock(number);
        groups += block->Groups.size();
        Check(groups <= MaxGroupsOfChunk, "a chunk shares points with too many others");
        AddParts(*block, number, static_cast<std::uint32_t>(chunk), entry.Shared);
      }
      gatun::CheckGroups(entry, GroupsOf(*this, entry));
      std::uint64_t points = 0;
      for (const auto& part : entry.Shared)
      {
        points += part.Points;
      }
      Check(points == entry.Info.SharedPoints, "a chunk has other shared points than its blocks");
    });
  entry.Shared.shrink_to_fit();
  return { std::move(entry) };
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> TablePages::GetNeighbors(std::size_t chunk) const
{
  const auto entry = this->GetChunk(chunk);
  return FindNeighbors(*entry, static_cast<std::uint32_t>(chunk), GroupsOf(*this, *entry));
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> TablePages::GetSharedUsers(std::size_t chunk) const
{
  const auto entry = this->GetChunk(chunk);
  return FindSharedUsers(*entry, static_cast<std::uint32_t>(chunk), GroupsOf(*this, *entry));
}

//------------------------------------------------------------------------------
StreamRef TablePages::GetChunkValues(std::size_t chunk, std::size_t array, std::size_t step) const
{
  array = this->Steps.at(step).GetSource(array);
  step = this->FindStep(array, step);
  if (this->Meta.IsPoints(array) && step == 0)
  {
    return {};
  }
  const auto page = this->GetStepPage(chunk / ChunksPerPage, step);
  const auto& where = page->Arrays.at(array).Chunks.at(chunk % ChunksPerPage);
  const auto& description = this->Meta.Arrays[array];
  const auto& info = this->GetChunks()[chunk];
  this->File.Guarded(StepName, this->Steps[step].Pages[chunk / ChunksPerPage],
    [&]
    {
      CheckValues(
        description, description.Where == Association::Point ? info.OwnPoints : info.Cells, where);
    });
  return where;
}

//------------------------------------------------------------------------------
StreamRef TablePages::GetBlockValues(std::size_t block, std::size_t array, std::size_t step) const
{
  array = this->Steps.at(step).GetSource(array);
  step = this->FindStep(array, step);
  if (this->Meta.IsPoints(array) && step == 0)
  {
    return {};
  }
  if (block >= this->GetNumberOfBlocks())
  {
    return this->Steps.at(step).Arrays.at(array).Unused;
  }
  const auto number = this->FindPage(block);
  const auto page = this->GetStepPage(number, step);
  const auto first = static_cast<std::size_t>(this->Index.Pages[number].FirstBlock);
  const auto& where = page->Arrays.at(array).Blocks.at(block - first);
  const auto points = this->GetBlock(block)->Points;
  this->File.Guarded(StepName, this->Steps[step].Pages[number],
    [&] { CheckValues(this->Meta.Arrays[array], points, where); });
  return where;
}

//------------------------------------------------------------------------------
ArrayRanges TablePages::GetChunkRanges(std::size_t chunk, std::size_t array, std::size_t step) const
{
  const auto page = this->GetStepPage(chunk / ChunksPerPage, this->FindStep(array, step));
  const auto count = GetRangeCount(this->Meta.Arrays.at(array).Components);
  const auto first = page->Arrays[array].Ranges.begin() +
    static_cast<std::ptrdiff_t>(count * (chunk % ChunksPerPage));
  return { first, first + static_cast<std::ptrdiff_t>(count) };
}

//------------------------------------------------------------------------------
std::vector<StreamRef> TablePages::ListPages() const
{
  std::vector<StreamRef> pages;
  for (const auto& page : this->Index.Pages)
  {
    pages.push_back(page.Details);
  }
  for (const auto& step : this->Steps)
  {
    pages.insert(pages.end(), step.Pages.begin(), step.Pages.end());
  }
  return pages;
}

//------------------------------------------------------------------------------
void TablePages::AddMeshBytes(FileStatistics& statistics) const
{
  for (const auto& palette : this->Index.Palettes)
  {
    statistics.SharedGeometryBytes += palette.Stream.Length;
  }
  const auto addBlock = [&](const BlockEntry& block)
  {
    statistics.SharedGeometryBytes += block.Geometry.Length;
    statistics.OrderBytes += block.Order.Length;
  };
  addBlock(this->Index.Unused);
  for (std::size_t p = 0; p < this->Index.Pages.size(); ++p)
  {
    const auto page = this->GetMeshPage(p);
    std::for_each(page->Blocks.begin(), page->Blocks.end(), addBlock);
    for (const auto& [chunk, blocks] : page->Chunks)
    {
      statistics.ConnectivityBytes += chunk.Connectivity.Length;
      statistics.GeometryBytes += chunk.Geometry.Length;
      statistics.OrderBytes +=
        chunk.PointOrder.Length + chunk.CellOrder.Length + chunk.Corners.Length;
    }
  }
}

//------------------------------------------------------------------------------
void TablePages::AddBytes(FileStatistics& statistics) const
{
  this->AddMeshBytes(statistics);
  statistics.ArrayBytes.resize(this->Meta.Arrays.size());
  std::uint64_t lastField = 0;
  for (std::size_t s = 0; s < this->Steps.size(); ++s)
  {
    const auto& step = this->Steps[s];
    // Steps may share their field data.
    statistics.FieldDataBytes += step.Field.Offset != lastField ? step.Field.Length : 0;
    lastField = step.Field.Offset;
    const auto arrays = step.PointsMove ? this->Meta.Arrays.size() : this->Meta.GetListedArrays();
    for (std::size_t a = 0; a < arrays; ++a)
    {
      auto& bytes = statistics.ArrayBytes[a];
      bytes += step.Arrays[a].Unused.Length;
      for (const auto& [component, palette] : step.Arrays[a].Palettes)
      {
        bytes += palette.Stream.Length;
      }
    }
    for (std::size_t p = 0; p < step.Pages.size(); ++p)
    {
      const auto page = this->GetStepPage(p, s);
      for (std::size_t a = 0; a < arrays; ++a)
      {
        for (const auto* list : { &page->Arrays[a].Chunks, &page->Arrays[a].Blocks })
        {
          for (const auto& stream : *list)
          {
            statistics.ArrayBytes[a] += stream.Length;
          }
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
void TablePages::CheckGroups() const
{
  // Each chunk names groups that name it. If the sums are equal, it names all of them.
  std::uint64_t left = 0;
  for (std::size_t chunk = 0; chunk < this->GetChunks().size(); ++chunk)
  {
    left += this->GetChunk(chunk)->Info.SharedPoints;
  }
  for (std::size_t page = 0; page < this->Index.Pages.size(); ++page)
  {
    const auto here = this->GetMeshPage(page);
    for (const auto& block : here->Blocks)
    {
      for (const auto& group : block.Groups)
      {
        left -= group.Points * group.Chunks.size();
      }
    }
  }
  if (left != 0)
  {
    this->File.Fail(
      ErrorCode::Corrupt, "some chunks do not name all blocks with their shared points");
  }
}
}
