// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunGridPart.h"

#include "gatunArrayBridge.h"
#include "gatunError.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <cstddef>
#include <string>

namespace gatun
{
namespace
{
/** Copies the faces of polyhedra, with other point ids. */
class FaceCopier
{
public:
  FaceCopier(vtkUnstructuredGrid* grid, const std::vector<vtkIdType>& newIds)
    : From(grid->GetFaces())
    , Starts(grid->GetFaceLocations())
    , NewIds(newIds)
  {
  }

  void AddPolyhedron(vtkIdType cell)
  {
    this->Locations->InsertNextValue(this->Faces->GetNumberOfValues());
    this->Cell = cell;
    this->At = this->From && this->Starts && cell < this->Starts->GetNumberOfValues()
      ? this->Starts->GetValue(cell)
      : -1;
    if (this->At < 0)
    {
      this->Faces->InsertNextValue(0);
      return;
    }
    const vtkIdType faces = this->TakeCount();
    this->Faces->InsertNextValue(faces);
    for (vtkIdType face = 0; face < faces; ++face)
    {
      const vtkIdType size = this->TakeCount();
      this->Faces->InsertNextValue(size);
      for (vtkIdType i = 0; i < size; ++i)
      {
        this->AddPoint(this->Take());
      }
    }
  }

  void AddOther() { this->Locations->InsertNextValue(-1); }

  vtkNew<vtkIdTypeArray> Locations;
  vtkNew<vtkIdTypeArray> Faces;

private:
  vtkIdType Take()
  {
    if (this->At >= this->From->GetNumberOfValues())
    {
      ThrowInvalid("the faces of cell " + std::to_string(this->Cell) + " are incomplete");
    }
    return this->From->GetValue(this->At++);
  }

  vtkIdType TakeCount()
  {
    const vtkIdType count = this->Take();
    if (count < 0)
    {
      ThrowInvalid("the faces of cell " + std::to_string(this->Cell) + " have a negative size");
    }
    return count;
  }

  void AddPoint(vtkIdType point)
  {
    const auto points = static_cast<vtkIdType>(this->NewIds.size());
    const bool exists = point >= 0 && point < points;
    const vtkIdType id = exists ? this->NewIds[static_cast<std::size_t>(point)] : -1;
    if (id < 0)
    {
      ThrowInvalid("a face of cell " + std::to_string(this->Cell) + " names point " +
        std::to_string(point) + ", which the cell does not have");
    }
    this->Faces->InsertNextValue(id);
  }

  vtkIdTypeArray* const From;
  vtkIdTypeArray* const Starts;
  const std::vector<vtkIdType>& NewIds;
  vtkIdType Cell = 0;
  vtkIdType At = 0;
};
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkUnstructuredGrid> ExtractPart(
  vtkUnstructuredGrid* grid, const GridPart& part, const std::vector<vtkIdType>& newIds)
{
  auto extracted = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  if (grid->GetPoints())
  {
    points->SetData(vtkDataArray::SafeDownCast(Gather(grid->GetPoints()->GetData(), part.Points)));
  }
  extracted->SetPoints(points);

  vtkNew<vtkUnsignedCharArray> types;
  vtkNew<vtkCellArray> cells;
  FaceCopier faces(grid, newIds);
  if (!part.Cells.empty())
  {
    if (!grid->GetCells()->IsStorage64Bit())
    {
      cells->Use32BitStorage();
    }
    auto iterator = vtk::TakeSmartPointer(grid->GetCells()->NewIterator());
    for (const vtkIdType cell : part.Cells)
    {
      const int type = grid->GetCellType(cell);
      types->InsertNextValue(static_cast<unsigned char>(type));
      vtkIdType size = 0;
      const vtkIdType* ids = nullptr;
      iterator->GetCellAtId(cell, size, ids);
      cells->InsertNextCell(static_cast<int>(size));
      for (vtkIdType i = 0; i < size; ++i)
      {
        cells->InsertCellPoint(newIds[static_cast<std::size_t>(ids[i])]);
      }
      if (type == VTK_POLYHEDRON)
      {
        faces.AddPolyhedron(cell);
      }
      else
      {
        faces.AddOther();
      }
    }
  }
  if (faces.Faces->GetNumberOfValues() > 0)
  {
    extracted->SetCells(types, cells, faces.Locations, faces.Faces);
  }
  else
  {
    extracted->SetCells(types, cells);
  }
  return extracted;
}
}
