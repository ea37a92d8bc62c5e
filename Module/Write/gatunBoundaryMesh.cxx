// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunBoundaryMesh.h"

#include "gatunCellShapes.h"
#include "gatunGatherTuples.h"
#include "gatunParallel.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

namespace gatun
{
//------------------------------------------------------------------------------
WriterOptions MakeBoundaryOptions(const WriterOptions& whole, const MergeTree* tree)
{
  WriterOptions options = whole;
  options.Keep = KeepNone;
  options.Tree = tree;
  options.Levels = 0;
  options.LevelMerges.clear();
  options.Layers.reset();
  options.Boundary = false;
  options.IsSurface = true;
  return options;
}

//------------------------------------------------------------------------------
std::vector<BoundaryFace> FindFacesOfChunks(const MeshAccess& mesh, const Partition& layout,
  const std::function<std::uint32_t(std::uint32_t)>& numberOf,
  const std::function<bool(std::uint32_t)>& isShared)
{
  std::vector<std::vector<BoundaryFace>> open(layout.GetChunkCount());
  ParallelFor(open.size(),
    [&](std::size_t c) { open[c] = FindOpenFaces(mesh, layout.GetCells(c), numberOf, isShared); });
  std::vector<BoundaryFace> faces;
  for (auto& some : open)
  {
    faces.insert(faces.end(), some.begin(), some.end());
    some = {};
  }
  return faces;
}

//------------------------------------------------------------------------------
void BoundaryCells::Add(
  SurfaceList list, std::uint32_t cell, std::span<const std::uint32_t> corners)
{
  this->Types.push_back(GetSurfaceCell(list, static_cast<std::int64_t>(corners.size())));
  this->Connectivity.insert(this->Connectivity.end(), corners.begin(), corners.end());
  this->Offsets.push_back(static_cast<std::int64_t>(this->Connectivity.size()));
  this->Cells.push_back(cell);
}

namespace
{
/** The faces that only one cell of the mesh has, by their cells. */
std::vector<BoundaryFace> FindFaces(const MeshAccess& mesh, const Partition& layout)
{
  std::vector<bool> shared(static_cast<std::size_t>(mesh.GetMesh().Points), false);
  for (const auto& group : layout.SharedPoints)
  {
    for (const auto point : group.second)
    {
      shared[point] = true;
    }
  }
  auto faces = FindFacesOfChunks(
    mesh, layout, [](std::uint32_t point) { return point; },
    [&](std::uint32_t point) -> bool { return shared[point]; });
  KeepSingleFaces(faces);
  std::sort(faces.begin(), faces.end(),
    [](const auto& a, const auto& b)
    { return a.Cell != b.Cell ? a.Cell < b.Cell : a.Number < b.Number; });
  return faces;
}
}

//------------------------------------------------------------------------------
BoundaryMesh::BoundaryMesh(const MeshAccess& mesh, const Partition& layout)
  : CoordinateType(mesh.GetMesh().CoordinateType)
{
  this->AddCells(mesh, FindFaces(mesh, layout));
  this->AddPoints(mesh.GetMesh().Points);
  this->Coordinates =
    this->Gather(mesh.GetMesh().Coordinates, Association::Point, 3 * SizeOf(this->CoordinateType));
}

//------------------------------------------------------------------------------
BoundaryMesh::BoundaryMesh(BoundaryCells cells, std::uint64_t points, ScalarType type,
  const std::function<Bytes(std::span<const std::uint32_t>)>& getCoordinates)
  : CoordinateType(type)
  , Faces(std::move(cells))
{
  this->AddPoints(points);
  this->Coordinates = getCoordinates(this->Points);
}

//------------------------------------------------------------------------------
/** Adds cells with the points of the whole mesh. */
void BoundaryMesh::AddCells(const MeshAccess& mesh, std::vector<BoundaryFace> faces)
{
  std::array<std::vector<std::uint32_t>, SurfaceLists> cells; // of a lower dimension
  std::vector<std::uint32_t> corners;
  for (std::uint32_t cell = 0; !mesh.IsTetrahedral() && cell < mesh.GetMesh().Cells; ++cell)
  {
    if (const auto list = FindSurfaceCell(mesh, cell, corners))
    {
      cells[static_cast<std::size_t>(*list)].push_back(cell);
    }
  }
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    const auto list = static_cast<SurfaceList>(i);
    for (const auto cell : cells[i])
    {
      FindSurfaceCell(mesh, cell, corners);
      this->Faces.Add(list, cell, corners);
    }
    for (std::size_t f = 0; list == SurfaceList::Polygons && f < faces.size(); ++f)
    {
      FindCorners(mesh, faces[f], corners);
      this->Faces.Add(list, faces[f].Cell, corners);
    }
  }
}

//------------------------------------------------------------------------------
/** Numbers the points of the cells anew. */
void BoundaryMesh::AddPoints(std::uint64_t points)
{
  constexpr std::uint32_t none = 0xffffffffu;
  std::vector<std::uint32_t> places(static_cast<std::size_t>(points), none);
  for (const auto point : this->Faces.Connectivity)
  {
    places[static_cast<std::size_t>(point)] = 0;
  }
  for (std::uint32_t point = 0; point < places.size(); ++point)
  {
    if (places[point] != none)
    {
      places[point] = static_cast<std::uint32_t>(this->Points.size());
      this->Points.push_back(point);
    }
  }
  for (auto& point : this->Faces.Connectivity)
  {
    point = places[static_cast<std::size_t>(point)];
  }
}

//------------------------------------------------------------------------------
MeshInput BoundaryMesh::GetInput() const
{
  MeshInput input;
  input.Points = this->Points.size();
  input.CoordinateType = this->CoordinateType;
  input.Coordinates = this->Coordinates.data();
  input.Cells = this->Faces.Cells.size();
  input.Connectivity = this->Faces.Connectivity.data();
  input.Types = this->Faces.Types.data();
  input.Offsets = this->Faces.Offsets.data();
  return input;
}

//------------------------------------------------------------------------------
std::optional<MergeTree> BoundaryMesh::MakeTree(const MergeTree& whole) const
{
  const auto isSimple = [](std::uint8_t type)
  {
    const auto list = GetSurfaceList(type);
    return type == TriangleType || list == SurfaceList::Vertices || list == SurfaceList::Lines;
  };
  if (!std::all_of(this->Faces.Types.begin(), this->Faces.Types.end(), isSimple))
  {
    return {};
  }
  constexpr std::uint32_t none = 0xffffffffu;
  std::vector<std::uint32_t> places(whole.GetNumberOfPoints(), none);
  for (std::uint32_t i = 0; i < this->Points.size(); ++i)
  {
    places[this->Points[i]] = i;
  }
  std::vector<Merge> merges;
  std::vector<std::uint32_t> rounds;
  auto round = whole.GetRounds().begin();
  bool begins = false;
  for (std::uint32_t i = 0; i < whole.GetMerges().size(); ++i)
  {
    const Merge& merge = whole.GetMerges()[i];
    if (round != whole.GetRounds().end() && *round == i)
    {
      begins = true;
      ++round;
    }
    if (places[merge.Point] == none)
    {
      continue;
    }
    if (places[merge.Into] == none)
    {
      return {};
    }
    if (std::exchange(begins, false))
    {
      rounds.push_back(static_cast<std::uint32_t>(merges.size()));
    }
    merges.push_back({ places[merge.Point], places[merge.Into], merge.Error });
  }
  return MergeTree(
    static_cast<std::uint32_t>(this->Points.size()), std::move(merges), {}, std::move(rounds));
}

//------------------------------------------------------------------------------
Bytes BoundaryMesh::Gather(const void* values, Association where, std::size_t tupleBytes) const
{
  return GatherTuples(
    values, where == Association::Point ? this->Points : this->Faces.Cells, tupleBytes);
}
}
