// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunCellTreeChunk.h"

#include "gatunCellCorners.h"
#include "gatunCellTree.h"
#include "gatunTreeKeys.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace gatun
{
namespace
{
/** Maps coordinates to the steps of TreePlace. */
class PlaceMap
{
public:
  explicit PlaceMap(const ChunkFrame& frame)
    : Domains(frame.Domains)
  {
    double extent = 0;
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      this->Least[axis] = frame.Box[axis].Min;
      extent = std::max(extent, frame.Box[axis].Max - frame.Box[axis].Min);
    }
    const double scale = Steps / extent;
    this->Scale = std::isfinite(scale) ? scale : 0;
  }

  TreePlace operator()(const PointKeys& keys) const
  {
    TreePlace place{};
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      const double steps =
        (this->Domains[axis].ToValue(keys[axis]) - this->Least[axis]) * this->Scale;
      // Not a number is 0, too.
      place[axis] = steps > 0 ? static_cast<std::int32_t>(std::min(steps, Steps)) : 0;
    }
    return place;
  }

private:
  static constexpr double Steps = 1 << 24;

  const PointDomain& Domains;
  std::array<double, 3> Least{};
  double Scale = 0;
};

void SetWalk(CellTree&& tree, ChunkMesh& mesh)
{
  mesh.Cells = std::move(tree.Cells);
  mesh.Walk.Parents = std::move(tree.Parents);
  mesh.Walk.Gates = std::move(tree.Gates);
  mesh.Walk.Sources = std::move(tree.Sources);
  mesh.OwnIds = mesh.Walk.FindOwnIds();
}

CellTreeSize GetSize(const ChunkFrame& frame)
{
  const auto shared = static_cast<std::uint32_t>(frame.SharedKeys.size());
  return { frame.Cells.Cells, frame.Cells.Corners, frame.Cells.FaceValues, shared,
    shared + frame.OwnPoints };
}
}

//------------------------------------------------------------------------------
EncodedCells EncodeCellTreeChunk(const ChunkFrame& frame, const CellList& cells,
  std::span<const PointKeys> ownKeys, bool keepCorners)
{
  const auto& shared = frame.SharedKeys;
  std::vector<TreePlace> places(shared.size() + ownKeys.size());
  const PlaceMap map(frame);
  std::transform(ownKeys.begin(), ownKeys.end(),
    std::transform(shared.begin(), shared.end(), places.begin(), map), map);
  auto tree = EncodeCellTree(cells, static_cast<std::uint32_t>(shared.size()), places, keepCorners);

  EncodedCells result;
  result.Connectivity = std::move(tree.Stream);
  result.OwnOrder = std::move(tree.OwnOrder);
  result.CellOrder = std::move(tree.CellOrder);
  auto& mesh = result.Mesh;
  mesh.Domains = frame.Domains;
  SetWalk(DecodeCellTree(result.Connectivity, GetSize(frame)), mesh);
  mesh.Keys.resize(tree.InputOf.size());
  std::transform(tree.InputOf.begin(), tree.InputOf.end(), mesh.Keys.begin(),
    [&](std::uint32_t input)
    { return input < shared.size() ? shared[input] : ownKeys[input - shared.size()]; });
  result.Geometry = EncodeTreeKeys(mesh);
  if (keepCorners)
  {
    result.Corners = EncodeCorners(mesh.Cells, cells, result.CellOrder, tree.InputOf);
  }
  return result;
}

//------------------------------------------------------------------------------
ChunkMesh DecodeCellTreeChunk(const ChunkFrame& frame, std::span<const std::uint8_t> connectivity,
  std::span<const std::uint8_t> geometry)
{
  const auto vertices = std::size_t{ frame.OwnPoints } + frame.SharedKeys.size();
  if (!FitsCellTree(frame.Cells.Cells, vertices))
  {
    ThrowCorrupt("a chunk has too many vertices for its coder");
  }
  ChunkMesh mesh;
  mesh.Domains = frame.Domains;
  SetWalk(DecodeCellTree(connectivity, GetSize(frame)), mesh);
  DecodeTreeKeys(frame, geometry, mesh);
  return mesh;
}
}
