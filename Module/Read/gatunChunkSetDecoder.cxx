// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunChunkSetDecoder.h"

#include "gatunChunkSetDecoderInternals.h"
#include "gatunFloatEnvironment.h"
#include "gatunParallel.h"
#include "gatunPieceRequest.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <numeric>

namespace gatun
{
namespace
{
/** The number of steps to decode at once, chunk by chunk. More steps need more memory for shared
 * points. With fewer steps, meshes that do not fit into the cache are decoded more often. */
constexpr std::size_t StepsAtOnce = 16;
}

//------------------------------------------------------------------------------
std::size_t ChunkSetDecoder::Job::CountSteps() const
{
  std::size_t steps = 1;
  for (const auto& array : this->Arrays)
  {
    for (const auto& other : this->Arrays)
    {
      steps = std::max(steps, other.Last - std::min(array.First, other.Last) + 1);
    }
  }
  return steps;
}

//------------------------------------------------------------------------------
void ChunkSetDecoder::Job::BeginRound(const PartDecoder& parts, std::size_t most)
{
  constexpr auto none = std::numeric_limits<std::size_t>::max();
  auto next = none;
  std::size_t last = 0;
  for (const auto& array : this->Arrays)
  {
    const auto from = this->IsFirst ? array.First : std::max(this->End + 1, array.First);
    next = from <= array.Last ? std::min(next, from) : next;
    last = std::max(last, array.Last);
  }
  this->Begin = next == none ? last : next;
  this->End = std::min(last, this->Begin + most - 1);
  this->IsLast = this->End == last;
  for (auto& array : this->Arrays)
  {
    array.Domains.clear();
    for (auto at = this->Begin; at <= this->End; ++at)
    {
      array.Domains.push_back(
        at >= array.KeyStep && at <= array.Last ? parts.GetDomains(array.Index, at) : nullptr);
    }
    array.LastDomains = this->IsLast ? parts.GetDomains(array.Index, array.Last) : nullptr;
  }
}

//------------------------------------------------------------------------------
ChunkSetDecoder::ChunkSetDecoder(const std::shared_ptr<ChunkCache>& cache,
  std::vector<std::uint32_t> chunks, std::vector<std::uint32_t> universe, bool withUnusedPoints,
  PieceForm form)
  : Parts(cache)
  , Set(this->Parts.Content(), std::move(chunks), std::move(universe), withUnusedPoints, form)
{
}

//------------------------------------------------------------------------------
void ChunkSetDecoder::Fill(const PieceTarget& target, const std::vector<std::uint32_t>& arrays,
  std::size_t step, bool restoreOrder, const Progress& progress) const
{
  const auto& content = this->Content();
  const auto keep = content.Meta.Keep;
  const auto restore = restoreOrder && this->Set.IsWhole() ? keep : 0;
  const bool restorePoints = (restore & KeepPoints) != 0;
  const bool isOriginal = this->Set.GetForm() == PieceForm::Original || !content.Cells;
  const bool restoreCells = (restore & KeepCells) != 0 && isOriginal;
  const auto pointStep =
    step < content.GetSteps().size() ? content.GetTables().GetPointStep(step) : 0;
  Job job{ content.File, target, restorePoints, restoreCells, (restore & KeepCorners) != 0,
    (keep & KeepPoints) != 0 && (restorePoints || target.GlobalPointIds),
    (keep & KeepCells) != 0 && (restoreCells || target.GlobalCellIds),
    target.Points && pointStep == 0, {}, {}, {}, {}, 0, 0, true, false, {}, {} };
  if (restorePoints)
  {
    job.PointTaken =
      std::vector<std::atomic<bool>>(static_cast<std::size_t>(this->Set.GetNumberOfPoints()));
  }
  if (restoreCells)
  {
    job.CellTaken =
      std::vector<std::atomic<bool>>(static_cast<std::size_t>(this->Set.GetNumberOfCells()));
    job.Placed.resize(this->Set.GetForm() == PieceForm::Original && target.Types
        ? this->Set.GetChunks().size()
        : 0);
  }
  for (std::size_t a = 0; a < target.Arrays.size(); ++a)
  {
    if (target.Arrays[a])
    {
      job.Add(content, content.FindSource(arrays[a], step), step,
        static_cast<std::uint8_t*>(target.Arrays[a]),
        content.Meta.Arrays[arrays[a]].Where == Association::Point);
    }
  }
  if (target.Points && pointStep > 0)
  {
    const auto points = content.GetPointArray();
    job.Add(content, content.FindSource(points, pointStep), pointStep,
      static_cast<std::uint8_t*>(target.Points), true);
  }
  this->Plan(job);

  // Cached chunks come first, before they are evicted.
  std::vector<std::size_t> order(this->Set.GetChunks().size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::stable_partition(
    order.begin(), order.end(), [&](std::size_t i) { return job.Chunks[i].Mesh != nullptr; });

  const auto steps = static_cast<double>(job.CountSteps());
  double done = 0;
  while (!job.IsLast)
  {
    job.BeginRound(this->Parts, StepsAtOnce);
    ParallelFor(this->Set.GetBlocks().size(),
      [&](std::size_t b)
      {
        const FloatEnvironment guard;
        this->DecodeBlock(job, b);
      });
    const auto share = static_cast<double>(job.End - job.Begin + 1) / steps;
    ParallelFor(
      this->Set.GetChunks().size(),
      [&](std::size_t i)
      {
        const FloatEnvironment guard;
        this->DecodeChunkInto(job, order[i]);
      },
      [&](double part) { return !progress || progress(done + share * part); });
    done += share;
    job.IsFirst = false;
  }
  if (this->Set.GetForm() == PieceForm::Original && target.Types)
  {
    this->FinishOriginal(job);
  }
}

/** Takes parts from the cache, so that they stay, and determines the parts to decode. */
void ChunkSetDecoder::Plan(Job& job) const
{
  job.Blocks.resize(this->Set.GetBlocks().size());
  job.Chunks.resize(this->Set.GetChunks().size());
  for (auto& block : job.Blocks)
  {
    block.NeedsPoints = job.HasMeshPoints;
  }
  for (std::size_t i = 0; i < this->Set.GetChunks().size(); ++i)
  {
    auto& work = job.Chunks[i];
    work.Mesh = this->Parts.FindMesh(this->Set.GetChunks()[i]);
    const auto entry = this->Content().GetTables().GetChunk(this->Set.GetChunks()[i]);
    for (const auto& part : entry->Shared)
    {
      auto& needed = job.Blocks[this->Set.FindBlock(part.Block)].NeedsPoints;
      needed = needed || !work.Mesh;
    }
    for (auto& array : job.Arrays)
    {
      work.Reached.push_back(this->Parts.FindChunkArray(
        this->Set.GetChunks()[i], array.Index, array.KeyStep, array.Last));
      const auto& reached = work.Reached.back();
      array.First = std::min(array.First, reached.Values ? reached.Step + 1 : array.KeyStep);
    }
  }
}

//------------------------------------------------------------------------------
void ChunkSetDecoder::DecodeBlock(Job& job, std::size_t b) const
{
  const auto index = this->Set.GetBlocks()[b].Index;
  auto& work = job.Blocks[b];
  if (work.NeedsPoints && !work.Points)
  {
    work.Points = this->Parts.GetBlockPoints(index);
  }
  if (job.NeedsPointOrder && !work.Order)
  {
    work.Order = this->Parts.GetBlockOrder(index);
  }
  work.Steps.resize(job.Arrays.size());
  PartFits fits;
  for (std::size_t a = 0; a < job.Arrays.size(); ++a)
  {
    const auto& array = job.Arrays[a];
    if (!array.OfPoints)
    {
      continue;
    }
    if (work.Reached.size() <= a)
    {
      work.Reached.resize(a + 1);
      work.Reached[a] = this->Parts.FindBlockArray(index, array.Index, array.KeyStep, array.First);
    }
    auto& reached = work.Reached[a];
    auto& steps = work.Steps[a];
    steps.assign(job.End - job.Begin + 1, nullptr);
    const auto hold = [&]
    {
      if (reached.Values && reached.Step >= job.Begin && reached.Step <= job.End)
      {
        steps[reached.Step - job.Begin] = reached.Values;
      }
    };
    hold();
    const auto end = std::min(job.End, array.Last);
    for (auto step = reached.Values ? reached.Step + 1 : array.KeyStep; step <= end; ++step)
    {
      const auto domains = step < job.Begin ? this->Parts.GetDomains(array.Index, step)
                                            : array.Domains[step - job.Begin];
      reached = {
        this->Parts.DecodeBlockArray(index, array.Index, step, *domains, reached.Values, fits), step
      };
      hold();
    }
    if (job.IsLast)
    {
      this->Parts.KeepBlockArray(index, array.Index, reached);
    }
  }
  if (job.IsLast)
  {
    this->StoreBlock(job, b);
  }
}

//------------------------------------------------------------------------------
void ChunkSetDecoder::DecodeChunkInto(Job& job, std::size_t i) const
{
  const auto chunk = this->Set.GetChunks()[i];
  auto& work = job.Chunks[i];
  auto mesh = std::move(work.Mesh);
  if (!mesh && !job.IsFirst)
  {
    mesh = this->Parts.FindMesh(chunk); // decoded for the previous steps
  }
  if (!mesh)
  {
    mesh = this->Parts.DecodeMesh(chunk,
      [&](std::uint32_t block)
      {
        const auto& held = job.Blocks[this->Set.FindBlock(block)].Points;
        return held ? held : this->Parts.GetBlockPoints(block);
      });
  }
  PartFits fits;
  for (std::size_t a = 0; a < job.Arrays.size(); ++a)
  {
    auto& reached = work.Reached[a];
    const auto& array = job.Arrays[a];
    const auto end = std::min(job.End, array.Last);
    for (auto step = reached.Values ? reached.Step + 1 : array.KeyStep; step <= end; ++step)
    {
      const auto valuesOf = [&](std::uint32_t block)
      { return job.Blocks[this->Set.FindBlock(block)].Steps[a][step - job.Begin]; };
      reached = { this->Parts.DecodeChunkArray(chunk, *mesh, array.Index, step,
                    *array.Domains[step - job.Begin], reached.Values, valuesOf, fits),
        step };
    }
    if (job.IsLast)
    {
      this->Parts.KeepChunkArray(chunk, job.Arrays[a].Index, reached);
    }
  }
  if (job.IsLast)
  {
    this->StoreChunk(job, i, *mesh);
    work = {};
  }
}
}
