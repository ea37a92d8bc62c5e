// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunMeshSection.h"

#include "gatunFloatEnvironment.h"
#include "gatunPalette.h"

#include <algorithm>
#include <string>
#include <utility>

namespace gatun
{
//------------------------------------------------------------------------------
void MeshSection::Write(const std::function<bool(double)>& progress)
{
  this->MakePartition(progress);
  StreamBatch batch;
  this->WritePalettes(batch);
  for (std::size_t b = 0; b < this->State.Table.Blocks.size(); ++b)
  {
    this->WriteBlock(this->State.Table.Blocks[b], this->State.GetBlockPoints(b), batch);
  }
  this->WriteBlock(this->State.Table.Unused, this->State.Parts.UnusedPoints, batch);
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
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    auto palette = FindPalette(
      input.CoordinateType, input.Coordinates, static_cast<std::size_t>(input.Points), 3, axis);
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
void MeshSection::WriteBlock(
  BlockEntry& block, std::span<const std::uint32_t> points, StreamBatch& batch)
{
  if (points.empty())
  {
    return;
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
  auto geometry = EncodeCellValues({}, this->Domains, keys);
  geometry.resize(std::max<std::size_t>(geometry.size(), points.size() / MaxItemsPerByte + 1), 0);
  batch.Add(geometry, block.Geometry);
  this->State.Statistics.SharedGeometryBytes += geometry.size();
  if (this->State.Options.Keep & KeepPoints)
  {
    const Domain ids(ScalarType::UInt32);
    ComponentKeys order;
    order.Now.assign(points.begin(), points.end());
    const auto stream = EncodeCellValues({}, { &ids, 1 }, { &order, 1 });
    batch.Add(stream, block.Order);
    this->State.Statistics.OrderBytes += stream.size();
  }
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
/** The points that no other chunk uses, in the order of the input. */
std::vector<std::uint32_t> MeshSection::GetOwnPoints(std::size_t chunk) const
{
  const auto begin = this->State.Parts.ChunkStart[chunk];
  const auto end = this->State.Parts.ChunkStart[chunk + 1];
  std::vector<std::uint32_t> own;
  for (auto t = begin; t < end; ++t)
  {
    for (unsigned i = 0; i < 4; ++i)
    {
      const auto p =
        static_cast<std::uint32_t>(this->State.Mesh.GetId(this->State.Parts.Tets[t], i));
      if (this->State.Parts.SharedIndex[p] == Partition::OwnPoint)
      {
        own.push_back(p);
      }
    }
  }
  std::sort(own.begin(), own.end());
  own.erase(std::unique(own.begin(), own.end()), own.end());
  return own;
}

//------------------------------------------------------------------------------
MeshSection::LocalMesh MeshSection::MakeLocalMesh(std::size_t chunk) const
{
  LocalMesh local;
  local.Shared = this->GetSharedPoints(chunk);
  local.Own = this->GetOwnPoints(chunk);
  const auto begin = this->State.Parts.ChunkStart[chunk];
  const auto end = this->State.Parts.ChunkStart[chunk + 1];
  std::vector<std::pair<std::uint32_t, std::uint32_t>> sharedIds(local.Shared.size());
  for (std::uint32_t i = 0; i < local.Shared.size(); ++i)
  {
    sharedIds[i] = { local.Shared[i], i };
  }
  std::sort(sharedIds.begin(), sharedIds.end());
  const auto toLocal = [&](std::uint32_t p)
  {
    if (this->State.Parts.SharedIndex[p] == Partition::OwnPoint)
    {
      return static_cast<std::uint32_t>(std::lower_bound(local.Own.begin(), local.Own.end(), p) -
        local.Own.begin() + static_cast<std::ptrdiff_t>(local.Shared.size()));
    }
    return std::lower_bound(
      sharedIds.begin(), sharedIds.end(), std::pair<std::uint32_t, std::uint32_t>{ p, 0 })
      ->second;
  };
  local.Tets.resize(end - begin);
  for (auto t = begin; t < end; ++t)
  {
    for (unsigned i = 0; i < 4; ++i)
    {
      local.Tets[t - begin][i] =
        toLocal(static_cast<std::uint32_t>(this->State.Mesh.GetId(this->State.Parts.Tets[t], i)));
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
