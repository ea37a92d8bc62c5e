// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunCoarsePiece.h"

#include "gatunChunkCache.h"
#include "gatunChunkSetDecoder.h"
#include "gatunMeshTable.h"
#include "gatunParallel.h"
#include "gatunPieceCells.h"
#include "gatunPieceRequest.h"

#include <algorithm>
#include <cstring>
#include <numeric>

namespace gatun
{
namespace
{
constexpr std::uint32_t None = 0xffffffffu;

/** Copies tuples. Pairs contain source and destination. */
template <typename Pairs>
void CopyTuples(const void* from, void* to, std::size_t bytes, const Pairs& pairs)
{
  const auto* const source = static_cast<const std::uint8_t*>(from);
  auto* const target = static_cast<std::uint8_t*>(to);
  for (const auto& pair : pairs)
  {
    std::memcpy(target + pair.To * bytes, source + pair.From * bytes, bytes);
  }
}

/** Ranks of items by their numbers. */
std::vector<std::uint32_t> FindRanks(const std::vector<std::int64_t>& numbers)
{
  std::vector<std::uint32_t> order(numbers.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
    [&](std::uint32_t a, std::uint32_t b) { return numbers[a] < numbers[b]; });
  std::vector<std::uint32_t> ranks(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i)
  {
    ranks[order[i]] = i;
  }
  return ranks;
}
}

//------------------------------------------------------------------------------
CoarseChunk DecodeCoarse(const std::shared_ptr<ChunkCache>& cache, const CoarseLayout& layout,
  std::uint32_t chunk, PieceForm form)
{
  const ChunkSetDecoder decoder(cache, { chunk }, {}, false, form);
  const ChunkSet& set = decoder.GetSet();
  PieceCells cells(set.GetForm() == PieceForm::Tetrahedra,
    static_cast<std::size_t>(decoder.GetNumberOfCells()),
    static_cast<std::size_t>(set.GetConnectivitySize()),
    static_cast<std::size_t>(set.GetFacesSize()));
  decoder.Fill(cells.GetTarget(), {}, 0, false, {});
  // Positions in the chunk become points of the file, and these their ancestors.
  auto ancestors = layout.GetPoints(chunk);
  for (auto& point : ancestors)
  {
    point = layout.GetAncestors()[point];
  }
  CoarseChunk left{ {}, CoarseCells(form) };
  std::vector<std::uint32_t> corners;
  for (std::uint32_t cell = 0; cell < cells.GetNumber(); ++cell)
  {
    corners.clear();
    cells.ForEachPoint(
      cell, [&](std::size_t point) { corners.push_back(static_cast<std::uint32_t>(point)); });
    if (left.Cells.AddSimplified(cells.GetType(cell), corners, ancestors))
    {
      left.Ids.push_back(cell);
    }
  }
  return left;
}

//------------------------------------------------------------------------------
CoarsePiece::CoarsePiece(std::shared_ptr<ChunkCache> cache,
  std::shared_ptr<const CoarseLayout> layout, const PieceRequest& request, const Progress& progress)
  : Cache(std::move(cache))
  , File(Cache->GetFile())
  , Layout(std::move(layout))
  , Request(request)
  , Form(File->IsSurface() ? request.Form : PieceForm::Tetrahedra)
  , Cells(Form)
{
  this->AddCells(progress);
  this->AddPoints();
  const bool isWhole = request.Chunks.size() == this->File->GetChunks().size() &&
    (request.WithUnusedPoints || this->File->GetNumberOfUnusedPoints() == 0);
  if (request.RestoreOrder && isWhole)
  {
    this->RestoreOrder();
  }
}

//------------------------------------------------------------------------------
CoarsePiece::Part& CoarsePiece::GetPart(std::uint32_t chunk)
{
  const auto found = std::find_if(
    this->Parts.begin(), this->Parts.end(), [=](const Part& part) { return part.Chunk == chunk; });
  return found != this->Parts.end() ? *found : this->Parts.emplace_back(Part{ chunk, {}, {} });
}

//------------------------------------------------------------------------------
void CoarsePiece::AddCells(const Progress& progress)
{
  auto chunks = this->Request.Chunks;
  if (this->Request.GhostLevels > 0)
  {
    chunks = this->Request.Universe;
    if (chunks.empty())
    {
      chunks.resize(this->File->GetChunks().size());
      std::iota(chunks.begin(), chunks.end(), 0u);
    }
  }
  std::vector<CoarseChunk> left(chunks.size());
  ParallelFor(
    chunks.size(),
    [&](std::size_t i)
    { left[i] = DecodeCoarse(this->Cache, *this->Layout, chunks[i], this->Form); },
    progress);
  for (std::size_t i = 0; i < chunks.size(); ++i)
  {
    if (std::binary_search(this->Request.Chunks.begin(), this->Request.Chunks.end(), chunks[i]))
    {
      auto& copies = this->Parts.emplace_back(Part{ chunks[i], {}, {} }).Cells;
      const CoarseCells& cells = left[i].Cells;
      for (std::size_t k = 0; k < cells.GetCount(); ++k)
      {
        copies.push_back({ left[i].Ids[k], static_cast<std::uint32_t>(this->Cells.GetCount()) });
        this->Cells.Add(cells.GetType(k), cells.GetCorners(k));
      }
      left[i] = {};
    }
  }
  this->OwnCells = this->Cells.GetCount();
  this->AddGhosts(left, chunks);
}

//------------------------------------------------------------------------------
/** Adds layers of cells that share a point with the previous ones. */
void CoarsePiece::AddGhosts(
  std::vector<CoarseChunk>& around, const std::vector<std::uint32_t>& chunks)
{
  std::vector<bool> reached(
    this->Request.GhostLevels > 0 ? this->Layout->GetAncestors().size() : 0, false);
  std::size_t known = 0;
  for (unsigned level = 0; level < this->Request.GhostLevels; ++level)
  {
    for (auto i = known; i < this->Cells.GetCount(); ++i)
    {
      for (const auto corner : this->Cells.GetCorners(i))
      {
        reached[corner] = true;
      }
    }
    if (known > 0 && known == this->Cells.GetCount())
    {
      return; // nothing more can be reached
    }
    known = this->Cells.GetCount();
    for (std::size_t i = 0; i < chunks.size(); ++i)
    {
      const CoarseCells& cells = around[i].Cells;
      for (std::size_t k = 0; k < cells.GetCount(); ++k)
      {
        const auto corners = cells.GetCorners(k);
        const bool touches = std::any_of(
          corners.begin(), corners.end(), [&](std::uint32_t corner) { return reached[corner]; });
        if (around[i].Ids[k] != None && touches)
        {
          this->GetPart(chunks[i]).Cells.push_back(
            { around[i].Ids[k], static_cast<std::uint32_t>(this->Cells.GetCount()) });
          this->Cells.Add(cells.GetType(k), corners);
          around[i].Ids[k] = None;
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
/** Whether a point belongs to the piece: see PieceTarget::PointGhosts. */
bool CoarsePiece::Owns(std::uint32_t point) const
{
  const auto has = [](const std::vector<std::uint32_t>& set, std::uint32_t chunk)
  { return std::binary_search(set.begin(), set.end(), chunk); };
  if (point >= this->File->GetNumberOfPoints() - this->File->GetNumberOfUnusedPoints())
  {
    return this->Request.WithUnusedPoints;
  }
  const SharedGroup* const group = this->Layout->FindGroup(point);
  if (!group)
  {
    return has(this->Request.Chunks, this->Layout->GetGiver(point));
  }
  const auto& universe = this->Request.Universe;
  const auto owner = std::find_if(group->Chunks.begin(), group->Chunks.end(),
    [&](std::uint32_t chunk) { return universe.empty() || has(universe, chunk); });
  return owner != group->Chunks.end() && has(this->Request.Chunks, *owner);
}

//------------------------------------------------------------------------------
void CoarsePiece::AddPoints()
{
  const auto& ancestors = this->Layout->GetAncestors();
  std::vector<std::uint32_t> places(ancestors.size(), None);
  // First marks, then positions in the order of the file: points of the piece, then those of
  // ghosts.
  constexpr std::uint32_t ofPiece = 0;
  constexpr std::uint32_t ofGhosts = 1;
  for (std::size_t i = this->Cells.GetCount(); i > 0; --i)
  {
    for (const auto corner : this->Cells.GetCorners(i - 1))
    {
      places[corner] = i > this->OwnCells ? ofGhosts : ofPiece;
    }
  }
  const auto markOwned = [&](std::uint32_t first, std::uint32_t last)
  {
    for (auto point = first; point < last; ++point)
    {
      if (ancestors[point] == point && this->Owns(point))
      {
        places[point] = ofPiece;
      }
    }
  };
  for (const auto chunk : this->Request.Chunks)
  {
    this->Layout->EachRun(chunk, markOwned);
  }
  const auto used = static_cast<std::uint32_t>(
    this->File->GetNumberOfPoints() - this->File->GetNumberOfUnusedPoints());
  markOwned(used, static_cast<std::uint32_t>(ancestors.size()));
  for (const auto kind : { ofPiece, ofGhosts })
  {
    for (std::uint32_t point = 0; point < places.size(); ++point)
    {
      if (places[point] == kind)
      {
        this->Points.push_back(point);
      }
    }
    this->OwnPoints = kind == ofPiece ? this->Points.size() : this->OwnPoints;
  }
  for (std::uint32_t i = 0; i < this->Points.size(); ++i)
  {
    places[this->Points[i]] = i;
  }
  for (auto& corner : this->Cells.GetAllCorners())
  {
    corner = places[corner];
  }

  // Chunks that are decoded anyway come first.
  const auto take = [&](std::uint32_t chunk)
  {
    auto& copies = this->GetPart(chunk).Points;
    std::uint32_t at = 0;
    this->Layout->EachRun(chunk,
      [&](std::uint32_t first, std::uint32_t last)
      {
        for (auto point = first; point < last; ++point, ++at)
        {
          if (places[point] != None)
          {
            copies.push_back({ at, places[point] });
            places[point] = None;
          }
        }
      });
  };
  for (const auto chunk : this->Request.Chunks)
  {
    take(chunk);
  }
  for (const auto point : this->Points)
  {
    if (places[point] == None)
    {
      continue;
    }
    if (point < used)
    {
      take(this->Layout->GetGiver(point));
    }
    else
    {
      this->GetPart(NoChunk).Points.push_back({ point - used, places[point] });
    }
  }
}

//------------------------------------------------------------------------------
void CoarsePiece::RestoreOrder()
{
  const auto kept = this->File->GetKeptOrder();
  PieceTarget target;
  std::vector<std::int64_t> pointIds(this->Points.size());
  std::vector<std::int64_t> cellIds(this->Cells.GetCount());
  target.GlobalPointIds = (kept & KeepPoints) != 0 ? pointIds.data() : nullptr;
  target.GlobalCellIds = (kept & KeepCells) != 0 ? cellIds.data() : nullptr;
  if (!target.GlobalPointIds && !target.GlobalCellIds)
  {
    return;
  }
  this->Fill(target, {}, 0, {});
  if (target.GlobalPointIds)
  {
    const auto ranks = FindRanks(pointIds);
    auto points = this->Points;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      points[ranks[i]] = this->Points[i];
    }
    this->Points = std::move(points);
    for (auto& part : this->Parts)
    {
      for (Copy& copy : part.Points)
      {
        copy.To = ranks[copy.To];
      }
    }
    for (auto& corner : this->Cells.GetAllCorners())
    {
      corner = ranks[corner];
    }
  }
  if (target.GlobalCellIds)
  {
    const auto ranks = FindRanks(cellIds);
    this->Cells = this->Cells.Permute(ranks);
    for (auto& part : this->Parts)
    {
      for (Copy& copy : part.Cells)
      {
        copy.To = ranks[copy.To];
      }
    }
  }
}

//------------------------------------------------------------------------------
void CoarsePiece::Fill(const PieceTarget& target, const std::vector<std::uint32_t>& arrays,
  std::size_t step, const Progress& progress) const
{
  this->Cells.Store(target);
  for (std::size_t i = 0; target.PointGhosts && i < this->Points.size(); ++i)
  {
    target.PointGhosts[i] = i >= this->OwnPoints || !this->Owns(this->Points[i]);
  }
  for (std::size_t i = 0; target.CellGhosts && i < this->Cells.GetCount(); ++i)
  {
    target.CellGhosts[i] = i >= this->OwnCells;
  }
  ParallelFor(
    this->Parts.size(),
    [&](std::size_t i) { this->FillPart(this->Parts[i], target, arrays, step); }, progress);
}

//------------------------------------------------------------------------------
void CoarsePiece::FillPart(const Part& part, const PieceTarget& target,
  const std::vector<std::uint32_t>& arrays, std::size_t step) const
{
  const bool isChunk = part.Chunk != NoChunk;
  const ChunkSetDecoder decoder(this->Cache,
    isChunk ? std::vector<std::uint32_t>{ part.Chunk } : std::vector<std::uint32_t>{}, {}, !isChunk,
    this->Form);
  const auto points = static_cast<std::size_t>(decoder.GetNumberOfPoints());
  const auto cells = static_cast<std::size_t>(decoder.GetNumberOfCells());
  struct Wanted
  {
    std::vector<std::uint8_t> Values;
    std::size_t TupleBytes;
    void* To;
    bool OfPoints;
  };
  std::vector<Wanted> wanted;
  wanted.reserve(arrays.size() + 3);
  const auto want = [&](void* to, std::size_t tupleBytes, bool ofPoints) -> std::uint8_t*
  {
    const auto& copies = ofPoints ? part.Points : part.Cells;
    if (!to || copies.empty())
    {
      return nullptr;
    }
    wanted.push_back({ std::vector<std::uint8_t>((ofPoints ? points : cells) * tupleBytes),
      tupleBytes, to, ofPoints });
    return wanted.back().Values.data();
  };
  PieceTarget chunk;
  chunk.Points = want(target.Points, 3 * SizeOf(this->File->GetCoordinateType()), true);
  chunk.GlobalPointIds =
    reinterpret_cast<std::int64_t*>(want(target.GlobalPointIds, sizeof(std::int64_t), true));
  chunk.GlobalCellIds =
    reinterpret_cast<std::int64_t*>(want(target.GlobalCellIds, sizeof(std::int64_t), false));
  for (std::size_t a = 0; a < target.Arrays.size(); ++a)
  {
    const ArrayDescription& array = this->File->GetArrays()[arrays[a]];
    chunk.Arrays.push_back(want(
      target.Arrays[a], array.Components * SizeOf(array.Type), array.Where == Association::Point));
  }
  if (wanted.empty())
  {
    return;
  }
  decoder.Fill(chunk, arrays, step, false, {});
  for (const Wanted& values : wanted)
  {
    CopyTuples(values.Values.data(), values.To, values.TupleBytes,
      values.OfPoints ? part.Points : part.Cells);
  }
}
}
