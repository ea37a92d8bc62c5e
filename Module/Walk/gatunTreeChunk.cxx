// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunTreeChunk.h"

#include "gatunCornerRotation.h"
#include "gatunGateValues.h"
#include "gatunTreeEncoder.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace gatun
{
namespace
{
/** The mesh of a tree without coordinates. */
void SetWalk(TetTree&& tree, Topology& walk)
{
  const auto tets = tree.GetTets();
  walk.Tets.reserve(tets.size());
  for (const auto tet : tets)
  {
    walk.Tets.push_back(
      { GetCorner(tet, 0), GetCorner(tet, 1), GetCorner(tet, 2), GetCorner(tet, 3) });
  }
  for (std::size_t t = 0; !tree.Flips.empty() && t < tets.size(); ++t)
  {
    if ((tree.Flips[t / 8] >> t % 8 & 1) != 0)
    {
      std::swap(walk.Tets[t][2], walk.Tets[t][3]);
    }
  }
  walk.Parents = std::move(tree.Parents);
  walk.Sources = std::move(tree.Sources);
  walk.Gates = std::move(tree.Gates);
}

/** For each of EncodedTree::Turns the rotation that restores the input's corners. */
std::array<std::uint8_t, 64> MakeRotations()
{
  std::array<std::uint8_t, 64> rotations{};
  for (unsigned turn = 0; turn < rotations.size(); ++turn)
  {
    auto walked = EncodedTree::GetPlaces(turn);
    if (EncodedTree::IsMirrored(turn))
    {
      std::swap(walked[2], walked[3]);
    }
    bool isMirrored = false;
    rotations[turn] = FindRotation(walked, { 0, 1, 2, 3 }, isMirrored);
  }
  return rotations;
}

/** The keys of one axis. */
std::vector<Key> GetAxis(std::span<const PointKeys> keys, unsigned axis)
{
  std::vector<Key> result(keys.size());
  for (std::size_t v = 0; v < keys.size(); ++v)
  {
    result[v] = keys[v][axis];
  }
  return result;
}
}

//------------------------------------------------------------------------------
EncodedChunk EncodeTreeChunk(const ChunkFrame& frame,
  std::span<const std::array<std::uint32_t, 4>> tets, std::span<const PointKeys> ownKeys)
{
  const auto shared = static_cast<std::uint32_t>(frame.SharedKeys.size());
  auto tree = EncodeTree(tets, shared, shared + static_cast<std::uint32_t>(ownKeys.size()));
  EncodedChunk result;
  result.Connectivity = std::move(tree.Stream);
  result.OwnOrder = std::move(tree.OwnOrder);
  result.TetOrder = std::move(tree.TetOrder);
  auto& mesh = result.Mesh;
  SetWalk(std::move(tree.Tree), mesh.Walk);
  const auto& walk = mesh.Walk;
  mesh.Domains = frame.Domains;
  mesh.OwnIds = walk.FindOwnIds();
  const auto inputOf = [&](Vertex v)
  {
    const auto source = walk.Sources[v];
    return walk.IsShared(v) ? source & ~Topology::SharedFlag : shared + result.OwnOrder[source];
  };
  mesh.Keys.resize(walk.Sources.size());
  for (Vertex v = 0; v < mesh.Keys.size(); ++v)
  {
    const auto input = inputOf(v);
    mesh.Keys[v] = input < shared ? frame.SharedKeys[input] : ownKeys[input - shared];
  }
  result.Corners.resize(tets.size());
  std::transform(tree.Turns.begin(), tree.Turns.end(), result.Corners.begin(),
    [rotations = MakeRotations()](std::uint8_t turn) { return rotations[turn]; });
  ByteWriter geometry;
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    auto keys = GetAxis(mesh.Keys, axis);
    PutVertexValues(geometry, mesh.Domains[axis], { walk.Gates, walk.Sources }, { keys });
  }
  result.Geometry = std::move(geometry.Data);
  return result;
}

//------------------------------------------------------------------------------
ChunkMesh DecodeTreeChunk(const ChunkFrame& frame, std::span<const std::uint8_t> connectivity,
  std::span<const std::uint8_t> geometry)
{
  const auto shared = static_cast<std::uint32_t>(frame.SharedKeys.size());
  const auto vertices = std::size_t{ shared } + frame.OwnPoints;
  if (!FitsTree(vertices))
  {
    ThrowCorrupt("a chunk has too many vertices for its coder");
  }
  ChunkMesh mesh;
  mesh.Domains = frame.Domains;
  SetWalk(
    DecodeTree(connectivity, frame.Tets, shared, static_cast<std::uint32_t>(vertices)), mesh.Walk);
  const auto& walk = mesh.Walk;
  mesh.OwnIds = walk.FindOwnIds();
  mesh.Keys.resize(vertices);
  ByteReader in(geometry);
  std::vector<Key> keys(vertices);
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    for (Vertex v = 0; v < vertices; ++v)
    {
      keys[v] =
        walk.IsShared(v) ? frame.SharedKeys[walk.Sources[v] & ~Topology::SharedFlag][axis] : 0;
    }
    GetVertexValues(in, mesh.Domains[axis], { walk.Gates, walk.Sources }, { keys });
    for (Vertex v = 0; v < vertices; ++v)
    {
      mesh.Keys[v][axis] = keys[v];
    }
  }
  return mesh;
}
}
