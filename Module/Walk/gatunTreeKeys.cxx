// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunTreeKeys.h"

#include "gatunGateLanes.h"
#include "gatunGateValues.h"

#include <algorithm>
#include <array>
#include <vector>

namespace gatun
{
namespace
{
constexpr unsigned Axes = 3;

/** The keys of one axis. */
std::vector<Key> GetAxis(std::span<const PointKeys> keys, unsigned axis)
{
  std::vector<Key> result(keys.size());
  std::transform(keys.begin(), keys.end(), result.begin(),
    [axis](const PointKeys& point) { return point[axis]; });
  return result;
}
}

//------------------------------------------------------------------------------
Bytes EncodeTreeKeys(const ChunkMesh& mesh)
{
  ByteWriter geometry;
  for (unsigned axis = 0; axis < Axes; ++axis)
  {
    auto keys = GetAxis(mesh.Keys, axis);
    PutVertexValues(geometry, mesh.Domains[axis], { mesh.Walk.Gates, mesh.Walk.Sources }, { keys });
  }
  return std::move(geometry.Data);
}

//------------------------------------------------------------------------------
void DecodeTreeKeys(
  const ChunkFrame& frame, std::span<const std::uint8_t> geometry, ChunkMesh& mesh)
{
  const auto& sources = mesh.Walk.Sources;
  const GateVertices vertices{ mesh.Walk.Gates, sources };
  mesh.Keys.resize(sources.size());
  for (Vertex v = 0; v < sources.size(); ++v)
  {
    if (mesh.Walk.IsShared(v))
    {
      mesh.Keys[v] = frame.SharedKeys[sources[v] & ~Topology::SharedFlag];
    }
  }
  ByteReader in(geometry);
  if (std::all_of(mesh.Domains.begin(), mesh.Domains.end(), Float32Domain::Matches))
  {
    std::array<KeyColumn, Axes> columns{};
    for (unsigned axis = 0; axis < Axes; ++axis)
    {
      columns[axis] = { &mesh.Keys[0][axis], Axes };
    }
    GetVertexLanes(in, vertices, columns);
    return;
  }
  for (unsigned axis = 0; axis < Axes; ++axis)
  {
    auto keys = GetAxis(mesh.Keys, axis);
    GetVertexValues(in, mesh.Domains[axis], vertices, { keys });
    for (std::size_t v = 0; v < keys.size(); ++v)
    {
      mesh.Keys[v][axis] = keys[v];
    }
  }
}
}
