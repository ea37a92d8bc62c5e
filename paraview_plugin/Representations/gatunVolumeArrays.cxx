// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunVolumeArrays.h"

#include "vtkGatunVolumeMapper.h"

#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"

#include <algorithm>

namespace gatun
{
namespace
{
int CountComponents(vtkDataSet* arrays, const ChosenArray& chosen)
{
  vtkDataArray* const array = arrays
    ? arrays->GetAttributes(chosen.OfCells ? vtkDataObject::CELL : vtkDataObject::POINT)
        ->GetArray(chosen.Name.c_str())
    : nullptr;
  return array ? array->GetNumberOfComponents() : 1;
}

/** The component as mappers count it: -1 for the length of the tuple. */
int GetComponent(int chosen, int components)
{
  return chosen >= 0 && chosen < components ? chosen : components > 1 ? -1 : 0;
}

int GetColorComponent(vtkColorTransferFunction* colors, int components)
{
  if (components == 1)
  {
    return 0;
  }
  return colors->GetVectorMode() == vtkScalarsToColors::COMPONENT
    ? std::clamp(colors->GetVectorComponent(), 0, components - 1)
    : -1;
}

void SelectScalars(vtkGatunVolumeMapper* mapper, const ChosenArray& array, int component)
{
  mapper->SelectScalarArray(array.Name.c_str());
  mapper->SetScalarMode(
    array.OfCells ? VTK_SCALAR_MODE_USE_CELL_FIELD_DATA : VTK_SCALAR_MODE_USE_POINT_FIELD_DATA);
  mapper->SetArrayComponent(component);
}

void SelectColors(vtkGatunVolumeMapper* mapper, int source, const ChosenArray& array, int component)
{
  mapper->SetColorSource(source);
  mapper->SetColorArrayName(array.Name.c_str());
  mapper->SetColorArrayAssociation(array.OfCells ? 1 : 0);
  mapper->SetColorArrayComponent(component);
}
}

//------------------------------------------------------------------------------
void SetVolumeArrays(vtkGatunVolumeMapper* mapper, vtkDataSet* arrays, const VolumeChoice& choice,
  vtkColorTransferFunction* colors)
{
  const int components = CountComponents(arrays, choice.Color);
  const int color = GetColorComponent(colors, components);
  if (choice.HasOpacity && !choice.Opacity.Name.empty() && !choice.Color.Name.empty())
  {
    const int ofOpacity = CountComponents(arrays, choice.Opacity);
    SelectScalars(mapper, choice.Opacity, GetComponent(choice.Opacity.Component, ofOpacity));
    SelectColors(mapper, vtkGatunVolumeMapper::COLOR_BY_ARRAY, choice.Color, color);
    return;
  }
  const bool isDependent = !choice.MapScalars || choice.MapsComponents;
  if (isDependent && (components == 2 || components == 4))
  {
    SelectScalars(mapper, choice.Color, components - 1);
    SelectColors(mapper,
      components == 2 ? vtkGatunVolumeMapper::COLOR_BY_ARRAY : vtkGatunVolumeMapper::COLOR_DIRECT,
      choice.Color, 0);
    return;
  }
  SelectScalars(mapper, choice.Color, color);
  mapper->SetColorSource(vtkGatunVolumeMapper::COLOR_BY_SCALARS);
}
}
