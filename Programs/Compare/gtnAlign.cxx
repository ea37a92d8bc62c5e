// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnAlign.h"

#include "gatunArrayBridge.h"
#include "gatunSeriesArrays.h"

#include "vtkAbstractArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace gtn
{
namespace
{

struct AlignedArray
{
  vtkSmartPointer<vtkAbstractArray> Values;
  std::uint32_t Roles = 0;
};

// Gives an array what a file has for all of its steps.
void AdoptSeries(AlignedArray& array, vtkDataSetAttributes* packed, vtkAbstractArray* wanted,
  bool isLater, bool& rolesDiffer)
{
  const std::uint32_t roles = gatun::AttributeRolesOf(packed, wanted);
  if (isLater && array.Roles != roles)
  {
    rolesDiffer = rolesDiffer || array.Values->GetNumberOfTuples() > 0;
    array.Roles = roles;
  }
  if (!array.Values->HasAComponentName() && wanted->HasAComponentName() &&
    array.Values->GetNumberOfComponents() == wanted->GetNumberOfComponents())
  {
    auto* const numbers = vtkDataArray::SafeDownCast(array.Values);
    if (numbers)
    {
      auto named = vtk::TakeSmartPointer(numbers->NewInstance());
      named->ShallowCopy(numbers);
      named->CopyComponentNames(wanted);
      array.Values = named;
    }
  }
}

void Align(vtkDataSetAttributes* original, vtkDataSetAttributes* packed, vtkIdType tuples,
  const SeriesPlace& place, bool& rolesDiffer)
{
  using Array = AlignedArray;
  std::vector<Array> rest;
  for (int i = 0; i < original->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* const array = original->GetAbstractArray(i);
    rest.push_back({ array, gatun::AttributeRolesOf(original, array) });
  }
  const auto nameOf = [](vtkAbstractArray* array)
  { return std::string(array->GetName() ? array->GetName() : ""); };
  std::vector<Array> aligned;
  for (int i = 0; i < packed->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* const wanted = packed->GetAbstractArray(i);
    const std::string name = nameOf(wanted);
    const auto take = [&](const auto& isWanted)
    {
      const auto found = std::find_if(rest.begin(), rest.end(), isWanted);
      const bool isThere = found != rest.end();
      if (isThere)
      {
        aligned.push_back(*found);
        rest.erase(found);
      }
      return isThere;
    };
    if (take([&](const Array& array) { return nameOf(array.Values) == name; }))
    {
      if (place.IsSeries)
      {
        AdoptSeries(aligned.back(), packed, wanted, !place.IsFirst || tuples == 0, rolesDiffer);
      }
      continue;
    }
    if (place.Fill || tuples == 0 ||
      (place.IsSeries && name == vtkDataSetAttributes::GhostArrayName()))
    {
      const auto filled =
        gatun::MakeMissingArray(wanted->GetDataType(), wanted->GetNumberOfComponents(), tuples);
      filled->SetName(wanted->GetName());
      filled->CopyComponentNames(wanted);
      aligned.push_back({ filled, gatun::AttributeRolesOf(packed, wanted) });
    }
  }
  if (tuples == 0)
  {
    rest.clear(); // nothing is in them
  }
  aligned.insert(aligned.end(), rest.begin(), rest.end());
  original->Initialize();
  for (const Array& array : aligned)
  {
    gatun::AddWithRoles(original, array.Values, array.Roles);
  }
}

} // anonymous namespace

//------------------------------------------------------------------------------
vtkSmartPointer<vtkUnstructuredGrid> AlignArrays(vtkUnstructuredGrid* original,
  vtkUnstructuredGrid* packed, const SeriesPlace& place, bool& rolesDiffer)
{
  auto aligned = vtkSmartPointer<vtkUnstructuredGrid>::New();
  aligned->ShallowCopy(original);
  Align(aligned->GetPointData(), packed->GetPointData(), aligned->GetNumberOfPoints(), place,
    rolesDiffer);
  Align(
    aligned->GetCellData(), packed->GetCellData(), aligned->GetNumberOfCells(), place, rolesDiffer);
  return aligned;
}
}
