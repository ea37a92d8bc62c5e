// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunBytePlan.h"

#include "gatunCoarseLayout.h"
#include "gatunFileReaderInternals.h"
#include "gatunRegion.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

namespace gatun
{
namespace
{
/** Lists the streams of chunks and of the blocks of their shared points. */
class PiecePlanner
{
public:
  PiecePlanner(const FileReader& file, const PieceRequest& request)
    : Content(InternalsOf(file))
    , HasOrder(file.GetKeptOrder() != KeepNone)
  {
    for (const auto array : request.Arrays)
    {
      const auto first = this->Content.FindKeyStep(array, request.Step);
      for (auto step = first; step <= request.Step; ++step)
      {
        this->Values.emplace_back(array, step);
      }
    }
    if (this->Content.Meta.PointsMove && request.Step < file.GetNumberOfSteps())
    {
      const auto& tables = this->Content.GetTables();
      for (auto step = tables.GetPointStep(request.Step); step > 0;
           step = tables.GetPointReference(step))
      {
        this->Values.emplace_back(this->Content.GetPointArray(), step);
      }
    }
  }

  /** Reads the palettes of the arrays, which are tables. */
  void ReadDomains() const
  {
    for (const auto& [array, step] : this->Values)
    {
      this->Content.MakeDomains(array, step);
    }
  }

  void AddChunk(std::uint32_t chunk, std::vector<ByteRange>& ranges)
  {
    const auto& tables = this->Content.GetTables();
    const auto entry = tables.GetChunk(chunk);
    this->Add(entry->Connectivity, ranges);
    this->Add(entry->Geometry, ranges);
    if (this->HasOrder)
    {
      this->Add(entry->PointOrder, ranges);
      this->Add(entry->CellOrder, ranges);
      this->Add(entry->Corners, ranges);
    }
    for (const auto& [array, step] : this->Values)
    {
      this->Add(tables.GetChunkValues(chunk, array, step), ranges);
    }
    for (const auto& part : entry->Shared)
    {
      this->Blocks.insert(part.Block);
    }
  }

  void AddUnusedPoints()
  {
    this->Blocks.insert(static_cast<std::uint32_t>(this->Content.GetTables().GetNumberOfBlocks()));
  }

  const std::set<std::uint32_t>& GetBlocks() const { return this->Blocks; }

  void AddBlock(std::uint32_t block, std::vector<ByteRange>& ranges) const
  {
    const auto& tables = this->Content.GetTables();
    const auto entry = tables.GetBlock(block);
    this->Add(entry->Geometry, ranges);
    if (this->HasOrder)
    {
      this->Add(entry->Order, ranges);
    }
    for (const auto& [array, step] : this->Values)
    {
      if (this->Content.Meta.Arrays[array].Where == Association::Point)
      {
        this->Add(tables.GetBlockValues(block, array, step), ranges);
      }
    }
  }

private:
  void Add(const StreamRef& stream, std::vector<ByteRange>& ranges) const
  {
    this->Content.File.AddRanges(stream, ranges);
  }

  const FileReader::Internals& Content;
  const bool HasOrder;
  std::vector<std::pair<std::uint32_t, std::size_t>> Values; // arrays and their steps
  std::set<std::uint32_t> Blocks;
};
}

//------------------------------------------------------------------------------
void PlanPiece(const FileReader& file, const PieceRequest& request, BytePlan& plan)
{
  auto chunks = request.Chunks;
  if (request.Merges > 0 && request.Cut && request.GhostLevels == 0)
  {
    for (const auto chunk : request.Chunks)
    {
      const auto sources = request.Cut->GetSources(chunk);
      chunks.insert(chunks.end(), sources.begin(), sources.end());
    }
    std::sort(chunks.begin(), chunks.end());
    chunks.erase(std::unique(chunks.begin(), chunks.end()), chunks.end());
  }
  else if (request.Merges > 0)
  {
    // Points come from anywhere.
    chunks.resize(file.GetChunks().size());
    std::iota(chunks.begin(), chunks.end(), 0u);
  }
  else if (request.GhostLevels > 0)
  {
    plan.Try(
      [&] { chunks = Surround(file, request.Chunks, request.Universe, request.GhostLevels); });
  }
  PiecePlanner planner(file, request);
  plan.Try([&] { planner.ReadDomains(); });
  for (const auto chunk : chunks)
  {
    plan.Try([&] { planner.AddChunk(chunk, plan.Ranges); });
  }
  if (request.WithUnusedPoints && file.GetNumberOfUnusedPoints() > 0)
  {
    planner.AddUnusedPoints();
  }
  for (const auto block : planner.GetBlocks())
  {
    plan.Try([&] { planner.AddBlock(block, plan.Ranges); });
  }
}

//------------------------------------------------------------------------------
void FetchPiece(const FileReader& file, const PieceRequest& request)
{
  const auto& source = InternalsOf(file).File.GetSource();
  if (source.IsRemote())
  {
    BytePlan plan;
    PlanPiece(file, request, plan);
    source.Fetch(JoinRanges(std::move(plan.Ranges), 0));
  }
}
}
