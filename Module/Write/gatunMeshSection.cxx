// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunMeshSection.h"

#include "gatunArrayContext.h"
#include "gatunCellCodec.h"
#include "gatunChunkTets.h"
#include "gatunFloatEnvironment.h"
#include "gatunPalette.h"
#include "gatunParallel.h"
#include "gatunPointOrder.h"

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>

namespace gatun
{
namespace
{
Bytes EncodeRotations(const std::vector<std::uint8_t>& rotations, const CellContext& context)
{
  const Domain domain(ScalarType::UInt8);
  ComponentKeys keys;
  keys.Now.assign(rotations.begin(), rotations.end());
  return EncodeCellValues(context, { &domain, 1 }, { &keys, 1 });
}
}

//------------------------------------------------------------------------------
void MeshSection::MakeLayout(WriterPart& part, const std::function<bool(double)>& progress)
{
  if (this->State.Options.Layers)
  {
    this->Layers.emplace();
    this->Layers->Request = *this->State.Options.Layers;
    this->Layers->Array = this->State.Meta.Arrays[this->Layers->Request.Array];
  }
  part.Layout = MakePartition(part.Mesh, this->State.GetChunkLimits(part.Mesh), progress,
    this->Layers ? &*this->Layers : nullptr);
}

//------------------------------------------------------------------------------
void MeshSection::AddChunks(const WriterPart& part)
{
  for (std::size_t c = 0; c < part.Layout.GetChunkCount(); ++c)
  {
    auto& entry = this->State.Table.Chunks.emplace_back();
    entry.Sizes = this->GetSizes(part, c);
    entry.Info.Cells = entry.Sizes.Cells;
    entry.Info.IsTetrahedral = entry.Sizes.IsTetrahedral;
    this->State.Cells.Chunks.push_back(entry.Sizes);
  }
  const auto& mesh = part.Mesh;
  if (mesh.IsTetrahedral())
  {
    this->State.TypeCounts[TetraType] += mesh.GetMesh().Cells;
    return;
  }
  for (std::uint64_t cell = 0; cell < mesh.GetMesh().Cells; ++cell)
  {
    ++this->State.TypeCounts[mesh.GetType(cell)];
  }
  if (this->State.Options.Coding == Profile::Fast)
  {
    return; // Hardly any chunk would have use for shapes.
  }
  std::vector<ShapeTable> shapes(part.Layout.GetChunkCount());
  ParallelFor(shapes.size(),
    [&](std::size_t chunk)
    {
      const auto& sizes = this->State.Table.Chunks[part.Place.FirstChunk + chunk].Sizes;
      if (!sizes.IsTetrahedral)
      {
        // Shapes do not depend on the numbers of points.
        shapes[chunk].Add(
          this->MakeCells(part, chunk, sizes, [](std::uint32_t point) { return point; }));
      }
    });
  for (const auto& table : shapes)
  {
    this->State.Shapes.Merge(table);
  }
}

//------------------------------------------------------------------------------
void MeshSection::AddGroups(const WriterPart& part)
{
  const auto first = static_cast<std::uint32_t>(part.Place.FirstChunk);
  for (const auto& [users, points] : part.Layout.SharedPoints)
  {
    ChunkGroup chunks = users;
    for (auto& chunk : chunks)
    {
      chunk += first;
    }
    this->State.Groups.Add(chunks, static_cast<std::int64_t>(points.size()));
  }
}

//------------------------------------------------------------------------------
void MeshSection::Write(WriterPart& part, const std::function<bool(double)>& progress,
  const std::function<void(std::size_t)>& encoded)
{
  StreamBatch batch;
  if (part.Place.IsFirst)
  {
    this->WritePalettes(batch);
  }
  this->TakeUnused(part);
  this->WriteBlocks(part, batch);
  batch.Write(this->State.File, SectionMesh);
  part.Chunks.resize(part.Layout.GetChunkCount());
  this->OwnNumbers.assign(static_cast<std::size_t>(part.Mesh.GetMesh().Points), NotOwn);
  this->WriteChunks(part, progress, encoded);
  this->OwnNumbers = {};
  this->FindBounds(part);
  part.Layout.Cells = {};
}

//------------------------------------------------------------------------------
void MeshSection::WritePalettes(StreamBatch& batch)
{
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    const auto& palette = this->Domains[axis].GetPalette();
    auto& where = this->State.Table.Palettes[axis];
    where.Steps = this->Domains[axis].GetScale();
    if (palette)
    {
      where.Count = palette->size();
      const auto stream = EncodePalette(this->State.Meta.CoordinateType, *palette);
      batch.Add(stream, where.Stream);
      this->State.Statistics.SharedGeometryBytes += stream.size();
    }
  }
}

//------------------------------------------------------------------------------
/** Keeps the unused points of a part for the block that the last part writes. */
void MeshSection::TakeUnused(const WriterPart& part)
{
  const auto& mesh = part.Mesh.GetMesh();
  const auto size = 3 * SizeOf(mesh.CoordinateType);
  const auto* coordinates = static_cast<const std::uint8_t*>(mesh.Coordinates);
  auto& unused = this->State.Unused;
  for (const auto point : part.Layout.UnusedPoints)
  {
    part.Mesh.Include(this->State.Meta.Box, point);
    const auto* from = coordinates + size * point;
    unused.Coordinates.insert(unused.Coordinates.end(), from, from + size);
    if (this->State.Options.Keep & KeepPoints)
    {
      unused.Numbers.push_back(part.GetPointNumber(point));
    }
  }
}

//------------------------------------------------------------------------------
void MeshSection::WriteBlocks(const WriterPart& part, StreamBatch& batch)
{
  auto& table = this->State.Table;
  std::vector<BlockStreams> streams(part.Place.Blocks + (part.Place.IsLast ? 1 : 0));
  ParallelFor(streams.size(),
    [&](std::size_t b)
    {
      const FloatEnvironment guard;
      streams[b] = b < part.Place.Blocks ? this->EncodeBlock(part, part.GetBlockPoints(table, b))
                                         : this->EncodeUnused();
    });
  for (std::size_t b = 0; b < streams.size(); ++b)
  {
    this->AddStreams(streams[b],
      b < part.Place.Blocks ? table.Blocks[part.Place.FirstBlock + b] : table.Unused, batch);
  }
}

//------------------------------------------------------------------------------
void MeshSection::AddStreams(const BlockStreams& streams, BlockEntry& block, StreamBatch& batch)
{
  for (const auto& [bytes, where, count] :
    { std::tuple(&streams.Geometry, &block.Geometry, &this->State.Statistics.SharedGeometryBytes),
      std::tuple(&streams.Order, &block.Order, &this->State.Statistics.OrderBytes) })
  {
    if (!bytes->empty())
    {
      batch.Add(*bytes, *where);
      *count += bytes->size();
    }
  }
}

//------------------------------------------------------------------------------
MeshSection::BlockStreams MeshSection::EncodeBlock(
  const WriterPart& part, std::span<const std::uint32_t> points) const
{
  ComponentKeys numbers;
  if (this->State.Options.Keep & KeepPoints)
  {
    for (const auto point : points)
    {
      numbers.Now.push_back(part.GetPointNumber(point));
    }
  }
  return this->EncodeBlock(this->GetPointKeys(part, points), std::move(numbers));
}

//------------------------------------------------------------------------------
MeshSection::BlockStreams MeshSection::EncodeUnused() const
{
  const auto& unused = this->State.Unused;
  const auto size = SizeOf(this->State.Meta.CoordinateType);
  std::vector<PointKeys> keys(unused.Coordinates.size() / (3 * size));
  for (std::size_t i = 0; i < keys.size(); ++i)
  {
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      keys[i][axis] = this->Domains[axis].Read(unused.Coordinates.data() + (3 * i + axis) * size);
    }
  }
  ComponentKeys numbers;
  numbers.Now = unused.Numbers;
  return this->EncodeBlock(keys, std::move(numbers));
}

//------------------------------------------------------------------------------
/** Encodes the points of a block. Called by several threads. */
MeshSection::BlockStreams MeshSection::EncodeBlock(
  const std::vector<PointKeys>& pointKeys, ComponentKeys numbers) const
{
  BlockStreams streams;
  if (pointKeys.empty())
  {
    return streams;
  }
  std::vector<ComponentKeys> keys(3);
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    keys[axis].Now.resize(pointKeys.size());
    for (std::size_t i = 0; i < pointKeys.size(); ++i)
    {
      keys[axis].Now[i] = pointKeys[i][axis];
    }
  }
  const CellContext block{ {}, nullptr, this->State.Options.Coding };
  streams.Geometry = EncodeCellValues(block, this->Domains, keys);
  streams.Geometry.resize(
    std::max<std::size_t>(streams.Geometry.size(), pointKeys.size() / MaxItemsPerByte + 1), 0);
  if (this->State.Options.Keep & KeepPoints)
  {
    const Domain ids(GetNumberType(this->State.Meta.Points));
    streams.Order = EncodeCellValues(block, { &ids, 1 }, { &numbers, 1 });
  }
  return streams;
}

//------------------------------------------------------------------------------
std::vector<PointKeys> MeshSection::GetPointKeys(
  const WriterPart& part, std::span<const std::uint32_t> points) const
{
  const auto& input = part.Mesh.GetMesh();
  const auto size = SizeOf(input.CoordinateType);
  const auto* values = static_cast<const std::uint8_t*>(input.Coordinates);
  std::vector<PointKeys> keys(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      keys[i][axis] =
        this->Domains[axis].Read(values + (std::size_t{ 3 } * points[i] + axis) * size);
    }
  }
  return keys;
}

//------------------------------------------------------------------------------
/** The cells of a chunk with the points that numberOf returns for those of the input. */
template <typename NumberOf>
CellList MeshSection::MakeCells(
  const WriterPart& part, std::size_t chunk, const CellSizes& sizes, NumberOf&& numberOf) const
{
  const auto& mesh = part.Mesh;
  CellList cells;
  cells.Corners.reserve(sizes.Corners);
  cells.Faces.reserve(sizes.FaceValues);
  if (sizes.Polyhedra > 0)
  {
    cells.FaceStarts.push_back(0);
  }
  for (const auto cell : part.GetCells(chunk))
  {
    cells.Types.push_back(mesh.GetType(cell));
    for (auto i = mesh.GetBegin(cell); i < mesh.GetEnd(cell); ++i)
    {
      cells.Corners.push_back(numberOf(static_cast<std::uint32_t>(mesh.GetId(i))));
    }
    cells.Starts.push_back(static_cast<std::uint32_t>(cells.Corners.size()));
    const auto faces = mesh.GetFaces(cell);
    for (std::size_t at = 0; at < faces.size();)
    {
      cells.Faces.push_back(static_cast<std::uint32_t>(faces[at]));
      for (auto points = faces[at++]; points > 0; --points)
      {
        cells.Faces.push_back(numberOf(static_cast<std::uint32_t>(faces[at++])));
      }
    }
    if (sizes.Polyhedra > 0)
    {
      cells.FaceStarts.push_back(static_cast<std::uint32_t>(cells.Faces.size()));
    }
  }
  return cells;
}

//------------------------------------------------------------------------------
/** The tetrahedra of a chunk with the numbers of its points. */
std::vector<std::array<std::uint32_t, 4>> MeshSection::MakeTets(
  const WriterPart& part, std::size_t chunk, const LocalIds& shared) const
{
  const auto cells = part.GetCells(chunk);
  const auto* const own = this->OwnNumbers.data();
  std::vector<std::array<std::uint32_t, 4>> tets(cells.size());
  // Which points are shared is random, so that they are collected without branches.
  std::array<std::uint32_t*, 1024> found;
  std::size_t count = 0;
  const auto number = [&]
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      *found[i] = shared[*found[i]];
    }
    count = 0;
  };
  for (std::size_t t = 0; t < tets.size(); ++t)
  {
    part.Mesh.FetchAhead(cells, t);
    auto* corner = tets[t].data();
    part.Mesh.ForEachPoint(cells[t],
      [&](std::uint64_t id)
      {
        const auto point = static_cast<std::uint32_t>(id);
        const bool isShared = own[point] == NotOwn;
        *corner = isShared ? point : own[point];
        found[count] = corner++;
        count += isShared;
      });
    if (count + 4 > found.size())
    {
      number();
    }
  }
  number();
  return tets;
}

//------------------------------------------------------------------------------
/** Several threads can make those of several chunks. */
MeshSection::LocalMesh MeshSection::MakeLocalMesh(const WriterPart& part, std::size_t chunk)
{
  LocalMesh local;
  local.Shared = part.GetSharedPoints(this->State.Table, chunk);
  local.Own = SortAlongCurve(part.Mesh, part.Layout.OwnPoints[chunk]);
  LocalIds shared(local.Shared.size());
  for (const auto p : local.Shared)
  {
    shared.Add(p);
  }
  auto number = static_cast<std::uint32_t>(local.Shared.size());
  for (const auto p : local.Own)
  {
    this->OwnNumbers[p] = number++;
  }
  const auto numberOf = [&, own = std::span<const std::uint32_t>(this->OwnNumbers)](
                          std::uint32_t point)
  { return own[point] != NotOwn ? own[point] : shared[point]; };
  const auto& sizes = this->State.Table.Chunks[part.Place.FirstChunk + chunk].Sizes;
  if (sizes.IsTetrahedral)
  {
    local.Tets = this->MakeTets(part, chunk, shared);
  }
  else
  {
    local.Cells = this->MakeCells(part, chunk, sizes, numberOf);
  }
  return local;
}

//------------------------------------------------------------------------------
CellSizes MeshSection::GetSizes(const WriterPart& part, std::size_t chunk) const
{
  const auto& mesh = part.Mesh;
  const auto cells = part.GetCells(chunk);
  CellSizes sizes;
  sizes.Cells = static_cast<std::uint32_t>(cells.size());
  std::uint64_t corners = 4 * cells.size();
  std::uint64_t faceValues = 0;
  if (!mesh.IsTetrahedral())
  {
    corners = 0;
    for (const auto cell : cells)
    {
      const auto size = mesh.GetEnd(cell) - mesh.GetBegin(cell);
      const auto type = mesh.GetType(cell);
      sizes.IsTetrahedral = sizes.IsTetrahedral && type == TetraType && size == 4;
      sizes.Polyhedra += type == PolyhedronType;
      corners += size;
      faceValues += mesh.GetFaces(cell).size();
    }
  }
  if (!mesh.IsTetrahedral() && corners + faceValues > MaxChunkCorners)
  {
    ThrowInvalid("the cells of a chunk have too many points; make chunks smaller");
  }
  sizes.Corners = static_cast<std::uint32_t>(corners);
  sizes.FaceValues = static_cast<std::uint32_t>(faceValues);
  return sizes;
}

//------------------------------------------------------------------------------
ChunkFrame MeshSection::MakeFrame(
  const WriterPart& part, std::size_t chunk, std::span<const std::uint32_t> shared) const
{
  const auto number = part.Place.FirstChunk + chunk;
  const auto& entry = this->State.Table.Chunks[number];
  ChunkFrame frame;
  entry.Sizes.SetIn(frame);
  frame.OwnPoints = static_cast<std::uint32_t>(entry.Info.OwnPoints);
  frame.Box = entry.Info.Box;
  frame.Domains = this->Domains;
  frame.SharedKeys = this->GetPointKeys(part, shared);
  frame.SharedUsers = this->State.Table.GetSharedUsers(static_cast<std::uint32_t>(number));
  return frame;
}

//------------------------------------------------------------------------------
/** Encodes a chunk and keeps the state that its arrays need. Called by several threads. */
MeshSection::ChunkStreams MeshSection::EncodeChunk(WriterPart& part, std::size_t chunk)
{
  const FloatEnvironment guard;
  const auto local = this->MakeLocalMesh(part, chunk);
  part.Layout.OwnPoints[chunk] = {};
  auto& info = this->State.Table.Chunks[part.Place.FirstChunk + chunk].Info;
  info.OwnPoints = local.Own.size();
  for (const auto* points : { &local.Shared, &local.Own })
  {
    for (const auto p : *points)
    {
      part.Mesh.Include(info.Box, p);
    }
  }
  const auto frame = this->MakeFrame(part, chunk, local.Shared);
  const auto ownKeys = this->GetPointKeys(part, local.Own);
  const bool keepsCorners = (this->State.Options.Keep & KeepCorners) != 0;
  auto& state = part.Chunks[chunk];
  ChunkStreams streams;
  std::vector<std::uint32_t> ownOrder;
  std::vector<std::uint32_t> cellOrder;
  const auto take = [&](auto& encoded)
  {
    streams.Connectivity = std::move(encoded.Connectivity);
    streams.Geometry = std::move(encoded.Geometry);
    state.Mesh = std::move(encoded.Mesh);
    ownOrder = std::move(encoded.OwnOrder);
  };
  if (info.IsTetrahedral)
  {
    auto encoded = gatun::EncodeChunk(frame, local.Tets, ownKeys, this->State.Options.Coding);
    take(encoded);
    cellOrder = std::move(encoded.TetOrder);
    info.Tets = cellOrder.size();
    if (keepsCorners)
    {
      streams.Corners = EncodeRotations(
        encoded.Corners, { state.Mesh.Walk.Parents, nullptr, this->State.Options.Coding });
    }
  }
  else
  {
    auto encoded = EncodeCells(frame, local.Cells, this->State.Cells.Shapes, ownKeys, keepsCorners,
      this->State.Options.Coding);
    take(encoded);
    cellOrder = std::move(encoded.CellOrder);
    info.Tets = CountTets(state.Mesh);
    streams.Corners = std::move(encoded.Corners);
  }
  const auto& sources = state.Mesh.Walk.Sources;
  state.PointOf.resize(sources.size());
  for (std::size_t v = 0; v < sources.size(); ++v)
  {
    state.PointOf[v] = (sources[v] & Topology::SharedFlag)
      ? local.Shared[sources[v] & ~Topology::SharedFlag]
      : local.Own[ownOrder[sources[v]]];
  }
  const auto cells = part.GetCells(chunk);
  state.CellOf.resize(cellOrder.size());
  std::transform(cellOrder.begin(), cellOrder.end(), state.CellOf.begin(),
    [&](std::uint32_t cell) { return cells[cell]; });
  this->EncodeOrder(part, state, streams);
  state.Mesh.Walk.EdgeLog.shrink_to_fit(); // of all chunks at once
  const auto& arrays = this->State.Meta.Arrays;
  if (std::none_of(arrays.begin(), arrays.end(),
        [](const ArrayDescription& array) { return array.Where == Association::Cell; }))
  {
    state.Mesh.Walk.Tets = {};
    state.Mesh.Walk.Packed = {};
    state.Mesh.Cells = {};
  }
  return streams;
}

//------------------------------------------------------------------------------
void MeshSection::EncodeOrder(
  const WriterPart& part, ChunkState& chunk, ChunkStreams& streams) const
{
  if (this->State.Options.Keep & KeepPoints)
  {
    const Domain ids(GetNumberType(this->State.Meta.Points));
    ComponentKeys keys;
    for (const auto point : chunk.PointOf)
    {
      keys.Now.push_back(part.GetPointNumber(point));
    }
    streams.PointOrder = EncodePointValues(MakePointContext(chunk.Mesh), { &ids, 1 }, { &keys, 1 });
  }
  if (this->State.Options.Keep & KeepCells)
  {
    const Domain ids(GetNumberType(this->State.NumberOfCells));
    ComponentKeys keys;
    for (const auto cell : chunk.CellOf)
    {
      keys.Now.push_back(part.Place.FirstCell + cell);
    }
    const CellContext cells{ chunk.Mesh.Walk.Parents, nullptr, this->State.Options.Coding };
    streams.CellOrder = EncodeCellValues(cells, { &ids, 1 }, { &keys, 1 });
  }
}

//------------------------------------------------------------------------------
void MeshSection::AddStreams(const ChunkStreams& streams, ChunkEntry& entry, StreamBatch& batch)
{
  batch.Add(streams.Connectivity, entry.Connectivity);
  batch.Add(streams.Geometry, entry.Geometry);
  this->State.Statistics.ConnectivityBytes += streams.Connectivity.size();
  this->State.Statistics.GeometryBytes += streams.Geometry.size();
  for (const auto& [bytes, where] : { std::pair(&streams.PointOrder, &entry.PointOrder),
         std::pair(&streams.CellOrder, &entry.CellOrder),
         std::pair(&streams.Corners, &entry.Corners) })
  {
    if (!bytes->empty())
    {
      batch.Add(*bytes, *where);
      this->State.Statistics.OrderBytes += bytes->size();
    }
  }
}

//------------------------------------------------------------------------------
void MeshSection::WriteChunks(WriterPart& part, const std::function<bool(double)>& progress,
  const std::function<void(std::size_t)>& encoded)
{
  std::vector<ChunkStreams> streams(ChunksPerBatch);
  StreamBatch batch;
  ForEachBatch(
    part.Chunks.size(),
    [&](std::size_t chunk)
    {
      streams[chunk % ChunksPerBatch] = this->EncodeChunk(part, chunk);
      if (encoded)
      {
        encoded(chunk);
      }
    },
    [&](std::size_t first, std::size_t count)
    {
      for (std::size_t i = 0; i < count; ++i)
      {
        this->AddStreams(
          streams[i], this->State.Table.Chunks[part.Place.FirstChunk + first + i], batch);
      }
      batch.Write(this->State.File, SectionMesh);
    },
    progress);
}

//------------------------------------------------------------------------------
void MeshSection::FindBounds(const WriterPart& part)
{
  for (std::size_t c = 0; c < part.Chunks.size(); ++c)
  {
    const auto& info = this->State.Table.Chunks[part.Place.FirstChunk + c].Info;
    this->State.Meta.Tets += info.Tets;
    this->State.Meta.Box.Include(info.Box);
  }
}
}
