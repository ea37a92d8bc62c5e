// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunCellCheck.h"

#include "gatunCellArrays.h"
#include "gatunError.h"
#include "gatunMeshCheck.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkCellTypes.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cstdint>
#include <string>

namespace
{

//------------------------------------------------------------------------------
bool OffsetsFit(vtkCellArray* cells)
{
  bool fit = false;
  gatun::UseCellArrays(cells,
    [&](const auto* begin, const auto*, vtkIdType ids)
    {
      const auto* end = begin + cells->GetOffsetsArray()->GetNumberOfValues();
      fit = begin != end && *begin == 0 && std::is_sorted(begin, end) && end[-1] <= ids;
    });
  return fit;
}

//------------------------------------------------------------------------------
template <typename IdT>
void CheckIds(const IdT* begin, vtkIdType count, vtkIdType points)
{
  const IdT* const end = begin + count;
  const IdT* const wrong =
    std::find_if(begin, end, [points](auto id) { return id < 0 || id >= points; });
  if (wrong != end)
  {
    throw gatun::Error(gatun::ErrorCode::InvalidInput,
      "a cell names point " + std::to_string(*wrong) + " of " + std::to_string(points));
  }
}

[[noreturn]] void ThrowTupleCount(
  vtkAbstractArray& array, const std::string& place, vtkIdType tuples)
{
  const std::string name = array.GetName() ? array.GetName() : "";
  gatun::ThrowInvalid("the " + place + " array '" + name + "' has " +
    std::to_string(array.GetNumberOfTuples()) + " tuples for " + std::to_string(tuples) + " " +
    place + "s");
}

//------------------------------------------------------------------------------
void CheckLengths(vtkDataSetAttributes* attributes, vtkIdType tuples, const std::string& place)
{
  for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = attributes->GetAbstractArray(i);
    if (array->GetNumberOfTuples() != tuples)
    {
      ThrowTupleCount(*array, place, tuples);
    }
  }
}

} // anonymous namespace

namespace gatun
{

//------------------------------------------------------------------------------
void CheckOffsets(vtkCellArray* cells)
{
  if (!OffsetsFit(cells))
  {
    throw Error(ErrorCode::InvalidInput, "the offsets of the cells do not fit their connectivity");
  }
}

//------------------------------------------------------------------------------
void CheckPointIds(vtkCellArray* cells, vtkIdType points)
{
  const auto ids = GetPointIds(cells);
  if (HasWideIds(cells))
  {
    CheckIds(GetIntegers<vtkTypeInt64>(ids.Get()), ids->GetNumberOfValues(), points);
  }
  else
  {
    CheckIds(GetIntegers<vtkTypeInt32>(ids.Get()), ids->GetNumberOfValues(), points);
  }
}

//------------------------------------------------------------------------------
void CheckGrid(vtkUnstructuredGrid* grid)
{
  const auto types = GetCellTypes(grid);
  vtkCellArray* const cells = grid->GetCells();
  if (grid->GetNumberOfCells() > 0)
  {
    if (!types || !cells || types->GetNumberOfValues() != cells->GetNumberOfCells())
    {
      ThrowInvalid("the number of cell types is not that of the cells");
    }
    CheckOffsets(cells);
  }
  CheckLengths(grid->GetPointData(), grid->GetNumberOfPoints(), "point");
  CheckLengths(grid->GetCellData(), grid->GetNumberOfCells(), "cell");
}

//------------------------------------------------------------------------------
void CheckCell(vtkIdType cell, int type, vtkIdType size, const vtkIdType* ids, vtkIdType points)
{
  CheckCellSize(static_cast<std::uint64_t>(cell), type, static_cast<std::uint64_t>(size));
  for (vtkIdType i = 0; i < size; ++i)
  {
    if (ids[i] < 0 || ids[i] >= points)
    {
      ThrowInvalid("cell " + std::to_string(cell) + " names point " + std::to_string(ids[i]) +
        " of " + std::to_string(points));
    }
  }
}

//------------------------------------------------------------------------------
void CheckCells(vtkUnstructuredGrid* grid)
{
  const vtkIdType count = grid->GetNumberOfCells();
  if (count == 0)
  {
    return;
  }
  auto iterator = vtk::TakeSmartPointer(grid->GetCells()->NewIterator());
  for (vtkIdType cell = 0; cell < count; ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    iterator->GetCellAtId(cell, size, ids);
    CheckCell(cell, grid->GetCellType(cell), size, ids, grid->GetNumberOfPoints());
  }
}

}
