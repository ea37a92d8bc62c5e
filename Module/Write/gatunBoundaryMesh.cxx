// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunBoundaryMesh.h"

#include "gatunCellShapes.h"
#include "gatunGatherTuples.h"
#include "gatunParallel.h"

#include <algorithm>
#include <array>
#include <span>

namespace gatun
{
namespace
{
/** The faces of all chunks that only one cell of the mesh has, by their cells. */
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
  std::vector<std::vector<BoundaryFace>> open(layout.GetChunkCount());
  ParallelFor(open.size(),
    [&](std::size_t c)
    {
      const auto first = layout.ChunkStart[c];
      open[c] = FindOpenFaces(
        mesh, std::span(layout.Cells).subspan(first, layout.ChunkStart[c + 1] - first),
        [](std::uint32_t point) { return point; },
        [&](std::uint32_t point) -> bool { return shared[point]; });
    });
  std::vector<BoundaryFace> faces;
  for (auto& some : open)
  {
    faces.insert(faces.end(), some.begin(), some.end());
    some = {};
  }
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
  this->Offsets.push_back(0);
  this->AddCells(mesh, FindFaces(mesh, layout));
  this->AddPoints(mesh);
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
  const auto add = [&](SurfaceList list, std::uint32_t cell)
  {
    this->Types.push_back(GetSurfaceCell(list, static_cast<std::int64_t>(corners.size())));
    this->Connectivity.insert(this->Connectivity.end(), corners.begin(), corners.end());
    this->Offsets.push_back(static_cast<std::int64_t>(this->Connectivity.size()));
    this->Cells.push_back(cell);
  };
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    const auto list = static_cast<SurfaceList>(i);
    for (const auto cell : cells[i])
    {
      FindSurfaceCell(mesh, cell, corners);
      add(list, cell);
    }
    for (std::size_t f = 0; list == SurfaceList::Polygons && f < faces.size(); ++f)
    {
      FindCorners(mesh, faces[f], corners);
      add(list, faces[f].Cell);
    }
  }
}

//------------------------------------------------------------------------------
/** Numbers the points of the cells anew. */
void BoundaryMesh::AddPoints(const MeshAccess& mesh)
{
  const MeshInput& input = mesh.GetMesh();
  constexpr std::int64_t none = -1;
  std::vector<std::int64_t> places(static_cast<std::size_t>(input.Points), none);
  for (const auto point : this->Connectivity)
  {
    places[static_cast<std::size_t>(point)] = 0;
  }
  for (std::size_t point = 0; point < places.size(); ++point)
  {
    if (places[point] != none)
    {
      places[point] = static_cast<std::int64_t>(this->Points.size());
      this->Points.push_back(static_cast<std::uint32_t>(point));
    }
  }
  for (auto& point : this->Connectivity)
  {
    point = places[static_cast<std::size_t>(point)];
  }
  this->Coordinates =
    this->Gather(input.Coordinates, Association::Point, 3 * SizeOf(this->CoordinateType));
}

//------------------------------------------------------------------------------
MeshInput BoundaryMesh::GetInput() const
{
  MeshInput input;
  input.Points = this->Points.size();
  input.CoordinateType = this->CoordinateType;
  input.Coordinates = this->Coordinates.data();
  input.Cells = this->Cells.size();
  input.Connectivity = this->Connectivity.data();
  input.Types = this->Types.data();
  input.Offsets = this->Offsets.data();
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
  if (!std::all_of(this->Types.begin(), this->Types.end(), isSimple))
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
  for (const Merge& merge : whole.GetMerges())
  {
    if (places[merge.Point] == none)
    {
      continue;
    }
    if (places[merge.Into] == none)
    {
      return {};
    }
    merges.push_back({ places[merge.Point], places[merge.Into], merge.Error });
  }
  return MergeTree(static_cast<std::uint32_t>(this->Points.size()), std::move(merges));
}

//------------------------------------------------------------------------------
Bytes BoundaryMesh::Gather(const void* values, Association where, std::size_t tupleBytes) const
{
  return GatherTuples(values, where == Association::Point ? this->Points : this->Cells, tupleBytes);
}
}
