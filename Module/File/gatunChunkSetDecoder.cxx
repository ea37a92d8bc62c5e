// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunChunkSetDecoder.h"

#include "gatunDomainWriter.h"
#include "gatunFloatEnvironment.h"
#include "gatunParallel.h"
#include "gatunPieceRequest.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <numeric>
#include <string>

namespace gatun
{
namespace
{
/** The number of steps to decode at once, chunk by chunk. More steps need more memory for shared
 * points. With fewer steps, meshes that do not fit into the cache are decoded more often. */
constexpr std::size_t StepsAtOnce = 16;

/** The position of the i-th item: its original id if there is an order, otherwise consecutive. */
struct Places
{
  const OrderPart* Order;
  std::uint64_t First;

  std::uint64_t operator()(std::size_t i) const
  {
    return this->Order ? (*this->Order)[i] : this->First + i;
  }
};
}

//------------------------------------------------------------------------------
struct ChunkSetDecoder::Job
{
  /** An array of the request. */
  struct Wanted
  {
    std::uint32_t Index;
    std::uint8_t* Values;
    bool OfPoints;
    std::size_t First; // the earliest step that any chunk needs to decode, or the job's step
    std::vector<std::shared_ptr<const DomainsPart>> Domains; // from Begin on
  };

  /** The decoded parts of a block. */
  struct BlockWork
  {
    std::shared_ptr<const PointsPart> Points;
    std::shared_ptr<const OrderPart> Order;
    std::vector<ArrayAtStep> Reached;                                 // for each array
    std::vector<std::vector<std::shared_ptr<const ArrayPart>>> Steps; // for each, from Begin on
    bool NeedsPoints = false;
  };

  /** The decoded parts of a chunk, until it is finished. */
  struct ChunkWork
  {
    std::shared_ptr<const ChunkMesh> Mesh;
    std::vector<ArrayAtStep> Reached; // for each array
  };

  const InputFile& File;
  const PieceTarget& Target;
  const bool RestorePoints;
  const bool RestoreCells;
  const bool RestoreCorners;
  const bool NeedsPointOrder;
  const bool NeedsCellOrder;
  const std::size_t Step;
  const std::size_t KeyStep; // from which Step is decoded
  std::vector<Wanted> Arrays;
  std::vector<BlockWork> Blocks;
  std::vector<ChunkWork> Chunks;
  std::size_t Begin = 0; // the steps to decode now
  std::size_t End = 0;

  bool IsLast() const { return this->End == this->Step; }

  // The positions filled so far if an order is restored. A damaged file could contain one twice and
  // leave another one uninitialized.
  mutable std::vector<std::atomic<bool>> PointTaken;
  mutable std::vector<std::atomic<bool>> CellTaken;

  void TakePoint(std::uint64_t place) const { this->Take(this->PointTaken, place, "point "); }
  void TakeCell(std::uint64_t place) const { this->Take(this->CellTaken, place, "cell "); }

  void Take(std::vector<std::atomic<bool>>& taken, std::uint64_t place, const char* what) const
  {
    if (!taken.empty() && taken[static_cast<std::size_t>(place)].exchange(true))
    {
      this->File.Fail(ErrorCode::Corrupt,
        "the original order is damaged: it names " + (what + std::to_string(place)) + " twice");
    }
  }

  void StoreTuples(const Wanted& array, const ArrayPart& values, std::size_t count, auto&& keyOf,
    auto&& placeOf) const
  {
    const auto& domains = *array.Domains.back();
    const auto size = SizeOf(domains.front().GetType());
    const auto stride = size * values.size();
    for (std::size_t c = 0; c < values.size(); ++c)
    {
      WithWriter(domains[c],
        [&](auto&& write)
        {
          const auto& keys = values[c];
          auto* component = array.Values + c * size;
          for (std::size_t i = 0; i < count; ++i)
          {
            write(keys[keyOf(i)], component + placeOf(i) * stride);
          }
        });
    }
  }

  void StorePoint(const PointDomain& domains, const PointKeys& keys, std::uint64_t place) const
  {
    const auto size = SizeOf(domains[0].GetType());
    auto* to = static_cast<std::uint8_t*>(this->Target.Points) + 3 * size * place;
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      domains[axis].Write(keys[axis], to + axis * size);
    }
  }
};

//------------------------------------------------------------------------------
ChunkSetDecoder::ChunkSetDecoder(const std::shared_ptr<ChunkCache>& cache,
  std::vector<std::uint32_t> chunks, std::vector<std::uint32_t> universe, bool withUnusedPoints)
  : Parts(cache)
  , Set(this->Parts.Content(), std::move(chunks), std::move(universe), withUnusedPoints)
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
  const bool restoreCells = (restore & KeepCells) != 0;
  Job job{ content.File, target, restorePoints, restoreCells, (restore & KeepCorners) != 0,
    (keep & KeepPoints) != 0 && (restorePoints || target.GlobalPointIds),
    (keep & KeepCells) != 0 && (restoreCells || target.GlobalCellIds), step,
    content.FindKeyStep(step), {}, {}, {}, 0, 0, {}, {} };
  if (restorePoints)
  {
    job.PointTaken =
      std::vector<std::atomic<bool>>(static_cast<std::size_t>(this->Set.GetNumberOfPoints()));
  }
  if (restoreCells)
  {
    job.CellTaken =
      std::vector<std::atomic<bool>>(static_cast<std::size_t>(this->Set.GetNumberOfTets()));
  }
  for (std::size_t a = 0; a < target.Arrays.size(); ++a)
  {
    if (target.Arrays[a])
    {
      job.Arrays.push_back({ arrays[a], static_cast<std::uint8_t*>(target.Arrays[a]),
        content.Meta.Arrays[arrays[a]].Where == Association::Point, step, {} });
    }
  }
  this->Plan(job);

  // Cached chunks come first, before they are evicted.
  std::vector<std::size_t> order(this->Set.GetChunks().size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::stable_partition(
    order.begin(), order.end(), [&](std::size_t i) { return job.Chunks[i].Mesh != nullptr; });

  const auto first = job.Begin;
  const auto steps = static_cast<double>(step - first + 1);
  for (; job.Begin <= step; job.Begin = job.End + 1)
  {
    job.End = std::min(step, job.Begin + StepsAtOnce - 1);
    for (auto& array : job.Arrays)
    {
      array.Domains.clear();
      for (auto at = job.Begin; at <= job.End; ++at)
      {
        array.Domains.push_back(this->Parts.GetDomains(array.Index, at));
      }
    }
    ParallelFor(this->Set.GetBlocks().size(),
      [&](std::size_t b)
      {
        const FloatEnvironment guard;
        this->DecodeBlock(job, b);
      });
    const auto done = static_cast<double>(job.Begin - first) / steps;
    const auto share = static_cast<double>(job.End - job.Begin + 1) / steps;
    ParallelFor(
      this->Set.GetChunks().size(),
      [&](std::size_t i)
      {
        const FloatEnvironment guard;
        this->DecodeChunkInto(job, order[i]);
      },
      [&](double part) { return !progress || progress(done + share * part); });
  }
}

/** Takes parts from the cache, so that they stay, and determines the parts to decode. */
void ChunkSetDecoder::Plan(Job& job) const
{
  job.Blocks.resize(this->Set.GetBlocks().size());
  job.Chunks.resize(this->Set.GetChunks().size());
  for (auto& block : job.Blocks)
  {
    block.NeedsPoints = job.Target.Points != nullptr;
  }
  for (std::size_t i = 0; i < this->Set.GetChunks().size(); ++i)
  {
    auto& work = job.Chunks[i];
    work.Mesh = this->Parts.FindMesh(this->Set.GetChunks()[i]);
    for (const auto& part : this->Content().Mesh.Chunks[this->Set.GetChunks()[i]].Shared)
    {
      auto& needed = job.Blocks[this->Set.FindBlock(part.Block)].NeedsPoints;
      needed = needed || !work.Mesh;
    }
    for (auto& array : job.Arrays)
    {
      work.Reached.push_back(
        this->Parts.FindChunkArray(this->Set.GetChunks()[i], array.Index, job.KeyStep, job.Step));
      const auto& reached = work.Reached.back();
      array.First = std::min(array.First, reached.Values ? reached.Step + 1 : job.KeyStep);
    }
  }
  job.Begin = job.Step;
  for (const auto& array : job.Arrays)
  {
    job.Begin = std::min(job.Begin, array.First);
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
      work.Reached[a] = this->Parts.FindBlockArray(index, array.Index, job.KeyStep, array.First);
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
    for (auto step = reached.Values ? reached.Step + 1 : job.KeyStep; step <= job.End; ++step)
    {
      const auto domains = step < job.Begin ? this->Parts.GetDomains(array.Index, step)
                                            : array.Domains[step - job.Begin];
      reached = {
        this->Parts.DecodeBlockArray(index, array.Index, step, *domains, reached.Values.get()), step
      };
      hold();
    }
    if (job.IsLast())
    {
      this->Parts.KeepBlockArray(index, array.Index, reached);
    }
  }
  if (job.IsLast())
  {
    this->StoreBlock(job, b);
  }
}

void ChunkSetDecoder::StoreBlock(const Job& job, std::size_t b) const
{
  const auto& content = this->Content();
  const auto& block = this->Set.GetBlocks()[b];
  const auto& entry = this->Parts.GetBlock(block.Index);
  const auto& work = job.Blocks[b];
  const auto& target = job.Target;
  const auto store = [&](std::size_t first, std::size_t count, std::uint64_t start, bool owned)
  {
    const auto place = [&](std::size_t i)
    { return job.RestorePoints ? (*work.Order)[first + i] : start + i; };
    for (std::size_t i = 0; i < count; ++i)
    {
      job.TakePoint(place(i));
      if (target.Points)
      {
        job.StorePoint(content.Domains, (*work.Points)[first + i], place(i));
      }
      if (target.GlobalPointIds)
      {
        target.GlobalPointIds[place(i)] = static_cast<std::int64_t>(
          work.Order ? (*work.Order)[first + i] : entry.FirstPoint + first + i);
      }
      if (target.PointGhosts)
      {
        target.PointGhosts[place(i)] = !owned;
      }
    }
    for (std::size_t a = 0; a < job.Arrays.size(); ++a)
    {
      if (job.Arrays[a].OfPoints)
      {
        job.StoreTuples(
          job.Arrays[a], *work.Steps[a].back(), count, [&](std::size_t i) { return first + i; },
          place);
      }
    }
  };
  if (entry.Groups.empty())
  {
    store(0, static_cast<std::size_t>(entry.Points), this->Set.GetFirstUnusedPoint(), true);
    return;
  }
  std::size_t first = 0;
  for (std::size_t g = 0; g < entry.Groups.size(); ++g)
  {
    const auto& group = entry.Groups[g];
    if (block.GroupStart[g] != ChunkSet::Absent)
    {
      store(first, group.Points, block.GroupStart[g], this->Set.Owns(group));
    }
    first += group.Points;
  }
}

//------------------------------------------------------------------------------
void ChunkSetDecoder::DecodeChunkInto(Job& job, std::size_t i) const
{
  const auto chunk = this->Set.GetChunks()[i];
  auto& work = job.Chunks[i];
  auto mesh = std::move(work.Mesh);
  if (!mesh && job.Begin > job.KeyStep)
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
  for (std::size_t a = 0; a < job.Arrays.size(); ++a)
  {
    auto& reached = work.Reached[a];
    for (auto step = reached.Values ? reached.Step + 1 : job.KeyStep; step <= job.End; ++step)
    {
      const auto& array = job.Arrays[a];
      const auto valuesOf = [&](std::uint32_t block)
      { return job.Blocks[this->Set.FindBlock(block)].Steps[a][step - job.Begin]; };
      reached = { this->Parts.DecodeChunkArray(chunk, *mesh, array.Index, step,
                    *array.Domains[step - job.Begin], reached.Values.get(), valuesOf),
        step };
    }
    if (job.IsLast())
    {
      this->Parts.KeepChunkArray(chunk, job.Arrays[a].Index, reached);
    }
  }
  if (job.IsLast())
  {
    this->StoreChunk(job, i, *mesh);
    work = {};
  }
}

void ChunkSetDecoder::StoreChunk(const Job& job, std::size_t i, const ChunkMesh& mesh) const
{
  const auto& content = this->Content();
  const auto chunk = this->Set.GetChunks()[i];
  const auto& info = content.Mesh.Chunks[chunk].Info;
  const auto& target = job.Target;
  const auto& ownIds = mesh.Context.OwnIds;
  const auto tets = mesh.Walk.Parents.size();

  std::shared_ptr<const OrderPart> points, cells;
  if (job.NeedsPointOrder)
  {
    points = this->Parts.GetPointOrder(chunk, mesh,
      [&](std::uint32_t block) { return job.Blocks[this->Set.FindBlock(block)].Order; });
  }
  if (job.NeedsCellOrder)
  {
    cells = this->Parts.GetCellOrder(chunk, mesh);
  }
  const Places pointIds{ points.get(), info.FirstPoint };
  const Places cellIds{ cells.get(), info.FirstTet };
  const Places pointPlaces{ job.RestorePoints ? points.get() : nullptr,
    this->Set.GetFirstOwnPoint(i) };
  const Places cellPlaces{ job.RestoreCells ? cells.get() : nullptr, this->Set.GetFirstTet(i) };

  for (std::size_t own = 0; own < ownIds.size(); ++own)
  {
    const auto place = pointPlaces(own);
    job.TakePoint(place);
    if (target.Points)
    {
      job.StorePoint(content.Domains, mesh.Keys[ownIds[own]], place);
    }
    if (target.GlobalPointIds)
    {
      target.GlobalPointIds[place] = static_cast<std::int64_t>(pointIds(own));
    }
    if (target.PointGhosts)
    {
      target.PointGhosts[place] = 0;
    }
  }
  for (std::size_t t = 0; t < tets; ++t)
  {
    const auto place = cellPlaces(t);
    job.TakeCell(place);
    if (target.GlobalCellIds)
    {
      target.GlobalCellIds[place] = static_cast<std::int64_t>(cellIds(t));
    }
    if (target.CellGhosts)
    {
      target.CellGhosts[place] = 0;
    }
  }
  if (target.Connectivity)
  {
    this->StoreConnectivity(job, i, mesh, pointPlaces.Order, cellPlaces.Order);
  }
  if (target.CellParents)
  {
    const auto first = static_cast<std::uint32_t>(this->Set.GetFirstTet(i));
    const bool isInOrder = !cellPlaces.Order && !job.RestoreCorners;
    for (std::size_t t = 0; t < tets; ++t)
    {
      const auto parent = mesh.Walk.Parents[t];
      target.CellParents[cellPlaces(t)] =
        isInOrder && parent != Topology::NoTet ? first + parent : PieceTarget::NoParent;
    }
  }
  for (std::size_t a = 0; a < job.Arrays.size(); ++a)
  {
    const auto& values = *job.Chunks[i].Reached[a].Values;
    if (job.Arrays[a].OfPoints)
    {
      job.StoreTuples(
        job.Arrays[a], values, ownIds.size(), [&](std::size_t own) { return ownIds[own]; },
        pointPlaces);
    }
    else
    {
      job.StoreTuples(
        job.Arrays[a], values, tets, [](std::size_t t) { return t; }, cellPlaces);
    }
  }
}

void ChunkSetDecoder::StoreConnectivity(const Job& job, std::size_t i, const ChunkMesh& mesh,
  const OrderPart* points, const OrderPart* cells) const
{
  const auto& content = this->Content();
  const auto chunk = this->Set.GetChunks()[i];
  const Places pointPlaces{ points, this->Set.GetFirstOwnPoint(i) };
  const Places cellPlaces{ cells, this->Set.GetFirstTet(i) };
  std::vector<std::uint64_t> ids(mesh.Keys.size());
  for (std::size_t own = 0; own < mesh.Context.OwnIds.size(); ++own)
  {
    ids[mesh.Context.OwnIds[own]] = pointPlaces(own);
  }
  std::vector<std::uint64_t> sharedPlaces;
  for (const auto& part : content.Mesh.Chunks[chunk].Shared)
  {
    const auto count = content.Mesh.Blocks[part.Block].Groups[part.Group].Points;
    const auto b = this->Set.FindBlock(part.Block);
    const auto start = this->Set.GetBlocks()[b].GroupStart[part.Group];
    for (std::uint64_t p = 0; p < count; ++p)
    {
      sharedPlaces.push_back(
        job.RestorePoints ? (*job.Blocks[b].Order)[part.FirstInBlock + p] : start + p);
    }
  }
  for (std::size_t v = 0; v < ids.size(); ++v)
  {
    const auto source = mesh.Walk.Sources[v];
    if (source & Topology::SharedFlag)
    {
      ids[v] = sharedPlaces[source & ~Topology::SharedFlag];
    }
  }
  const auto rotations =
    job.RestoreCorners ? this->Parts.DecodeCorners(chunk, mesh) : std::vector<Key>{};
  const auto store = [&](auto* connectivity)
  {
    using Id = std::remove_pointer_t<decltype(connectivity)>;
    for (std::size_t t = 0; t < mesh.Walk.Tets.size(); ++t)
    {
      const auto tet = rotations.empty()
        ? mesh.Walk.Tets[t]
        : RotateCorners(mesh.Walk.Tets[t], static_cast<unsigned>(rotations[t]));
      auto* corners = connectivity + 4 * cellPlaces(t);
      for (unsigned corner = 0; corner < 4; ++corner)
      {
        corners[corner] = static_cast<Id>(ids[tet[corner]]);
      }
    }
  };
  if (job.Target.WideIds)
  {
    store(static_cast<std::int64_t*>(job.Target.Connectivity));
  }
  else
  {
    store(static_cast<std::int32_t*>(job.Target.Connectivity));
  }
}
}
