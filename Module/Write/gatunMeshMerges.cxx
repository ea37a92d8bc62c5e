// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunMeshMerges.h"

#include "gatunCellShapes.h"
#include "gatunError.h"
#include "gatunMergeBuilder.h"
#include "gatunMeshAccess.h"
#include "gatunMeshCheck.h"
#include "gatunMeshTets.h"
#include "gatunSurfaceCells.h"
#include "gatunSurfaceMergeBuilder.h"
#include "gatunWithType.h"

#include <algorithm>
#include <string>
#include <utility>

namespace gatun
{
namespace
{
std::vector<std::array<double, 3>> ListPoints(const MeshInput& mesh)
{
  const MeshAccess access(mesh);
  std::vector<std::array<double, 3>> points(static_cast<std::size_t>(mesh.Points));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      points[i][axis] = access.GetCoordinate(i, axis);
    }
  }
  return points;
}

[[noreturn]] void RefuseCell(std::uint64_t cell, SurfaceList list, std::uint64_t points)
{
  ThrowInvalid("the hierarchy of a surface is one of triangles, and cell " + std::to_string(cell) +
    " is a " +
    (list == SurfaceList::Strips ? "triangle strip"
                                 : "polygon with " + std::to_string(points) + " points") +
    "; divide the surface into triangles first, with 'gtn pack --triangles' or vtkTriangleFilter");
}
}

//------------------------------------------------------------------------------
std::vector<double> FindDefaultWeights(const std::vector<ArrayDescription>& arrays)
{
  const auto isOfPoints = [](const ArrayDescription& array)
  { return array.Where == Association::Point; };
  const auto isActive = [&](const ArrayDescription& array)
  { return isOfPoints(array) && (array.AttributeRoles & 1u) != 0; };
  const bool anyActive = std::any_of(arrays.begin(), arrays.end(), isActive);
  std::vector<double> weights;
  for (const ArrayDescription& array : arrays)
  {
    weights.push_back((anyActive ? isActive(array) : isOfPoints(array)) ? 1 : 0);
  }
  return weights;
}

//------------------------------------------------------------------------------
MeshMerges::MeshMerges(const MeshInput& mesh)
  : MeshMerges(ListPoints(mesh))
{
}

//------------------------------------------------------------------------------
void MeshMerges::AddField(std::vector<double> values, double weight)
{
  this->Values.push_back(std::move(values));
  this->Weights.push_back(weight);
}

//------------------------------------------------------------------------------
void MeshMerges::AddArray(
  ScalarType type, const void* values, std::uint32_t components, double weight)
{
  const auto count = static_cast<int>(components);
  for (int component = 0; component < count; ++component)
  {
    std::vector<double> field(this->Points.size());
    WithComponent(type, values, components, component,
      [&](auto&& getValue)
      {
        for (std::size_t i = 0; i < field.size(); ++i)
        {
          field[i] = getValue(i);
        }
      });
    this->AddField(std::move(field), weight / components);
  }
}

//------------------------------------------------------------------------------
template <std::size_t Corners>
BasicMergeInput<Corners> MeshMerges::GetInput(
  std::span<const std::array<std::uint32_t, Corners>> cells,
  std::span<const std::uint8_t> isKept) const
{
  BasicMergeInput<Corners> input{ this->Points, cells, {}, isKept };
  for (std::size_t i = 0; i < this->Values.size(); ++i)
  {
    input.Fields.push_back({ this->Values[i], this->Weights[i] });
  }
  return input;
}

//------------------------------------------------------------------------------
MergeTree MeshMerges::Build(const MeshInput& mesh, const MergeSettings& settings,
  const Progress& progress, std::span<const std::uint8_t> isKept) const
{
  const MeshAccess access(mesh);
  CheckCells(access);
  std::vector<MergeTree::Tet> cells;
  cells.reserve(static_cast<std::size_t>(access.EstimateTets()));
  ForEachTet(access, [&](std::uint64_t, const MergeTree::Tet& tet) { cells.push_back(tet); });
  return BuildMergeTree(this->GetInput<4>(cells, isKept), settings, progress);
}

//------------------------------------------------------------------------------
MergeTree MeshMerges::BuildSurface(
  const MeshInput& mesh, const SurfaceMergeSettings& settings, const Progress& progress) const
{
  const MeshAccess access(mesh);
  CheckCells(access);
  std::vector<std::array<std::uint32_t, 3>> triangles;
  triangles.reserve(static_cast<std::size_t>(mesh.Cells));
  std::vector<std::uint8_t> isMarked(static_cast<std::size_t>(mesh.Points), 0);
  for (std::uint64_t cell = 0; cell < mesh.Cells; ++cell)
  {
    const auto begin = access.GetBegin(cell);
    const auto end = access.GetEnd(cell);
    const int type = access.GetType(cell);
    const auto id = [&](std::uint64_t i) { return static_cast<std::uint32_t>(access.GetId(i)); };
    if (type == TriangleType)
    {
      triangles.push_back({ id(begin), id(begin + 1), id(begin + 2) });
      continue;
    }
    if (const SurfaceList list = GetSurfaceList(type);
        list == SurfaceList::Polygons || list == SurfaceList::Strips)
    {
      RefuseCell(cell, list, end - begin);
    }
    for (auto i = begin; i < end; ++i)
    {
      isMarked[id(i)] = 1;
    }
  }
  return this->BuildSurface(triangles, settings, progress, isMarked);
}

//------------------------------------------------------------------------------
MergeTree MeshMerges::BuildSurface(std::span<const std::array<std::uint32_t, 3>> triangles,
  const SurfaceMergeSettings& settings, const Progress& progress,
  std::span<const std::uint8_t> isKept) const
{
  return BuildMergeTree(this->GetInput<3>(triangles, isKept), settings, progress);
}
}
