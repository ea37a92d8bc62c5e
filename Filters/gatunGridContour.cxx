// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunGridContour.h"

#include "gatunArrayBridge.h"
#include "gatunBridgedMesh.h"
#include "gatunError.h"
#include "gatunGhosts.h"
#include "gatunSurface.h"
#include "gatunSurfaceOutput.h"
#include "gatunTetInput.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

namespace gatun
{
namespace
{
/** The arrays of a grid as the surface takes them. */
class GridArrays
{
public:
  GridArrays(vtkUnstructuredGrid* grid, const ContourSettings& settings, SurfaceInput& input,
    SurfaceOutput& content)
    : Settings(settings)
    , Input(input)
    , Content(content)
  {
    this->Add(grid->GetPointData(), Association::Point);
    this->Add(grid->GetCellData(), Association::Cell);
    if (!this->HasScalars)
    {
      settings.Array.Fail();
    }
  }

private:
  void Add(vtkDataSetAttributes* attributes, Association where)
  {
    for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* const array = attributes->GetArray(i);
      if (!array)
      {
        continue; // strings cannot be interpolated
      }
      BridgedArray& bridged = this->Owners.emplace_back(Bridge(array, where));
      ArrayDescription& description = bridged.Description;
      description.AttributeRoles = AttributeRolesOf(attributes, array);
      const TupleView view{ bridged.Values, description.Type, description.Components };
      const bool isContoured = !this->HasScalars && this->Settings.Array.IsThis(description);
      if (isContoured)
      {
        this->SetScalars(description, view);
      }
      if (this->Settings.Carries(description, isContoured))
      {
        auto& views =
          where == Association::Point ? this->Input.PointArrays : this->Input.CellArrays;
        views.push_back(view);
        this->Content.Arrays.push_back(description);
      }
    }
  }

  void SetScalars(const ArrayDescription& description, const TupleView& view)
  {
    this->HasScalars = true;
    const int component = this->Settings.ChooseComponent(description);
    if (component >= static_cast<int>(description.Components))
    {
      ThrowInvalid("array '" + description.Name + "' has no component " +
        std::to_string(this->Settings.Component));
    }
    SetMarchValues(this->Input.Mesh, view, static_cast<std::size_t>(this->Input.Mesh.Points),
      component, this->Converted);
  }

  const ContourSettings& Settings;
  SurfaceInput& Input;
  SurfaceOutput& Content;
  std::vector<BridgedArray> Owners;
  std::vector<double> Converted;
  bool HasScalars = false;
};

/** The surfaces in a grid of tetrahedra, part by part. */
std::vector<SurfacePart> MakeParts(vtkUnstructuredGrid* tets, const ContourSettings& settings,
  const ContourProgress& progress, SurfaceOutput& content)
{
  const BridgedMesh mesh(tets);
  if (mesh.Mesh.Points >= 0xffffffffu || mesh.Mesh.Cells >= 0xffffffffu)
  {
    ThrowInvalid("a mesh of more than 2^32 points or cells is too large");
  }
  SurfaceInput input;
  input.Mesh.Points = mesh.Mesh.Points;
  input.Mesh.Connectivity = mesh.Mesh.Connectivity;
  input.Mesh.WideIds = mesh.Mesh.WideIds;
  input.Points = { mesh.Mesh.Coordinates, mesh.Mesh.CoordinateType, 3 };
  content = {};
  const GridArrays arrays(tets, settings, input, content);
  content.CoordinateType = settings.ChoosePrecision(mesh.Mesh.CoordinateType);
  content.Normals = settings.ComputeNormals;
  content.Strips = settings.OutputStrips;

  SurfaceOptions options;
  options.Values = settings.Values;
  options.CoordinateType = content.CoordinateType;
  options.Normals = settings.ComputeNormals;
  return MakeSurfaceParts(input, options, mesh.Mesh.Cells, progress);
}

/** The ghost cells of a grid as a grid without ghost cells, or null if there are none. */
vtkSmartPointer<vtkUnstructuredGrid> TakeGhosts(vtkUnstructuredGrid* grid)
{
  constexpr auto duplicate = vtkDataSetAttributes::DUPLICATECELL;
  vtkUnsignedCharArray* const marks = GhostsWith(grid->GetCellData(), duplicate);
  if (!marks)
  {
    return nullptr;
  }
  vtkNew<vtkUnsignedCharArray> others;
  others->DeepCopy(marks);
  others->SetName(vtkDataSetAttributes::GhostArrayName());
  for (vtkIdType cell = 0; cell < others->GetNumberOfValues(); ++cell)
  {
    others->SetValue(cell, static_cast<unsigned char>(marks->GetValue(cell) ^ duplicate));
  }
  vtkNew<vtkUnstructuredGrid> turned;
  turned->ShallowCopy(grid);
  turned->GetCellData()->AddArray(others);
  return MakeTetInput(turned).Grid;
}
}

//------------------------------------------------------------------------------
std::vector<std::string> ContourGrid(vtkUnstructuredGrid* grid, const ContourSettings& settings,
  const ContourProgress& progress, vtkPolyData* output)
{
  if (grid->GetNumberOfCells() == 0)
  {
    return {}; // such as an empty piece, which need not have any arrays
  }
  auto tets = MakeTetInput(grid);
  SurfaceOutput content;
  auto parts = MakeParts(tets.Grid, settings, progress, content);
  // Where the surface goes on in other pieces, normals are made of the tetrahedra on both sides.
  const auto around = settings.ComputeNormals ? TakeGhosts(grid) : nullptr;
  std::vector<std::size_t> ghosts;
  if (around && around->GetNumberOfCells() > 0)
  {
    for (auto& part : MakeParts(around, settings, progress, content))
    {
      ghosts.push_back(parts.size());
      parts.push_back(std::move(part));
    }
  }
  FillPolyData(Surface(std::move(parts), content.CoordinateType, ghosts), content, output);
  return std::move(tets.Warnings);
}
}
