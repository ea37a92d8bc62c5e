// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunMeshDependencies.h"

#include "gatunFileReader.h"
#include "gatunMeshTets.h"
#include "gatunPieceCells.h"
#include "gatunPieceDecoder.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace gatun
{
namespace
{
/** Whether merges gather so many cells around points that moving these takes long. Others need
 * about 20 steps for each corner. */
template <std::size_t Corners>
bool GathersTooMany(
  const MergeTree& tree, const std::vector<std::array<std::uint32_t, Corners>>& cells)
{
  constexpr std::uint64_t mostPerCorner = 256;
  constexpr std::uint64_t few = std::uint64_t{ 1 } << 24; // in any mesh
  std::vector<std::uint64_t> around(tree.GetNumberOfPoints(), 0);
  for (const auto& cell : cells)
  {
    for (const auto corner : cell)
    {
      ++around[corner];
    }
  }
  std::uint64_t steps = 0;
  for (const Merge& merge : tree.GetMerges())
  {
    around[merge.Into] += around[merge.Point];
    steps += around[merge.Into]; // at most
  }
  return steps > mostPerCorner * Corners * cells.size() + few;
}

template <std::size_t Corners>
std::optional<MergeDependencies> Replay(const MergeTree& tree,
  const std::vector<std::array<std::uint32_t, Corners>>& cells,
  const std::function<bool(double)>& progress)
{
  if (GathersTooMany(tree, cells))
  {
    return {};
  }
  return MergeDependencies(
    tree, std::span<const std::array<std::uint32_t, Corners>>(cells), progress);
}
}

//------------------------------------------------------------------------------
std::optional<MergeDependencies> FindDependencies(const MeshAccess& mesh, const MergeTree& tree,
  bool isSurface, const std::function<bool(double)>& progress)
{
  if (isSurface)
  {
    std::vector<MergeTree::Triangle> triangles;
    for (std::uint64_t cell = 0; cell < mesh.GetMesh().Cells; ++cell)
    {
      if (mesh.GetType(cell) == TriangleType)
      {
        const auto id = [&](std::uint64_t i)
        { return static_cast<std::uint32_t>(mesh.GetId(mesh.GetBegin(cell) + i)); };
        triangles.push_back({ id(0), id(1), id(2) });
      }
    }
    return Replay<3>(tree, triangles, progress);
  }
  std::vector<MergeTree::Tet> tets;
  tets.reserve(static_cast<std::size_t>(mesh.EstimateTets()));
  ForEachTet(mesh, [&](std::uint64_t, const MergeTree::Tet& tet) { tets.push_back(tet); });
  return Replay<4>(tree, tets, progress);
}

//------------------------------------------------------------------------------
std::optional<MergeDependencies> FindDependencies(const std::shared_ptr<const FileReader>& file,
  const MergeTree& tree, const std::function<bool(double)>& progress)
{
  constexpr double partOfDecoding = 0.3;
  PieceRequest request;
  request.Chunks.resize(file->GetChunks().size());
  std::iota(request.Chunks.begin(), request.Chunks.end(), 0u);
  request.RestoreOrder = false; // the points of the piece have the numbers of the file
  request.Form = file->IsSurface() ? PieceForm::Original : PieceForm::Tetrahedra;
  PieceDecoder decoder(file);
  decoder.SetRequest(request);
  const bool isTetrahedral = decoder.IsTetrahedral();
  PieceCells cells(isTetrahedral, static_cast<std::size_t>(decoder.GetNumberOfCells()),
    static_cast<std::size_t>(decoder.GetConnectivitySize()),
    static_cast<std::size_t>(decoder.GetFacesSize()));
  const PieceTarget target = cells.GetTarget();
  decoder.Fill(target, [&](double done) { return !progress || progress(partOfDecoding * done); });
  decoder.Forget();
  MeshInput mesh;
  mesh.Points = file->GetNumberOfPoints();
  mesh.Cells = cells.GetNumber();
  mesh.Connectivity = target.Connectivity;
  mesh.WideIds = target.WideIds;
  mesh.Types = isTetrahedral ? nullptr : target.Types;
  mesh.Offsets = isTetrahedral ? nullptr : target.Offsets;
  return FindDependencies(MeshAccess(mesh), tree, file->IsSurface(),
    [&](double done)
    { return !progress || progress(partOfDecoding + (1 - partOfDecoding) * done); });
}
}
