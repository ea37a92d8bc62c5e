// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunCellArrays.h"

#include "gatunArrayBridge.h"
#include "gatunNewArray.h"

#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace gatun
{
namespace
{
// Since VTK 9.6.
template <typename Grid>
concept HasImplicitTypes = requires(Grid* grid)
{
  grid->GetCellTypes()->GetNumberOfValues();
};

template <typename Grid>
vtkDataArray* TypesOf(Grid* grid)
{
  if constexpr (HasImplicitTypes<Grid>)
  {
    return grid->GetCellTypes();
  }
  else
  {
    return grid->GetCellTypesArray();
  }
}

/** Whether values do not all fit signed 32-bit integers. */
bool IsWide(vtkDataArray* array)
{
  return array->GetDataTypeMax() > static_cast<double>(VTK_INT_MAX);
}

//------------------------------------------------------------------------------
/** The integers of an array in plain memory, as the values of ArrayT. */
template <typename ArrayT>
vtkSmartPointer<vtkDataArray> ConvertTo(vtkDataArray* array)
{
  using ValueT = typename ArrayT::ValueType;
  auto plain = vtkSmartPointer<ArrayT>::New();
  SizeArray(plain, array->GetNumberOfValues());
  ValueT* const to = plain->GetPointer(0);
  switch (array->GetDataType())
  {
    vtkTemplateMacro(std::transform(static_cast<const VTK_TT*>(array->GetVoidPointer(0)),
      static_cast<const VTK_TT*>(array->GetVoidPointer(0)) + array->GetNumberOfValues(), to,
      [](VTK_TT value) { return static_cast<ValueT>(value); }));
  }
  return plain;
}

vtkSmartPointer<vtkDataArray> PlainIntegers(vtkDataArray* array, bool isWide)
{
  const auto plain = Contiguous(array);
  const int type = plain->GetDataType();
  const bool isInteger = plain->GetDataTypeMin() < 0 && type != VTK_FLOAT && type != VTK_DOUBLE;
  return isInteger && plain->GetDataTypeSize() == (isWide ? 8 : 4) ? plain
    : isWide ? ConvertTo<vtkTypeInt64Array>(plain)
             : ConvertTo<vtkTypeInt32Array>(plain);
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkUnsignedCharArray> GetCellTypes(vtkUnstructuredGrid* grid)
{
  vtkDataArray* const types = TypesOf(grid);
  return types ? vtkArrayDownCast<vtkUnsignedCharArray>(Contiguous(types)) : nullptr;
}

//------------------------------------------------------------------------------
bool HasWideIds(vtkCellArray* cells)
{
  return IsWide(cells->GetConnectivityArray()) || IsWide(cells->GetOffsetsArray());
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataArray> GetOffsets(vtkCellArray* cells)
{
  return PlainIntegers(cells->GetOffsetsArray(), HasWideIds(cells));
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataArray> GetPointIds(vtkCellArray* cells)
{
  return PlainIntegers(cells->GetConnectivityArray(), HasWideIds(cells));
}
}
