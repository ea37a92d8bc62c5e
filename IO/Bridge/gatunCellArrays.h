// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunCellArrays_h
#define gatunCellArrays_h

// The arrays of cells in plain memory. From VTK 9.6 on, a grid may keep its types and a
// vtkCellArray its offsets as a formula (vtkConstantArray, vtkAffineArray), and its point ids as
// integers of any type. Arrays that are plain already are returned themselves, others as a copy.

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkGatunIOModule.h" // For export macro
#include "vtkSmartPointer.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkUnsignedCharArray;
class vtkUnstructuredGrid;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/** The type of each cell. Null if the grid has no types. */
VTKGATUNIO_EXPORT vtkSmartPointer<vtkUnsignedCharArray> GetCellTypes(vtkUnstructuredGrid* grid);

/** Whether GetOffsets and GetPointIds return 64-bit integers, and not 32-bit ones. */
VTKGATUNIO_EXPORT bool HasWideIds(vtkCellArray* cells);

/** Where the point ids of each cell begin, and where the last ones end. */
VTKGATUNIO_EXPORT vtkSmartPointer<vtkDataArray> GetOffsets(vtkCellArray* cells);

/** The point ids of all cells. */
VTKGATUNIO_EXPORT vtkSmartPointer<vtkDataArray> GetPointIds(vtkCellArray* cells);

/** The values of what GetOffsets and GetPointIds return. ValueT: vtkTypeInt64 if HasWideIds, or
 * else vtkTypeInt32. */
template <typename ValueT>
const ValueT* GetIntegers(vtkDataArray* array)
{
  return static_cast<const ValueT*>(array->GetVoidPointer(0));
}

/** Calls use(offsets, ids, size) with pointers to the integers of a cell array, in their own type,
 * and the number of ids. */
template <typename Use>
void UseCellArrays(vtkCellArray* cells, Use&& use)
{
  const auto offsets = GetOffsets(cells);
  const auto ids = GetPointIds(cells);
  const vtkIdType size = ids->GetNumberOfValues();
  if (HasWideIds(cells))
  {
    use(GetIntegers<vtkTypeInt64>(offsets.Get()), GetIntegers<vtkTypeInt64>(ids.Get()), size);
  }
  else
  {
    use(GetIntegers<vtkTypeInt32>(offsets.Get()), GetIntegers<vtkTypeInt32>(ids.Get()), size);
  }
}
}

#endif
