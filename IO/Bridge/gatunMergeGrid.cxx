// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunMergeGrid.h"

#include "gatunBridgedMesh.h"
#include "gatunError.h"
#include "gatunMeshMerges.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <utility>
#include <vector>

namespace gatun
{
namespace
{
std::vector<std::array<double, 3>> ListPoints(vtkPointSet* mesh)
{
  std::vector<std::array<double, 3>> points(static_cast<std::size_t>(mesh->GetNumberOfPoints()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    mesh->GetPoint(static_cast<vtkIdType>(i), points[i].data());
  }
  return points;
}

void AddArray(vtkDataArray* array, double weight, MeshMerges& merges)
{
  const int components = array->GetNumberOfComponents();
  for (int c = 0; c < components; ++c)
  {
    std::vector<double> values(static_cast<std::size_t>(array->GetNumberOfTuples()));
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      values[i] = array->GetComponent(static_cast<vtkIdType>(i), c);
    }
    merges.AddField(std::move(values), weight / components);
  }
}

[[noreturn]] void ThrowNoArray(const std::string& name)
{
  ThrowInvalid("there is no point array '" + name + "', which has a weight");
}

void AddArrays(vtkPointData* data, const MergeWeights& weights, MeshMerges& merges)
{
  for (const auto& [name, weight] : weights.GetAll())
  {
    vtkDataArray* const array = data->GetArray(name.c_str());
    if (!array)
    {
      ThrowNoArray(name);
    }
    AddArray(array, weight, merges);
  }
  if (!weights.GetAll().empty())
  {
    return;
  }
  if (data->GetScalars())
  {
    AddArray(data->GetScalars(), 1, merges);
    return;
  }
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    if (vtkDataArray* const array = data->GetArray(i))
    {
      AddArray(array, 1, merges);
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
std::vector<double> MergeWeights::Find(const std::vector<ArrayDescription>& arrays) const
{
  if (this->Weights.empty())
  {
    return FindDefaultWeights(arrays);
  }
  std::vector<double> found(arrays.size(), 0);
  for (const auto& [name, weight] : this->Weights)
  {
    const auto array = std::find_if(arrays.begin(), arrays.end(),
      [&, &wanted = name](const ArrayDescription& one)
      { return one.Where == Association::Point && one.Name == wanted; });
    if (array == arrays.end())
    {
      ThrowNoArray(name);
    }
    found[static_cast<std::size_t>(array - arrays.begin())] = weight;
  }
  return found;
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
  const BridgedMesh mesh(tets);
  MeshMerges merges(mesh.Mesh);
  AddArrays(tets->GetPointData(), weights, merges);
  return merges.Build(mesh.Mesh, settings, progress, isKept);
}

//------------------------------------------------------------------------------
MergeTree BuildMergeTree(vtkPointSet* surface,
  std::span<const std::array<std::uint32_t, 3>> triangles, const MergeWeights& weights,
  const SurfaceMergeSettings& settings, const std::function<bool(double)>& progress,
  std::span<const std::uint8_t> isKept)
{
  MeshMerges merges(ListPoints(surface));
  AddArrays(surface->GetPointData(), weights, merges);
  return merges.BuildSurface(triangles, settings, progress, isKept);
}

//------------------------------------------------------------------------------
MergeTree BuildSurfaceMergeTree(vtkUnstructuredGrid* surface, const MergeWeights& weights,
  const SurfaceMergeSettings& settings, const std::function<bool(double)>& progress)
{
  const BridgedMesh mesh(surface);
  MeshMerges merges(mesh.Mesh);
  AddArrays(surface->GetPointData(), weights, merges);
  return merges.BuildSurface(mesh.Mesh, settings, progress);
}
}
