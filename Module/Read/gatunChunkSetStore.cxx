// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// How ChunkSetDecoder stores decoded parts in the target.

#include "gatunCellStore.h"
#include "gatunChunkSetDecoder.h"
#include "gatunChunkSetDecoderInternals.h"
#include "gatunChunkTets.h"
#include "gatunParallel.h"

#include <utility>

namespace gatun
{
//------------------------------------------------------------------------------
void ChunkSetDecoder::StoreBlock(const Job& job, std::size_t b) const
{
  const auto& content = this->Content();
  const auto& block = this->Set.GetBlocks()[b];
  const auto held = content.GetTables().GetBlock(block.Index);
  const auto& entry = *held;
  const auto& work = job.Blocks[b];
  const auto& target = job.Target;
  const auto store = [&](std::size_t first, std::size_t count, std::uint64_t start, bool owned)
  {
    const auto place = [order = job.RestorePoints ? work.Order.get() : nullptr, first, start](
                         std::size_t i) { return order ? (*order)[first + i] : start + i; };
    if (job.HasMeshPoints)
    {
      job.StorePoints(
        content.Domains, count,
        [keys = work.Points->data() + first](std::size_t i) -> const PointKeys& { return keys[i]; },
        place);
    }
    for (std::size_t i = 0; job.NeedsPointPlaces() && i < count; ++i)
    {
      job.TakePoint(place(i));
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
          job.Arrays[a], *work.Reached[a].Values, count,
          [first](std::size_t i) { return first + i; }, place);
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
/** Stores the own points of a chunk. */
void ChunkSetDecoder::StorePoints(const Job& job, std::size_t i, const ChunkMesh& mesh,
  const OrderPart* points, const Places& places) const
{
  const auto& content = this->Content();
  const auto& info = content.GetTables().GetChunks()[this->Set.GetChunks()[i]];
  const auto& target = job.Target;
  const auto& ownIds = mesh.OwnIds;
  const Places pointIds{ points, info.FirstPoint };
  for (std::size_t own = 0; job.NeedsPointPlaces() && own < ownIds.size(); ++own)
  {
    const auto place = places(own);
    job.TakePoint(place);
    if (target.GlobalPointIds)
    {
      target.GlobalPointIds[place] = static_cast<std::int64_t>(pointIds(own));
    }
    if (target.PointGhosts)
    {
      target.PointGhosts[place] = 0;
    }
  }
  if (job.HasMeshPoints)
  {
    job.StorePoints(
      content.Domains, ownIds.size(),
      [keys = mesh.Keys.data(), ids = ownIds.data()](std::size_t own) -> const PointKeys&
      { return keys[ids[own]]; },
      places);
  }
}

//------------------------------------------------------------------------------
/** Stores where the cells of a chunk come from. cellOf: gives the cell of the chunk for each cell
 * of the target. */
void ChunkSetDecoder::StoreCellPlaces(const Job& job, std::size_t i, const ChunkMesh& mesh,
  const OrderPart* order, const Places& places, auto&& cellOf) const
{
  const auto& info = this->Content().GetTables().GetChunks()[this->Set.GetChunks()[i]];
  const auto& target = job.Target;
  const Places cellIds{ order, info.FirstCell };
  const auto count = static_cast<std::size_t>(this->Set.GetNumberOfCells(i));
  const bool knowsParents = info.IsTetrahedral && !places.Order && !job.RestoreCorners;
  const auto first = static_cast<std::uint32_t>(this->Set.GetFirstCell(i));
  for (std::size_t c = 0; c < count; ++c)
  {
    const auto place = places(c);
    job.TakeCell(place);
    if (target.GlobalCellIds)
    {
      target.GlobalCellIds[place] = static_cast<std::int64_t>(cellIds(cellOf(c)));
    }
    if (target.FileCells)
    {
      target.FileCells[place] = info.FirstCell + cellOf(c);
    }
    if (target.CellGhosts)
    {
      target.CellGhosts[place] = 0;
    }
    if (target.CellParents)
    {
      const auto parent = knowsParents ? mesh.Walk.Parents[c] : Topology::NoTet;
      target.CellParents[place] =
        parent != Topology::NoTet ? first + parent : PieceTarget::NoParent;
    }
  }
}

//------------------------------------------------------------------------------
void ChunkSetDecoder::StoreChunk(Job& job, std::size_t i, const ChunkMesh& mesh) const
{
  const auto chunk = this->Set.GetChunks()[i];
  const auto& info = this->Content().GetTables().GetChunks()[chunk];
  const auto& target = job.Target;
  const auto& ownIds = mesh.OwnIds;

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
  const Places pointPlaces{ job.RestorePoints ? points.get() : nullptr,
    this->Set.GetFirstOwnPoint(i) };
  const Places cellPlaces{ job.RestoreCells ? cells.get() : nullptr, this->Set.GetFirstCell(i) };
  this->StorePoints(job, i, mesh, points.get(), pointPlaces);

  // Several tetrahedra may have the values of one cell.
  ChunkSize split;
  const bool isSplit = this->Set.GetForm() == PieceForm::Tetrahedra && !info.IsTetrahedral;
  if (isSplit)
  {
    split = this->Parts.SplitCells(chunk, mesh);
  }
  const auto cellOf = [&](std::size_t c) { return isSplit ? split.Cells[c] : c; };
  const auto count = static_cast<std::size_t>(this->Set.GetNumberOfCells(i));
  if (job.NeedsCellPlaces())
  {
    this->StoreCellPlaces(job, i, mesh, cells.get(), cellPlaces, cellOf);
  }
  if (this->Set.GetForm() == PieceForm::Original)
  {
    if (target.Types)
    {
      this->StoreOriginal(job, i, mesh, pointPlaces, job.RestoreCells ? cells : nullptr);
    }
  }
  else if (target.Connectivity)
  {
    const auto store = [&](const auto& tets)
    { this->StoreTets(job, i, mesh, tets, pointPlaces, cellPlaces); };
    isSplit ? store(split.Tets) : mesh.Walk.UseTets(store);
  }
  for (std::size_t a = 0; a < job.Arrays.size(); ++a)
  {
    const auto& values = *job.Chunks[i].Reached[a].Values;
    if (job.Arrays[a].OfPoints)
    {
      job.StoreTuples(
        job.Arrays[a], values, ownIds.size(),
        [ids = ownIds.data()](std::size_t own) { return ids[own]; }, pointPlaces);
    }
    else if (isSplit)
    {
      job.StoreTuples(job.Arrays[a], values, count, cellOf, cellPlaces);
    }
    else
    {
      job.StoreTuples(
        job.Arrays[a], values, count, [](std::size_t c) { return c; }, cellPlaces);
    }
  }
}

//------------------------------------------------------------------------------
/** The positions of all points of a chunk. */
std::vector<std::uint64_t> ChunkSetDecoder::FindIds(
  const Job& job, std::size_t i, const ChunkMesh& mesh, const Places& points) const
{
  const auto& content = this->Content();
  const auto chunk = this->Set.GetChunks()[i];
  std::vector<std::uint64_t> ids(mesh.Keys.size());
  for (std::size_t own = 0; own < mesh.OwnIds.size(); ++own)
  {
    ids[mesh.OwnIds[own]] = points(own);
  }
  std::vector<std::uint64_t> sharedPlaces;
  const auto entry = content.GetTables().GetChunk(chunk);
  for (const auto& part : entry->Shared)
  {
    const auto b = this->Set.FindBlock(part.Block);
    const auto start = this->Set.GetBlocks()[b].GroupStart[part.Group];
    for (std::uint64_t p = 0; p < part.Points; ++p)
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
  return ids;
}

//------------------------------------------------------------------------------
void ChunkSetDecoder::StoreTets(const Job& job, std::size_t i, const ChunkMesh& mesh,
  const auto& tets, const Places& points, const Places& cells) const
{
  const auto chunk = this->Set.GetChunks()[i];
  const auto ids = this->FindIds(job, i, mesh, points);
  const auto rotations =
    job.RestoreCorners && this->Content().GetTables().GetChunks()[chunk].IsTetrahedral
    ? this->Parts.DecodeCorners(chunk, mesh)
    : std::vector<Key>{};
  const auto store = [&](auto* connectivity)
  {
    using Id = std::remove_pointer_t<decltype(connectivity)>;
    for (std::size_t t = 0; t < tets.size(); ++t)
    {
      const auto tet = rotations.empty()
        ? UnpackTet(tets[t])
        : RotateCorners(UnpackTet(tets[t]), static_cast<unsigned>(rotations[t]));
      auto* corners = connectivity + 4 * cells(t);
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

//------------------------------------------------------------------------------
/** Stores the original cells of a chunk, or their sizes if the original order is restored. */
void ChunkSetDecoder::StoreOriginal(Job& job, std::size_t i, const ChunkMesh& mesh,
  const Places& points, std::shared_ptr<const OrderPart> order) const
{
  const CellStore store(job.Target);
  const auto chunk = this->Set.GetChunks()[i];
  auto ids = this->FindIds(job, i, mesh, points);
  const auto storeHere = [&](const CellList& cells)
  {
    store.Store(cells, ids, this->Set.GetFirstCell(i), this->Set.GetFirstCorner(i),
      this->Set.GetFirstFaceValue(i));
  };
  if (!order && !job.RestoreCorners &&
    !this->Content().GetTables().GetChunks()[chunk].IsTetrahedral)
  {
    storeHere(mesh.Cells); // without a copy
    return;
  }
  PlacedCells cells;
  cells.Cells = this->Parts.GetCells(chunk, mesh, job.RestoreCorners);
  if (!order)
  {
    storeHere(cells.Cells);
    return;
  }
  cells.Ids = std::move(ids);
  cells.Places = std::move(order);
  store.Add(cells);
  job.Placed[i] = std::move(cells);
}

//------------------------------------------------------------------------------
void ChunkSetDecoder::FinishOriginal(const Job& job) const
{
  const CellStore store(job.Target);
  if (job.Placed.empty())
  {
    store.Finish(this->Set.GetNumberOfCells(), this->Set.GetConnectivitySize());
    return;
  }
  store.AddUp(this->Set.GetNumberOfCells());
  ParallelFor(job.Placed.size(), [&](std::size_t i) { store.StoreAdded(job.Placed[i]); });
}
}
