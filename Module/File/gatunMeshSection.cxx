// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunMeshSection.h"

#include "gatunCellCodec.h"
#include "gatunChunkTets.h"
#include "gatunFloatEnvironment.h"
#include "gatunPalette.h"
#include "gatunParallel.h"

#include <algorithm>
#include <memory>
#include <string>
#include <tuple>
#include <utility>

namespace gatun
{
namespace
{
Bytes EncodeRotations(
  const std::vector<std::uint8_t>& rotations, std::span<const std::uint32_t> parents)
{
  const Domain domain(ScalarType::UInt8);
  ComponentKeys keys;
  keys.Now.assign(rotations.begin(), rotations.end());
  return EncodeCellValues(parents, { &domain, 1 }, { &keys, 1 });
}
}

//------------------------------------------------------------------------------
void MeshSection::Write(const std::function<bool(double)>& progress)
{
  this->MakePartition(progress);
  StreamBatch batch;
  this->WritePalettes(batch);
  this->WriteBlocks(batch);
  batch.Write(this->State.File, SectionMesh);
  if (!this->State.Mesh.IsTetrahedral())
  {
    this->CountTypes();
    this->FindShapes();
  }
  this->WriteChunks(progress);
  this->FindBounds();
  this->State.Parts.Cells = {};
  this->State.Parts.SharedIndex = {};
}

//------------------------------------------------------------------------------
void MeshSection::MakePartition(const std::function<bool(double)>& progress)
{
  if (this->State.Options.Layers)
  {
    this->Layers.emplace();
    this->Layers->Request = *this->State.Options.Layers;
    this->Layers->Array = this->State.Meta.Arrays[this->Layers->Request.Array];
  }
  this->State.Parts = gatun::MakePartition(this->State.Mesh, this->State.Meta.ChunkTets, progress,
    this->Layers ? &*this->Layers : nullptr);
  this->State.Meta.UnusedPoints = this->State.Parts.UnusedPoints.size();
  this->State.Table.Blocks = std::move(this->State.Parts.Blocks);
  this->State.Table.Unused.Points = this->State.Meta.UnusedPoints;
  this->State.Table.Chunks.resize(this->State.Parts.GetChunkCount());
  for (std::size_t c = 0; c < this->State.Table.Chunks.size(); ++c)
  {
    auto& entry = this->State.Table.Chunks[c];
    entry.Sizes = this->GetSizes(c);
    entry.Info.Cells = entry.Sizes.Cells;
    entry.Info.IsTetrahedral = entry.Sizes.IsTetrahedral;
    this->State.Cells.Chunks.push_back(entry.Sizes);
  }
  try
  {
    this->State.Table.LinkGroups();
  }
  catch (const Error& error)
  {
    ThrowInvalid(error.what() + std::string("; make chunks larger"));
  }
  this->State.Chunks.resize(this->State.Table.Chunks.size());
}

//------------------------------------------------------------------------------
void MeshSection::WritePalettes(StreamBatch& batch)
{
  const auto& input = this->State.Mesh.GetMesh();
  std::array<std::shared_ptr<const Palette>, 3> palettes;
  ParallelFor(palettes.size(),
    [&](std::size_t axis)
    {
      palettes[axis] = FindPalette(
        input.CoordinateType, input.Coordinates, static_cast<std::size_t>(input.Points), 3, axis);
    });
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    const auto& palette = palettes[axis];
    this->Domains[axis] = Domain(input.CoordinateType, palette);
    if (palette)
    {
      auto& where = this->State.Table.Palettes[axis];
      where.Count = palette->size();
      const auto stream = EncodePalette(input.CoordinateType, *palette);
      batch.Add(stream, where.Stream);
      this->State.Statistics.SharedGeometryBytes += stream.size();
    }
  }
}

//------------------------------------------------------------------------------
void MeshSection::WriteBlocks(StreamBatch& batch)
{
  auto& blocks = this->State.Table.Blocks;
  std::vector<BlockStreams> streams(blocks.size() + 1);
  ParallelFor(streams.size(),
    [&](std::size_t b)
    {
      streams[b] = this->EncodeBlock(b < blocks.size()
          ? this->State.GetBlockPoints(b)
          : std::span<const std::uint32_t>(this->State.Parts.UnusedPoints));
    });
  for (std::size_t b = 0; b < streams.size(); ++b)
  {
    auto& block = b < blocks.size() ? blocks[b] : this->State.Table.Unused;
    for (const auto& [bytes, where, count] : { std::tuple(&streams[b].Geometry, &block.Geometry,
                                                 &this->State.Statistics.SharedGeometryBytes),
           std::tuple(&streams[b].Order, &block.Order, &this->State.Statistics.OrderBytes) })
    {
      if (!bytes->empty())
      {
        batch.Add(*bytes, *where);
        *count += bytes->size();
      }
    }
  }
}

//------------------------------------------------------------------------------
/** Encodes the points of a block. Called by several threads. */
MeshSection::BlockStreams MeshSection::EncodeBlock(std::span<const std::uint32_t> points) const
{
  BlockStreams streams;
  if (points.empty())
  {
    return streams;
  }
  const FloatEnvironment guard;
  const auto pointKeys = this->GetPointKeys(points);
  std::vector<ComponentKeys> keys(3);
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    keys[axis].Now.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      keys[axis].Now[i] = pointKeys[i][axis];
    }
  }
  streams.Geometry = EncodeCellValues({}, this->Domains, keys);
  streams.Geometry.resize(
    std::max<std::size_t>(streams.Geometry.size(), points.size() / MaxItemsPerByte + 1), 0);
  if (this->State.Options.Keep & KeepPoints)
  {
    const Domain ids(ScalarType::UInt32);
    ComponentKeys order;
    order.Now.assign(points.begin(), points.end());
    streams.Order = EncodeCellValues({}, { &ids, 1 }, { &order, 1 });
  }
  return streams;
}

//------------------------------------------------------------------------------
std::vector<PointKeys> MeshSection::GetPointKeys(std::span<const std::uint32_t> points) const
{
  const auto& input = this->State.Mesh.GetMesh();
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
std::vector<std::uint32_t> MeshSection::GetSharedPoints(std::size_t chunk) const
{
  std::vector<std::uint32_t> points;
  for (const auto& part : this->State.Table.Chunks[chunk].Shared)
  {
    const auto& group = this->State.Table.Blocks[part.Block].Groups[part.Group];
    const auto block = this->State.GetBlockPoints(part.Block);
    const auto begin = block.begin() + static_cast<std::ptrdiff_t>(part.FirstInBlock);
    points.insert(points.end(), begin, begin + group.Points);
  }
  return points;
}

//------------------------------------------------------------------------------
/** The cells of a chunk with the points that numberOf returns for those of the input. */
template <typename NumberOf>
CellList MeshSection::MakeCells(std::size_t chunk, NumberOf&& numberOf) const
{
  const auto& mesh = this->State.Mesh;
  const auto& sizes = this->State.Table.Chunks[chunk].Sizes;
  CellList cells;
  cells.Corners.reserve(sizes.Corners);
  cells.Faces.reserve(sizes.FaceValues);
  if (sizes.Polyhedra > 0)
  {
    cells.FaceStarts.push_back(0);
  }
  for (const auto cell : this->GetCells(chunk))
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
MeshSection::LocalMesh MeshSection::MakeLocalMesh(std::size_t chunk)
{
  LocalMesh local;
  local.Shared = this->GetSharedPoints(chunk);
  local.Own = this->State.Parts.OwnPoints[chunk];
  LocalIds ids(local.Shared.size() + local.Own.size());
  for (const auto* points : { &local.Shared, &local.Own })
  {
    for (const auto p : *points)
    {
      ids.Add(p);
    }
  }
  if (this->State.Table.Chunks[chunk].Sizes.IsTetrahedral)
  {
    local.Tets = this->MakeTets(chunk, ids);
  }
  else
  {
    local.Cells = this->MakeCells(chunk, [&](std::uint32_t point) { return ids[point]; });
  }
  return local;
}

//------------------------------------------------------------------------------
/** The input's cells of a chunk. */
std::span<const std::uint32_t> MeshSection::GetCells(std::size_t chunk) const
{
  const auto& parts = this->State.Parts;
  return std::span(parts.Cells)
    .subspan(parts.ChunkStart[chunk], parts.ChunkStart[chunk + 1] - parts.ChunkStart[chunk]);
}

//------------------------------------------------------------------------------
CellSizes MeshSection::GetSizes(std::size_t chunk) const
{
  const auto& mesh = this->State.Mesh;
  const auto cells = this->GetCells(chunk);
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
std::vector<std::array<std::uint32_t, 4>> MeshSection::MakeTets(
  std::size_t chunk, const LocalIds& ids) const
{
  const auto cells = this->GetCells(chunk);
  std::vector<std::array<std::uint32_t, 4>> tets(cells.size());
  for (std::size_t t = 0; t < tets.size(); ++t)
  {
    const auto begin = this->State.Mesh.GetBegin(cells[t]);
    for (unsigned i = 0; i < 4; ++i)
    {
      tets[t][i] = ids[static_cast<std::uint32_t>(this->State.Mesh.GetId(begin + i))];
    }
  }
  return tets;
}

//------------------------------------------------------------------------------
ChunkFrame MeshSection::MakeFrame(std::size_t chunk, std::span<const std::uint32_t> shared) const
{
  const auto& entry = this->State.Table.Chunks[chunk];
  ChunkFrame frame;
  entry.Sizes.SetIn(frame);
  frame.OwnPoints = static_cast<std::uint32_t>(entry.Info.OwnPoints);
  frame.Box = entry.Info.Box;
  frame.Domains = this->Domains;
  frame.SharedKeys = this->GetPointKeys(shared);
  frame.SharedUsers = this->State.Table.GetSharedUsers(chunk);
  return frame;
}

//------------------------------------------------------------------------------
/** Lists the types of all cells. */
void MeshSection::CountTypes()
{
  std::array<std::uint64_t, 256> counts{};
  for (std::uint64_t cell = 0; cell < this->State.Mesh.GetMesh().Cells; ++cell)
  {
    ++counts[this->State.Mesh.GetType(cell)];
  }
  for (std::size_t type = 0; type < counts.size(); ++type)
  {
    if (counts[type] > 0)
    {
      this->State.Cells.Types.push_back({ static_cast<std::uint8_t>(type), counts[type] });
    }
  }
}

//------------------------------------------------------------------------------
/** Lists the shapes of all cells. */
void MeshSection::FindShapes()
{
  std::vector<ShapeTable> shapes(this->State.Chunks.size());
  ParallelFor(shapes.size(),
    [&](std::size_t chunk)
    {
      if (!this->State.Table.Chunks[chunk].Sizes.IsTetrahedral)
      {
        // Shapes do not depend on the numbers of points.
        shapes[chunk].Add(this->MakeCells(chunk, [](std::uint32_t point) { return point; }));
      }
    });
  ShapeTable all;
  for (const auto& table : shapes)
  {
    all.Merge(table);
  }
  this->State.Cells.SetShapes(all.Write());
}

//------------------------------------------------------------------------------
/** Encodes a chunk and keeps the state that its arrays need. Called by several threads. */
MeshSection::ChunkStreams MeshSection::EncodeChunk(std::size_t chunk)
{
  const FloatEnvironment guard;
  const auto local = this->MakeLocalMesh(chunk);
  this->State.Parts.OwnPoints[chunk] = {};
  auto& info = this->State.Table.Chunks[chunk].Info;
  info.OwnPoints = local.Own.size();
  for (const auto* points : { &local.Shared, &local.Own })
  {
    for (const auto p : *points)
    {
      this->State.Mesh.Include(info.Box, p);
    }
  }
  const auto frame = this->MakeFrame(chunk, local.Shared);
  const auto ownKeys = this->GetPointKeys(local.Own);
  const bool keepsCorners = (this->State.Options.Keep & KeepCorners) != 0;
  auto& state = this->State.Chunks[chunk];
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
    auto encoded = gatun::EncodeChunk(frame, local.Tets, ownKeys);
    take(encoded);
    cellOrder = std::move(encoded.TetOrder);
    info.Tets = cellOrder.size();
    if (keepsCorners)
    {
      streams.Corners = EncodeRotations(encoded.Corners, state.Mesh.Walk.Parents);
    }
  }
  else
  {
    auto encoded = EncodeCells(frame, local.Cells, this->State.Cells.Shapes, ownKeys, keepsCorners);
    take(encoded);
    cellOrder = std::move(encoded.CellOrder);
    info.Tets = SplitCells(state.Mesh).Tets.size();
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
  const auto cells = this->GetCells(chunk);
  state.CellOf.resize(cellOrder.size());
  std::transform(cellOrder.begin(), cellOrder.end(), state.CellOf.begin(),
    [&](std::uint32_t cell) { return cells[cell]; });
  this->EncodeOrder(state, streams);
  state.Mesh.Walk.Tets = {};
  state.Mesh.Cells = {};
  return streams;
}

//------------------------------------------------------------------------------
void MeshSection::EncodeOrder(ChunkState& chunk, ChunkStreams& streams) const
{
  const Domain ids(ScalarType::UInt32);
  if (this->State.Options.Keep & KeepPoints)
  {
    chunk.Mesh.MakeContext(false);
    ComponentKeys keys;
    keys.Now.assign(chunk.PointOf.begin(), chunk.PointOf.end());
    streams.PointOrder = EncodePointValues(chunk.Mesh.Context, { &ids, 1 }, { &keys, 1 });
  }
  if (this->State.Options.Keep & KeepCells)
  {
    ComponentKeys keys;
    keys.Now.assign(chunk.CellOf.begin(), chunk.CellOf.end());
    streams.CellOrder = EncodeCellValues(chunk.Mesh.Walk.Parents, { &ids, 1 }, { &keys, 1 });
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
void MeshSection::WriteChunks(const std::function<bool(double)>& progress)
{
  std::vector<ChunkStreams> streams(ChunksPerBatch);
  StreamBatch batch;
  ForEachBatch(
    this->State.Chunks.size(),
    [&](std::size_t chunk) { streams[chunk % ChunksPerBatch] = this->EncodeChunk(chunk); },
    [&](std::size_t first, std::size_t count)
    {
      for (std::size_t i = 0; i < count; ++i)
      {
        this->AddStreams(streams[i], this->State.Table.Chunks[first + i], batch);
      }
      batch.Write(this->State.File, SectionMesh);
    },
    progress);
}

//------------------------------------------------------------------------------
void MeshSection::FindBounds()
{
  this->State.Meta.Tets = 0;
  for (const auto& chunk : this->State.Table.Chunks)
  {
    this->State.Meta.Tets += chunk.Info.Tets;
    this->State.Meta.Box.Include(chunk.Info.Box);
  }
  for (const auto p : this->State.Parts.UnusedPoints)
  {
    this->State.Mesh.Include(this->State.Meta.Box, p);
  }
}
}
