// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunArrayToShow.h"

#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkSMArrayListDomain.h"
#include "vtkType.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace gatun
{
namespace
{
bool IsOfNumbers(int type)
{
  return type >= VTK_BIT && type != VTK_STRING && type != VTK_VARIANT && type != VTK_OBJECT;
}

bool IsActiveScalars(const char* name, int association, const vtkPVDataInformation& data)
{
  vtkPVDataSetAttributesInformation* const attributes = data.GetAttributeInformation(association);
  vtkPVArrayInformation* const scalars =
    attributes ? attributes->GetAttributeInformation(vtkDataSetAttributes::SCALARS) : nullptr;
  return scalars && std::string_view(scalars->GetName()) == name;
}
}

//------------------------------------------------------------------------------
bool IsBookkeeping(vtkPVArrayInformation& array)
{
  const std::string_view name = array.GetName();
  if (name.starts_with("vtk"))
  {
    return true;
  }
  constexpr std::array<std::string_view, 6> ends{ "Id", "Ids", "ID", "IDs", "_id", "_ids" };
  const int type = array.GetDataType();
  return type != VTK_FLOAT && type != VTK_DOUBLE &&
    (name == "id" || name == "ids" ||
      std::any_of(
        ends.begin(), ends.end(), [&](std::string_view end) { return name.ends_with(end); }));
}

//------------------------------------------------------------------------------
std::optional<unsigned int> FindArrayToShow(vtkSMArrayListDomain& list, vtkPVDataInformation& data)
{
  // Lower is better: 2 for cells, 1 if it is not the active array, and 4 for bookkeeping.
  constexpr int none = 8;
  int best = none;
  std::optional<unsigned int> found;
  for (unsigned int i = 0; i < list.GetNumberOfStrings(); ++i)
  {
    const int association = list.GetFieldAssociation(i);
    const bool ofCells = association == vtkDataObject::CELL;
    if (!ofCells && association != vtkDataObject::POINT)
    {
      continue;
    }
    const char* const name = list.GetString(i);
    vtkPVArrayInformation* const array = data.GetArrayInformation(name, association);
    if (!array || !IsOfNumbers(array->GetDataType()))
    {
      continue;
    }
    const int rank = (IsBookkeeping(*array) ? 4 : 0) + (ofCells ? 2 : 0) +
      (IsActiveScalars(name, association, data) ? 0 : 1);
    if (rank < best)
    {
      best = rank;
      found = i;
    }
  }
  return found;
}
}
