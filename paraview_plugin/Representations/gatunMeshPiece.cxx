// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunMeshPiece.h"

#include "vtkCell.h"
#include "vtkExtractCellsByType.h"
#include "vtkGenericCell.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <vector>

namespace gatun
{
namespace
{
struct CellTypes
{
  std::vector<int> WithInside;
  bool HasOthers = false;
};

//------------------------------------------------------------------------------
CellTypes FindTypes(vtkUnstructuredGrid* grid)
{
  CellTypes found;
  vtkUnsignedCharArray* const types = grid->GetDistinctCellTypesArray();
  for (vtkIdType i = 0; types && i < types->GetNumberOfValues(); ++i)
  {
    const int type = types->GetValue(i);
    const auto cell = vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(type));
    if (cell && cell->GetCellDimension() == 3)
    {
      found.WithInside.push_back(type);
    }
    else
    {
      found.HasOthers = true;
    }
  }
  return found;
}
}

//------------------------------------------------------------------------------
bool HasVolume(vtkUnstructuredGrid* grid)
{
  return !FindTypes(grid).WithInside.empty();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkUnstructuredGrid> MakeMeshPiece(vtkUnstructuredGrid* grid)
{
  auto piece = vtkSmartPointer<vtkUnstructuredGrid>::New();
  piece->ShallowCopy(grid);
  const CellTypes types = FindTypes(piece);
  if (types.HasOthers && !types.WithInside.empty())
  {
    vtkNew<vtkExtractCellsByType> extract;
    extract->SetInputData(piece);
    for (const int type : types.WithInside)
    {
      extract->AddCellType(static_cast<unsigned int>(type));
    }
    extract->Update();
    piece = vtkUnstructuredGrid::SafeDownCast(extract->GetOutput());
  }
  if (piece->GetCellGhostArray())
  {
    piece->RemoveGhostCells();
  }
  return piece;
}
}
