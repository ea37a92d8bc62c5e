// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunVolumeBridge.h"

#include "gatunError.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"

#include <algorithm>
#include <limits>
#include <string>

namespace gatun
{
namespace
{
//------------------------------------------------------------------------------
std::string NameOf(vtkAbstractArray* array)
{
  return array->GetName() ? array->GetName() : "";
}

//------------------------------------------------------------------------------
void RequirePointArray(vtkInformation* wanted)
{
  const int where = wanted->Has(vtkDataObject::FIELD_ASSOCIATION())
    ? wanted->Get(vtkDataObject::FIELD_ASSOCIATION())
    : vtkDataObject::FIELD_ASSOCIATION_POINTS;
  if (where != vtkDataObject::FIELD_ASSOCIATION_POINTS &&
    where != vtkDataObject::FIELD_ASSOCIATION_POINTS_THEN_CELLS)
  {
    ThrowInvalid("a volume needs a point array; vtkCellDataToPointData converts cell arrays");
  }
}
}

//------------------------------------------------------------------------------
vtkDataArray* FindVolumeArray(vtkImageData* image, vtkInformation* wanted)
{
  if (image->GetNumberOfPoints() == 0)
  {
    ThrowInvalid("the volume is empty");
  }
  RequirePointArray(wanted);
  vtkPointData* const data = image->GetPointData();
  vtkAbstractArray* array = nullptr;
  if (wanted->Has(vtkDataObject::FIELD_NAME()))
  {
    const std::string name = wanted->Get(vtkDataObject::FIELD_NAME());
    array = data->GetAbstractArray(name.c_str());
    if (!array)
    {
      ThrowInvalid("there is no point array '" + name + "'");
    }
  }
  else
  {
    const int role = wanted->Has(vtkDataObject::FIELD_ATTRIBUTE_TYPE())
      ? wanted->Get(vtkDataObject::FIELD_ATTRIBUTE_TYPE())
      : static_cast<int>(vtkDataSetAttributes::SCALARS);
    array = data->GetAbstractAttribute(role);
    if (!array)
    {
      ThrowInvalid(std::string("there are no active point ") +
        vtkDataSetAttributes::GetAttributeTypeAsString(role) + "; select an array by its name");
    }
  }
  const std::string title = "the point array '" + NameOf(array) + "' ";
  auto* const numbers = vtkDataArray::SafeDownCast(array);
  if (!numbers || array->GetDataType() == VTK_BIT)
  {
    ThrowInvalid(title + "is a " + array->GetClassName() + ", which is not a numeric array");
  }
  if (array->GetNumberOfComponents() != 1)
  {
    ThrowInvalid(title + "has " + std::to_string(array->GetNumberOfComponents()) +
      " components, but a volume has one; use vtkImageExtractComponents");
  }
  if (array->GetNumberOfTuples() != image->GetNumberOfPoints())
  {
    ThrowInvalid(title + "has " + std::to_string(array->GetNumberOfTuples()) + " values for " +
      std::to_string(image->GetNumberOfPoints()) + " points");
  }
  return numbers;
}

//------------------------------------------------------------------------------
BridgedVolume BridgeVolume(vtkImageData* image, vtkInformation* wanted)
{
  const BridgedArray array = Bridge(FindVolumeArray(image, wanted), Association::Point);
  BridgedVolume bridged;
  bridged.Owner = array.Owner;
  VolumeInput& volume = bridged.Volume;
  volume.Type = array.Description.Type;
  volume.Values = array.Values;
  volume.Name = array.Description.Name;
  volume.VTKType = array.Description.VTKType;
  const int* const extent = image->GetExtent();
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    volume.Size[axis] = static_cast<std::uint32_t>(image->GetDimensions()[axis]);
    volume.FirstIndex[axis] = extent[2 * axis];
    volume.Origin[axis] = image->GetOrigin()[axis];
    volume.Spacing[axis] = image->GetSpacing()[axis];
  }
  const double* const direction = image->GetDirectionMatrix()->GetData();
  std::copy(direction, direction + 9, volume.Direction.begin());
  return bridged;
}

//------------------------------------------------------------------------------
ArrayDescription DescribeVolumeArray(const VolumeInput& volume)
{
  ArrayDescription description;
  description.Name = volume.Name;
  description.Type = volume.Type;
  description.VTKType = volume.VTKType;
  return description;
}

//------------------------------------------------------------------------------
std::array<int, 6> ExtentOf(const VolumeInput& volume)
{
  std::array<int, 6> extent{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::int64_t last = static_cast<std::int64_t>(volume.FirstIndex[axis]) +
      static_cast<std::int64_t>(volume.Size[axis]) - 1;
    if (last > std::numeric_limits<int>::max())
    {
      ThrowCorrupt("the volume's extent ends at " + std::to_string(last) + ", which is too large");
    }
    extent[2 * axis] = volume.FirstIndex[axis];
    extent[2 * axis + 1] = static_cast<int>(last);
  }
  return extent;
}
}
