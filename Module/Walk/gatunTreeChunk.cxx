// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunTreeChunk.h"

#include "gatunCornerRotation.h"
#include "gatunTetTree.h"
#include "gatunTreeEncoder.h"
#include "gatunTreeKeys.h"

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
  walk.Packed = std::move(tree.Tets);
  for (std::size_t t = 0; !tree.Flips.empty() && t < walk.Packed.size(); ++t)
  {
    if ((tree.Flips[t / 8] >> t % 8 & 1) != 0)
    {
      walk.Packed[t] = ExchangeLast(walk.Packed[t]);
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
  result.Geometry = EncodeTreeKeys(mesh);
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
  mesh.OwnIds = mesh.Walk.FindOwnIds();
  DecodeTreeKeys(frame, geometry, mesh);
  return mesh;
}
}
