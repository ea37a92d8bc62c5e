// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunMeshPiece.h"

#include "gatunTetInput.h"

#include "vtkCell.h"
#include "vtkGenericCell.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <exception>

namespace gatun
{
bool HasVolume(vtkUnstructuredGrid* grid)
{
  vtkUnsignedCharArray* const types = grid->GetDistinctCellTypesArray();
  for (vtkIdType i = 0; types && i < types->GetNumberOfValues(); ++i)
  {
    const auto cell =
      vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(types->GetValue(i)));
    if (cell && cell->GetCellDimension() == 3)
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkUnstructuredGrid> MakeMeshPiece(vtkUnstructuredGrid* grid)
{
  auto piece = vtkSmartPointer<vtkUnstructuredGrid>::New();
  if (!HasVolume(grid))
  {
    piece->ShallowCopy(grid);
    if (piece->GetCellGhostArray())
    {
      piece->RemoveGhostCells();
    }
    return piece;
  }
  try
  {
    piece->ShallowCopy(MakeTetInput(grid).Grid);
  }
  catch (const std::exception&)
  {
    piece->ShallowCopy(grid); // the mapper says what is wrong with it
  }
  return piece;
}
}
