// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunMergeGrid.h"

#include "gatunBridgedMesh.h"
#include "gatunCellShapes.h"
#include "gatunError.h"
#include "gatunMeshCheck.h"
#include "gatunMeshTets.h"
#include "gatunSurfaceCells.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <vector>

namespace gatun
{
namespace
{
/** The points and weighted fields of a mesh as input of the core. */
struct MergePoints
{
  std::vector<std::array<double, 3>> Points;
  std::vector<std::vector<double>> Values;
  std::vector<double> Weights;

  explicit MergePoints(vtkPointSet* mesh)
    : Points(static_cast<std::size_t>(mesh->GetNumberOfPoints()))
  {
    for (std::size_t i = 0; i < this->Points.size(); ++i)
    {
      mesh->GetPoint(static_cast<vtkIdType>(i), this->Points[i].data());
    }
  }

  void AddArray(vtkDataArray* array, double weight)
  {
    const int components = array->GetNumberOfComponents();
    for (int c = 0; c < components; ++c)
    {
      auto& values = this->Values.emplace_back(this->Points.size());
      for (std::size_t i = 0; i < values.size(); ++i)
      {
        values[i] = array->GetComponent(static_cast<vtkIdType>(i), c);
      }
      this->Weights.push_back(weight / components);
    }
  }

  template <std::size_t Corners>
  BasicMergeInput<Corners> GetInput(std::span<const std::array<std::uint32_t, Corners>> cells,
    std::span<const std::uint8_t> isKept) const
  {
    BasicMergeInput<Corners> input{ this->Points, cells, {}, isKept };
    for (std::size_t i = 0; i < this->Values.size(); ++i)
    {
      input.Fields.push_back({ this->Values[i], this->Weights[i] });
    }
    return input;
  }
};

void AddArrays(vtkPointData* data, const MergeWeights& weights, MergePoints& points)
{
  for (const auto& [name, weight] : weights.GetAll())
  {
    vtkDataArray* const array = data->GetArray(name.c_str());
    if (!array)
    {
      ThrowInvalid("there is no point array '" + name + "', which has a weight");
    }
    points.AddArray(array, weight);
  }
  if (!weights.GetAll().empty())
  {
    return;
  }
  if (data->GetScalars())
  {
    points.AddArray(data->GetScalars(), 1);
    return;
  }
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    if (vtkDataArray* const array = data->GetArray(i))
    {
      points.AddArray(array, 1);
    }
  }
}
}

//------------------------------------------------------------------------------
bool MergeWeights::Set(const char* name, double weight)
{
  weight = weight < 0 ? 0 : weight; // NaN stays, and is refused later
  if (!name || (this->Weights.count(name) && this->Weights[name] == weight))
  {
    return false;
  }
  this->Weights[name] = weight;
  return true;
}

//------------------------------------------------------------------------------
bool MergeWeights::Clear()
{
  const bool hadAny = !this->Weights.empty();
  this->Weights.clear();
  return hadAny;
}

//------------------------------------------------------------------------------
double MergeWeights::Get(const char* name) const
{
  const auto found = name ? this->Weights.find(name) : this->Weights.end();
  return found == this->Weights.end() ? 0 : found->second;
}

//------------------------------------------------------------------------------
void MergeWeights::Print(std::ostream& os, vtkIndent indent) const
{
  for (const auto& [name, weight] : this->Weights)
  {
    os << indent << "Weight of " << name << ": " << weight << "\n";
  }
}

//------------------------------------------------------------------------------
MergeTree BuildMergeTree(vtkUnstructuredGrid* tets, const MergeWeights& weights,
  const MergeSettings& settings, const std::function<bool(double)>& progress,
  std::span<const std::uint8_t> isKept)
{
  MergePoints points(tets);
  AddArrays(tets->GetPointData(), weights, points);
  const BridgedMesh mesh(tets);
  const MeshAccess access(mesh.Mesh);
  CheckCells(access);
  std::vector<MergeTree::Tet> cells;
  cells.reserve(static_cast<std::size_t>(access.EstimateTets()));
  ForEachTet(access, [&](std::uint64_t, const MergeTree::Tet& tet) { cells.push_back(tet); });
  return BuildMergeTree(points.GetInput<4>(cells, isKept), settings, progress);
}

//------------------------------------------------------------------------------
MergeTree BuildMergeTree(vtkPointSet* surface,
  std::span<const std::array<std::uint32_t, 3>> triangles, const MergeWeights& weights,
  const SurfaceMergeSettings& settings, const std::function<bool(double)>& progress,
  std::span<const std::uint8_t> isKept)
{
  MergePoints points(surface);
  AddArrays(surface->GetPointData(), weights, points);
  return BuildMergeTree(points.GetInput<3>(triangles, isKept), settings, progress);
}

//------------------------------------------------------------------------------
MergeTree BuildSurfaceMergeTree(vtkUnstructuredGrid* surface, const MergeWeights& weights,
  const SurfaceMergeSettings& settings, const std::function<bool(double)>& progress)
{
  std::vector<std::array<std::uint32_t, 3>> triangles;
  triangles.reserve(static_cast<std::size_t>(surface->GetNumberOfCells()));
  std::vector<std::uint8_t> isMarked(static_cast<std::size_t>(surface->GetNumberOfPoints()), 0);
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    surface->GetCellPoints(cell, count, ids);
    const int type = surface->GetCellType(cell);
    if (type == TriangleType)
    {
      triangles.push_back({ static_cast<std::uint32_t>(ids[0]), static_cast<std::uint32_t>(ids[1]),
        static_cast<std::uint32_t>(ids[2]) });
      continue;
    }
    if (const SurfaceList list = GetSurfaceList(type);
        list == SurfaceList::Polygons || list == SurfaceList::Strips)
    {
      ThrowInvalid("the hierarchy of a surface is one of triangles, and cell " +
        std::to_string(cell) + " is a " +
        (list == SurfaceList::Strips ? "triangle strip"
                                     : "polygon with " + std::to_string(count) + " points") +
        "; divide the surface into triangles first, with 'gtn pack --triangles' or "
        "vtkTriangleFilter");
    }
    for (vtkIdType i = 0; i < count; ++i)
    {
      isMarked[static_cast<std::size_t>(ids[i])] = 1;
    }
  }
  return BuildMergeTree(surface, triangles, weights, settings, progress, isMarked);
}
}
