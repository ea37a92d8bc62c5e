// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunMeshDependencies.h"

#include "gatunFileReader.h"
#include "gatunMeshTets.h"
#include "gatunPieceCells.h"
#include "gatunPieceDecoder.h"

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace gatun
{
//------------------------------------------------------------------------------
MergeDependencies FindDependencies(const MeshAccess& mesh, const MergeTree& tree, bool isSurface,
  const std::function<bool(double)>& progress)
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
    return { tree, std::span<const MergeTree::Triangle>(triangles), progress };
  }
  std::vector<MergeTree::Tet> tets;
  tets.reserve(static_cast<std::size_t>(mesh.EstimateTets()));
  ForEachTet(mesh, [&](std::uint64_t, const MergeTree::Tet& tet) { tets.push_back(tet); });
  return { tree, std::span<const MergeTree::Tet>(tets), progress };
}

//------------------------------------------------------------------------------
MergeDependencies FindDependencies(const std::shared_ptr<const FileReader>& file,
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
