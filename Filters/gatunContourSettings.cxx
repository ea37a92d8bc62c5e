// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunContourSettings.h"

#include "gatunError.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkInformation.h"

namespace gatun
{
namespace
{
constexpr std::uint32_t Role(int attribute)
{
  return 1u << attribute;
}

/** Whether VTK interpolates an array along edges, or copies it from cells. Ids of things that the
 * output does not have, and ghost flags, make no sense there. */
bool IsCarried(const ArrayDescription& array)
{
  if (array.Name == vtkDataSetAttributes::GhostArrayName())
  {
    return false;
  }
  if (array.Where == Association::Cell)
  {
    return (array.AttributeRoles & Role(vtkDataSetAttributes::GLOBALIDS)) == 0;
  }
  const std::uint32_t ids =
    Role(vtkDataSetAttributes::GLOBALIDS) | Role(vtkDataSetAttributes::PEDIGREEIDS);
  return (array.AttributeRoles & ids) == 0 && array.VTKType != VTK_ID_TYPE;
}
}

//------------------------------------------------------------------------------
ContourArray::ContourArray(vtkInformation* info)
  : Attribute(vtkDataSetAttributes::SCALARS)
{
  const int where = info->Has(vtkDataObject::FIELD_ASSOCIATION())
    ? info->Get(vtkDataObject::FIELD_ASSOCIATION())
    : vtkDataObject::FIELD_ASSOCIATION_POINTS;
  if (where != vtkDataObject::FIELD_ASSOCIATION_POINTS &&
    where != vtkDataObject::FIELD_ASSOCIATION_POINTS_THEN_CELLS)
  {
    ThrowInvalid("isosurfaces need an array on the points; vtkCellDataToPointData makes one of an "
                 "array on the cells");
  }
  if (info->Has(vtkDataObject::FIELD_NAME()))
  {
    this->Name = info->Get(vtkDataObject::FIELD_NAME());
  }
  else if (info->Has(vtkDataObject::FIELD_ATTRIBUTE_TYPE()))
  {
    this->Attribute = info->Get(vtkDataObject::FIELD_ATTRIBUTE_TYPE());
  }
}

//------------------------------------------------------------------------------
bool ContourArray::IsThis(const ArrayDescription& array) const
{
  return array.Where == Association::Point &&
    (this->Name.empty() ? (array.AttributeRoles & Role(this->Attribute)) != 0
                        : array.Name == this->Name);
}

//------------------------------------------------------------------------------
void ContourArray::Fail() const
{
  ThrowInvalid(this->Name.empty() ? "there are no active point scalars"
                                  : "there is no point array '" + this->Name + "'");
}

//------------------------------------------------------------------------------
ScalarType ContourSettings::ChoosePrecision(ScalarType input) const
{
  switch (this->Precision)
  {
    case vtkAlgorithm::SINGLE_PRECISION:
      return ScalarType::Float32;
    case vtkAlgorithm::DOUBLE_PRECISION:
      return ScalarType::Float64;
    default:
      return input;
  }
}

//------------------------------------------------------------------------------
int ContourSettings::ChooseComponent(const ArrayDescription& array) const
{
  return this->Component == static_cast<int>(array.Components) ? -1 : this->Component;
}

//------------------------------------------------------------------------------
bool ContourSettings::Carries(ArrayDescription& array, bool isContoured) const
{
  if (!IsCarried(array) || (isContoured && !this->ComputeScalars))
  {
    return false;
  }
  if (array.Where == Association::Point)
  {
    // The array of the isovalues becomes the active scalars.
    array.AttributeRoles &= ~Role(vtkDataSetAttributes::SCALARS);
    array.AttributeRoles |= isContoured ? Role(vtkDataSetAttributes::SCALARS) : 0;
  }
  return true;
}
}
