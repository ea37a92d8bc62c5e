// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnGridView.h"

#include "gtnFailure.h"
#include "gtnText.h"

#include "vtkAbstractArray.h"
#include "vtkBitArray.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <fmt/core.h>

#include <cmath>
#include <cstring>

namespace gtn
{
namespace
{

template <typename T>
T Load(const unsigned char* bytes)
{
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

std::string TextOfValue(int type, const unsigned char* bytes)
{
  switch (type)
  {
    case VTK_FLOAT:
    {
      const auto value = Load<float>(bytes);
      return std::isnan(value) ? fmt::format("nan(0x{:08x})", Load<std::uint32_t>(bytes))
                               : fmt::format("{}", value);
    }
    case VTK_DOUBLE:
    {
      const auto value = Load<double>(bytes);
      return std::isnan(value) ? fmt::format("nan(0x{:016x})", Load<std::uint64_t>(bytes))
                               : fmt::format("{}", value);
    }
    default:
      break;
  }
  switch (type)
  {
    vtkTemplateMacro(return std::to_string(
      static_cast<std::conditional_t<sizeof(VTK_TT) == 1, int, VTK_TT>>(Load<VTK_TT>(bytes))));
    default:
      return "?";
  }
}

unsigned RolesOf(vtkDataSetAttributes* attributes, vtkAbstractArray* array)
{
  unsigned roles = 0;
  for (int i = 0; i < vtkDataSetAttributes::NUM_ATTRIBUTES; ++i)
  {
    if (attributes->GetAbstractAttribute(i) == array)
    {
      roles |= 1u << i;
    }
  }
  return roles;
}

std::vector<ArrayView> ViewsOf(
  vtkDataSetAttributes* attributes, const std::string& kind, std::size_t tuples)
{
  std::vector<ArrayView> views;
  for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = attributes->GetAbstractArray(i);
    ArrayView view = ViewOf(array, kind);
    if (static_cast<std::size_t>(array->GetNumberOfTuples()) != tuples)
    {
      throw Failure(
        fmt::format("{} has {} values, not {}", view.Title, array->GetNumberOfTuples(), tuples));
    }
    view.Roles = RolesOf(attributes, array);
    views.push_back(view);
  }
  return views;
}

} // anonymous namespace

//------------------------------------------------------------------------------
std::string ArrayView::Text(std::size_t i) const
{
  const std::size_t valueBytes = this->TupleBytes / this->Components;
  std::string text = this->Components > 1 ? "(" : "";
  for (int j = 0; j < this->Components; ++j)
  {
    text += (j > 0 ? ", " : "") + TextOfValue(this->Type, this->Tuple(i) + j * valueBytes);
  }
  return text + (this->Components > 1 ? ")" : "");
}

//------------------------------------------------------------------------------
ArrayView ViewOf(vtkAbstractArray* array, const std::string& kind)
{
  ArrayView view;
  view.Name = array->GetName() ? array->GetName() : "";
  view.Title = fmt::format("{} '{}'", kind, Printable(view.Name));
  view.Owner = vtkDataArray::SafeDownCast(array);
  if (!view.Owner)
  {
    throw Failure(view.Title + " is not numeric");
  }
  view.Type = array->GetDataType();
  view.Components = array->GetNumberOfComponents();
  for (int i = 0; array->HasAComponentName() && i < view.Components; ++i)
  {
    const char* name = array->GetComponentName(i);
    view.ComponentNames.emplace_back(name ? name : "");
  }
  if (auto* bits = vtkBitArray::SafeDownCast(array))
  {
    vtkNew<vtkUnsignedCharArray> bytes;
    bytes->SetNumberOfComponents(view.Components);
    bytes->SetNumberOfTuples(bits->GetNumberOfTuples());
    for (vtkIdType i = 0; i < bits->GetNumberOfValues(); ++i)
    {
      bytes->SetValue(i, static_cast<unsigned char>(bits->GetValue(i)));
    }
    view.Owner = bytes;
    view.Type = VTK_UNSIGNED_CHAR;
  }
  // Other layouts than tuple by tuple are copied by this call.
  view.Bytes = static_cast<const unsigned char*>(view.Owner->GetVoidPointer(0));
  view.TupleBytes =
    static_cast<std::size_t>(view.Owner->GetDataTypeSize()) * view.Owner->GetNumberOfComponents();
  if (array->GetDataType() == VTK_BIT)
  {
    view.Type = VTK_BIT;
  }
  return view;
}

//------------------------------------------------------------------------------
GridView::GridView(vtkUnstructuredGrid* grid)
  : Points(grid->GetNumberOfPoints())
  , Cells(grid->GetNumberOfCells())
  , PointArrays(ViewsOf(grid->GetPointData(), "point array", this->Points))
  , CellArrays(ViewsOf(grid->GetCellData(), "cell array", this->Cells))
  , Field(grid->GetFieldData())
{
  if (grid->GetPoints())
  {
    this->Coordinates = ViewOf(grid->GetPoints()->GetData(), "point array");
  }
  else
  {
    this->Coordinates.Type = VTK_FLOAT;
    this->Coordinates.Components = 3;
    this->Coordinates.TupleBytes = 12;
  }
  this->Coordinates.Title = "the coordinates";
  if (this->Cells > 0)
  {
    vtkCellArray* cells = grid->GetCells();
    if (cells->IsHomogeneous() != 4)
    {
      throw Failure("has cells that are not tetrahedra");
    }
    this->Connectivity = cells->GetConnectivityArray();
    if (cells->IsStorage64Bit())
    {
      this->Wide = static_cast<const std::int64_t*>(this->Connectivity->GetVoidPointer(0));
    }
    else
    {
      this->Narrow = static_cast<const std::int32_t*>(this->Connectivity->GetVoidPointer(0));
    }
  }
}

//------------------------------------------------------------------------------
Tet GridView::Corners(std::size_t cell) const
{
  Tet tet;
  for (int i = 0; i < 4; ++i)
  {
    tet[i] = this->Wide ? this->Wide[4 * cell + i] : this->Narrow[4 * cell + i];
  }
  return tet;
}
}
