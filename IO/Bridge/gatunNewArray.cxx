// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunNewArray.h"

#include "gatunLargeArray.h"

#include "vtkAbstractArray.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkPoints.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"

#include <cstdint>
#include <new>

namespace gatun
{
namespace
{
template <typename ArrayT>
vtkSmartPointer<vtkCellArray> MakeCellArray(
  const std::vector<vtkIdType>& offsets, const std::vector<vtkIdType>& ids)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(MakeArray<ArrayT>(offsets), MakeArray<ArrayT>(ids));
  return cells;
}
}

//------------------------------------------------------------------------------
void SizeArray(vtkAbstractArray* array, vtkIdType tuples)
{
  if (tuples > 0 && array->GetDataType() != VTK_BIT && vtkDataArray::SafeDownCast(array) &&
    array->HasStandardMemoryLayout())
  {
    const auto size = static_cast<std::size_t>(array->GetDataTypeSize()) *
      static_cast<std::size_t>(array->GetNumberOfComponents());
    if (static_cast<std::size_t>(tuples) > std::size_t{ PTRDIFF_MAX } / 2 / size)
    {
      throw std::bad_alloc();
    }
    array->SetVoidArray(AllocateLarge(static_cast<std::size_t>(tuples) * size),
      tuples * array->GetNumberOfComponents(), 0, vtkAbstractArray::VTK_DATA_ARRAY_FREE);
    return;
  }
  // Other arrays get their memory from `new`.
  array->SetNumberOfTuples(tuples);
}

//------------------------------------------------------------------------------
void SizePoints(vtkPoints* points, vtkIdType count)
{
  SizeArray(points->GetData(), count);
  points->Modified();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkCellArray> CellCollector::Make(bool isWide) const
{
  return isWide ? MakeCellArray<vtkTypeInt64Array>(this->Offsets, this->Ids)
                : MakeCellArray<vtkTypeInt32Array>(this->Offsets, this->Ids);
}
}
