// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunMeshSection.h"

#include "gatunFloatEnvironment.h"
#include "gatunLocalIds.h"
#include "gatunPalette.h"
#include "gatunParallel.h"

#include <algorithm>
#include <memory>
#include <string>
#include <tuple>
#include <utility>

namespace gatun
{
//------------------------------------------------------------------------------
void MeshSection::Write(const std::function<bool(double)>& progress)
{
  this->MakePartition(progress);
  StreamBatch batch;
  this->WritePalettes(batch);
  this->WriteBlocks(batch);
  batch.Write(this->State.File, SectionMesh);
  this->WriteChunks(progress);
  this->FindBounds();
  this->State.Parts.Tets = {};
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
    this->State.Table.Chunks[c].Info.Tets =
      this->State.Parts.ChunkStart[c + 1] - this->State.Parts.ChunkStart[c];
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
MeshSection::LocalMesh MeshSection::MakeLocalMesh(std::size_t chunk)
{
  LocalMesh local;
  local.Shared = this->GetSharedPoints(chunk);
  local.Own = std::move(this->State.Parts.OwnPoints[chunk]);
  LocalIds ids(local.Shared.size() + local.Own.size());
  for (const auto* points : { &local.Shared, &local.Own })
  {
    for (const auto p : *points)
    {
      ids.Add(p);
    }
  }
  const auto begin = this->State.Parts.ChunkStart[chunk];
  local.Tets.resize(this->State.Parts.ChunkStart[chunk + 1] - begin);
  for (std::size_t t = 0; t < local.Tets.size(); ++t)
  {
    for (unsigned i = 0; i < 4; ++i)
    {
      local.Tets[t][i] = ids[static_cast<std::uint32_t>(
        this->State.Mesh.GetId(this->State.Parts.Tets[begin + t], i))];
    }
  }
  return local;
}

//------------------------------------------------------------------------------
ChunkFrame MeshSection::MakeFrame(std::size_t chunk, std::span<const std::uint32_t> shared) const
{
  const auto& entry = this->State.Table.Chunks[chunk];
  ChunkFrame frame;
  frame.Tets = static_cast<std::uint32_t>(entry.Info.Tets);
  frame.OwnPoints = static_cast<std::uint32_t>(entry.Info.OwnPoints);
  frame.Box = entry.Info.Box;
  frame.Domains = this->Domains;
  frame.SharedKeys = this->GetPointKeys(shared);
  frame.SharedUsers = this->State.Table.GetSharedUsers(chunk);
  return frame;
}

//------------------------------------------------------------------------------
/** Encodes a chunk and keeps the state that its arrays need. Called by several threads. */
MeshSection::ChunkStreams MeshSection::EncodeChunk(std::size_t chunk)
{
  const FloatEnvironment guard;
  const auto local = this->MakeLocalMesh(chunk);
  auto& info = this->State.Table.Chunks[chunk].Info;
  info.OwnPoints = local.Own.size();
  for (const auto* points : { &local.Shared, &local.Own })
  {
    for (const auto p : *points)
    {
      this->State.Mesh.Include(info.Box, p);
    }
  }
  auto encoded = gatun::EncodeChunk(
    this->MakeFrame(chunk, local.Shared), local.Tets, this->GetPointKeys(local.Own));

  auto& state = this->State.Chunks[chunk];
  state.Mesh = std::move(encoded.Mesh);
  const auto& walk = state.Mesh.Walk;
  state.PointOf.resize(walk.Sources.size());
  for (std::size_t v = 0; v < walk.Sources.size(); ++v)
  {
    const auto source = walk.Sources[v];
    state.PointOf[v] = (source & Topology::SharedFlag)
      ? local.Shared[source & ~Topology::SharedFlag]
      : local.Own[encoded.OwnOrder[source]];
  }
  state.TetOf.resize(encoded.TetOrder.size());
  for (std::size_t t = 0; t < state.TetOf.size(); ++t)
  {
    state.TetOf[t] =
      this->State.Parts.Tets[this->State.Parts.ChunkStart[chunk] + encoded.TetOrder[t]];
  }
  ChunkStreams streams;
  streams.Connectivity = std::move(encoded.Connectivity);
  streams.Geometry = std::move(encoded.Geometry);
  this->EncodeOrder(state, encoded.Corners, streams);
  state.Mesh.Walk.Tets = {};
  return streams;
}

//------------------------------------------------------------------------------
void MeshSection::EncodeOrder(
  ChunkState& chunk, const std::vector<std::uint8_t>& corners, ChunkStreams& streams) const
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
    keys.Now.assign(chunk.TetOf.begin(), chunk.TetOf.end());
    streams.CellOrder = EncodeCellValues(chunk.Mesh.Walk.Parents, { &ids, 1 }, { &keys, 1 });
  }
  if (this->State.Options.Keep & KeepCorners)
  {
    const Domain rotations(ScalarType::UInt8);
    ComponentKeys keys;
    keys.Now.assign(corners.begin(), corners.end());
    streams.Corners = EncodeCellValues(chunk.Mesh.Walk.Parents, { &rotations, 1 }, { &keys, 1 });
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
  for (const auto& chunk : this->State.Table.Chunks)
  {
    this->State.Meta.Box.Include(chunk.Info.Box);
  }
  for (const auto p : this->State.Parts.UnusedPoints)
  {
    this->State.Mesh.Include(this->State.Meta.Box, p);
  }
}
}
