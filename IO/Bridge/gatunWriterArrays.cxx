// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunWriterArrays.h"

#include "gatunError.h"

#include "vtkAbstractArray.h"
#include "vtkCellData.h"
#include "vtkDataArraySelection.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace
{

//------------------------------------------------------------------------------
bool IsEnabled(vtkAbstractArray* array, vtkDataArraySelection* selection)
{
  const char* name = array->GetName();
  return !name || !*name || selection->ArrayIsEnabled(name) != 0;
}

} // anonymous namespace

namespace gatun
{

//------------------------------------------------------------------------------
std::vector<BridgedArray> BridgeSelected(
  vtkUnstructuredGrid* grid, vtkDataArraySelection* pointArrays, vtkDataArraySelection* cellArrays)
{
  std::vector<BridgedArray> arrays;
  const auto add =
    [&](vtkDataSetAttributes* attributes, Association where, vtkDataArraySelection* selection)
  {
    for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* array = attributes->GetAbstractArray(i);
      if (IsEnabled(array, selection))
      {
        arrays.push_back(Bridge(array, where));
        arrays.back().Description.AttributeRoles = AttributeRolesOf(attributes, array);
      }
    }
  };
  add(grid->GetPointData(), Association::Point, pointArrays);
  add(grid->GetCellData(), Association::Cell, cellArrays);
  return arrays;
}

//------------------------------------------------------------------------------
LayerRequest FindLayerArray(
  const std::vector<BridgedArray>& arrays, const std::string& name, int component)
{
  bool isOfCells = false;
  for (std::size_t i = 0; i < arrays.size(); ++i)
  {
    const ArrayDescription& array = arrays[i].Description;
    if (array.Name != name)
    {
      continue;
    }
    if (array.Where != Association::Point)
    {
      isOfCells = true;
      continue;
    }
    if (component >= static_cast<int>(array.Components))
    {
      ThrowInvalid("array '" + name + "' has no component " + std::to_string(component) +
        " to make layers of");
    }
    LayerRequest request;
    request.Array = static_cast<std::uint32_t>(i);
    request.Component = array.Components > 1 ? std::max(component, -1) : 0;
    request.Values = arrays[i].Values;
    return request;
  }
  ThrowInvalid(isOfCells ? "layers need a point array, and '" + name + "' is one of cells"
                         : "there is no point array '" + name + "' to make layers of");
}

}
