// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunRoundedGrid.h"

#include "gatunArrayBridge.h"
#include "gatunBridgedMesh.h"
#include "gatunNewArray.h"
#include "gatunPointRounding.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace gatun
{
//------------------------------------------------------------------------------
vtkSmartPointer<vtkUnstructuredGrid> RoundGrid(
  vtkUnstructuredGrid* grid, const ErrorBound& bound, bool isWhole, double& largest)
{
  const int type = grid->GetNumberOfPoints() > 0 ? grid->GetPoints()->GetDataType() : VTK_VOID;
  if (!bound || (type != VTK_FLOAT && type != VTK_DOUBLE))
  {
    return grid;
  }
  const BridgedMesh mesh(grid);
  auto rounded = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(type));
  rounded->SetNumberOfComponents(3);
  SizeArray(rounded, grid->GetNumberOfPoints());
  const double error = RoundPoints(mesh.Mesh, bound, isWhole, rounded->GetVoidPointer(0));
  if (error == 0)
  {
    return grid;
  }
  largest = std::max(largest, error);
  vtkNew<vtkPoints> places;
  CopyNames(grid->GetPoints()->GetData(), rounded);
  places->SetData(rounded);
  auto result = vtkSmartPointer<vtkUnstructuredGrid>::New();
  result->ShallowCopy(grid);
  result->SetPoints(places);
  return result;
}
}
