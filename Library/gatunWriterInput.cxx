// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunWriterInput.h"

#include "gatunCellShapes.h"
#include "gatunError.h"
#include "gatunMeshAccess.h"
#include "gatunMeshCheck.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <span>
#include <utility>

namespace gatun
{
namespace
{
/** Takes the types from a mesh of tetrahedra alone, or of no cells. */
void DropTypes(MeshInput& mesh)
{
  const MeshAccess access(mesh);
  const std::span<const std::uint8_t> types(mesh.Types, mesh.Cells);
  const auto isTetra = [](std::uint8_t type) { return type == TetraType; };
  if (access.GetBegin(0) == 0 && std::all_of(types.begin(), types.end(), isTetra))
  {
    mesh.Types = nullptr;
    mesh.Offsets = nullptr;
    mesh.FaceLocations = nullptr;
    mesh.Faces = nullptr;
    mesh.FacesSize = 0;
  }
}
}

//------------------------------------------------------------------------------
MeshInput TakeMesh(const gatun_mesh& from)
{
  MeshInput mesh;
  mesh.Points = from.points;
  mesh.CoordinateType = TakeType(from.coordinate_type);
  Need(IsFloating(mesh.CoordinateType), "coordinates have to be float32 or float64");
  mesh.Coordinates = from.coordinates;
  mesh.Cells = from.cells;
  mesh.Connectivity = from.connectivity;
  mesh.WideIds = from.wide_ids != 0;
  mesh.Types = from.types;
  mesh.Offsets = from.offsets;
  mesh.FaceLocations = from.face_locations;
  mesh.Faces = from.faces;
  mesh.FacesSize = from.faces_size;
  Need(mesh.Points == 0 || mesh.Coordinates, "the mesh has no coordinates");
  Need(mesh.Cells == 0 || mesh.Connectivity, "the mesh has no connectivity");
  Need(!mesh.Types == !mesh.Offsets, "types and offsets come together");
  Need(!mesh.FaceLocations == !mesh.Faces, "faces and their locations come together");
  const MeshAccess access(mesh);
  CheckCells(access);
  CheckCellSizes(access);
  if (mesh.Types && (mesh.Cells == 0 || !from.is_surface))
  {
    DropTypes(mesh);
  }
  if (from.point_array)
  {
    const auto array = Take(from.point_array);
    if (array.name)
    {
      mesh.PointArray.Name = array.name;
    }
    mesh.PointArray.ComponentNames = TakeTexts(array.component_names, 3);
    mesh.PointArray.Keys = TakeKeys(array.keys, array.key_count);
  }
  return mesh;
}

//------------------------------------------------------------------------------
TakenArrays::TakenArrays(const gatun_array* arrays, std::size_t count)
{
  Need(arrays || count == 0, "the descriptions of the arrays are missing");
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto from = TakeElement(arrays, i);
    this->List.push_back(TakeArray(from));
    this->Errors.emplace_back(from.error ? from.error : "");
    this->Weights.push_back(from.weight);
    this->Values.push_back(from.values);
  }
}

//------------------------------------------------------------------------------
void TakenArrays::SetList(const std::vector<ArrayDescription>& list)
{
  const auto isSame = [](const ArrayDescription& one, const ArrayDescription& other)
  {
    return one.Name == other.Name && one.Where == other.Where && one.Type == other.Type &&
      one.Components == other.Components;
  };
  Need(this->List.empty() ||
      std::equal(this->List.begin(), this->List.end(), list.begin(), list.end(), isSame),
    "the arrays are not those of the file, in its order");
  this->List = list;
  this->Errors.resize(list.size());
  this->Weights.resize(list.size());
  this->Values.resize(list.size());
}

//------------------------------------------------------------------------------
std::vector<ArrayError> TakenArrays::MakeErrors(const char* everything) const
{
  std::vector<ArrayError> errors;
  if (everything && *everything)
  {
    errors.push_back(ParseError(std::string("*=") + everything));
  }
  std::map<std::string, std::string> bounds;
  for (std::size_t i = 0; i < this->List.size(); ++i)
  {
    const auto& name = this->List[i].Name;
    const auto [found, isNew] = bounds.emplace(name, this->Errors[i]);
    Need(
      found->second == this->Errors[i], "arrays of the same name have different bounds of errors");
    if (isNew && !this->Errors[i].empty())
    {
      Need(name != "*", "an array with the name '*' has to be exact");
      errors.push_back(ParseError(name + "=" + this->Errors[i]));
    }
  }
  return errors;
}

//------------------------------------------------------------------------------
/** Adds the fields that a hierarchy preserves: see gatun_array::weight. */
void TakenArrays::AddFields(MeshMerges& merges, std::span<const void* const> values) const
{
  const auto isField = [&](std::size_t i)
  { return this->List[i].Where == Association::Point && values[i]; };
  const auto weights = this->FindWeights();
  for (std::size_t i = 0; i < this->List.size(); ++i)
  {
    Need(isField(i) || !(this->Weights[i] > 0),
      "an array with a weight in the hierarchy has no values of points");
    if (isField(i) && weights[i] > 0)
    {
      merges.AddArray(this->List[i].Type, values[i], this->List[i].Components, weights[i]);
    }
  }
}

//------------------------------------------------------------------------------
std::vector<double> TakenArrays::FindWeights() const
{
  const bool any = std::any_of(
    this->Weights.begin(), this->Weights.end(), [](double weight) { return weight > 0; });
  return any ? this->Weights : FindDefaultWeights(this->List);
}

//------------------------------------------------------------------------------
MergeTree TakenArrays::BuildTree(const MeshInput& mesh, bool isSurface,
  std::span<const void* const> values, const MeshMerges::Progress& progress) const
{
  MeshMerges merges(mesh);
  this->AddFields(merges, values);
  return isSurface ? merges.BuildSurface(mesh, {}, progress) : merges.Build(mesh, {}, progress);
}

//------------------------------------------------------------------------------
WriterOptions TakeOptions(const gatun_options& from, const TakenArrays& arrays)
{
  Need((from.keep_order & ~std::uint32_t{ KeepAll }) == 0, "there is no such order to keep");
  Need(from.profile == GATUN_FAST || from.profile == GATUN_SMALL, "there is no such profile");
  Need(from.layers >= GATUN_NO_LAYERS && from.layers <= GATUN_HISTOGRAM,
    "there is no such spacing of layers");
  WriterOptions options;
  options.Keep = static_cast<std::uint8_t>(from.keep_order);
  options.Coding = from.profile == GATUN_SMALL ? Profile::Small : Profile::Fast;
  options.ChunkSize = from.chunk_size;
  options.Parts = std::max(from.parts, 1u);
  options.KeyStepInterval =
    from.key_step_interval > 0 ? from.key_step_interval : options.KeyStepInterval;
  options.PointsMove = from.points_move != 0;
  options.Boundary = from.boundary != 0;
  options.Levels = from.levels;
  options.Dependencies = from.dependencies != 0;
  options.Errors = arrays.MakeErrors(from.error);
  if (from.layers != GATUN_NO_LAYERS)
  {
    Need(from.layer_array < arrays.GetList().size(), "there is no array for the layers");
    options.Layers = LayerRequest{ from.layer_array, from.layer_component, from.layer_count,
      static_cast<LayerSpacing>(from.layers), nullptr };
  }
  return options;
}

//------------------------------------------------------------------------------
FieldData TakeFields(const gatun_field* fields, std::size_t count)
{
  FieldData data;
  Need(fields || count == 0, "the field data are missing");
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto from = TakeElement(fields, i);
    NeedPointers(from.name);
    FieldArray field;
    field.Name = from.name;
    field.VTKType = from.vtk_type;
    field.Components = std::max(from.components, 1u);
    field.ComponentNames = TakeTexts(from.component_names, field.Components);
    field.Keys = TakeKeys(from.keys, from.key_count);
    field.IsText = from.texts != nullptr;
    Need(field.IsText || from.values || from.count == 0, "a field array has no values");
    for (std::uint64_t k = 0; field.IsText && k < from.count; ++k)
    {
      const char* const text = from.texts[k] ? from.texts[k] : "";
      field.Texts.emplace_back(
        text, from.text_bytes ? static_cast<std::size_t>(from.text_bytes[k]) : std::strlen(text));
    }
    if (!field.IsText)
    {
      field.Type = TakeType(from.type);
      const auto* const bytes = static_cast<const std::uint8_t*>(from.values);
      field.Values.assign(bytes, bytes + Product(from.count, SizeOf(field.Type)));
    }
    data.push_back(std::move(field));
  }
  return data;
}

//------------------------------------------------------------------------------
std::vector<const void*> TakeValues(const gatun_values& from,
  const std::vector<ArrayDescription>& arrays, std::uint64_t points, std::uint64_t cells)
{
  Need(from.array_count == arrays.size(), "the step has not as many arrays as the file");
  Need(from.arrays || arrays.empty(), "the values of the arrays are missing");
  std::vector<const void*> values;
  for (std::size_t i = 0; i < arrays.size(); ++i)
  {
    const auto& array = arrays[i];
    const auto tuples = array.Where == Association::Point ? points : cells;
    const auto bytes = Product(tuples, Product(array.Components, SizeOf(array.Type)));
    if (from.arrays[i].bytes != bytes || (bytes > 0 && !from.arrays[i].data))
    {
      ThrowInvalid("array '" + array.Name + "' has " + std::to_string(from.arrays[i].bytes) +
        " bytes of values, and needs " + std::to_string(bytes));
    }
    values.push_back(from.arrays[i].data);
  }
  return values;
}

//------------------------------------------------------------------------------
RemainingCells TakeRemaining(const gatun_values& from)
{
  RemainingCells remaining;
  remaining.Cells = { from.remaining_cells, static_cast<std::size_t>(from.remaining_cell_count) };
  remaining.DropsPoints = from.drops_points != 0;
  if (remaining.DropsPoints)
  {
    Need(from.remaining_points || from.remaining_point_count == 0,
      "the numbers of the remaining points are missing");
    remaining.Points = { from.remaining_points,
      static_cast<std::size_t>(from.remaining_point_count) };
  }
  return remaining;
}
}
