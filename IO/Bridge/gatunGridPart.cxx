// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunGridPart.h"

#include "gatunArrayBridge.h"
#include "gatunError.h"
#include "gatunFaceStream.h"

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
    : From(GetFaceStream(grid))
    , NewIds(newIds)
  {
    this->To = { vtkSmartPointer<vtkIdTypeArray>::New(), vtkSmartPointer<vtkIdTypeArray>::New() };
  }

  void AddPolyhedron(vtkIdType cell)
  {
    this->To.Locations->InsertNextValue(this->To.Values->GetNumberOfValues());
    this->Cell = cell;
    this->At = this->From.Locations && cell < this->From.Locations->GetNumberOfValues()
      ? this->From.Locations->GetValue(cell)
      : -1;
    if (this->At < 0)
    {
      this->To.Values->InsertNextValue(0);
      return;
    }
    const vtkIdType faces = this->TakeCount();
    this->To.Values->InsertNextValue(faces);
    for (vtkIdType face = 0; face < faces; ++face)
    {
      const vtkIdType size = this->TakeCount();
      this->To.Values->InsertNextValue(size);
      for (vtkIdType i = 0; i < size; ++i)
      {
        this->AddPoint(this->Take());
      }
    }
  }

  void AddOther() { this->To.Locations->InsertNextValue(-1); }

  const FaceStream& Get() const { return this->To; }

private:
  vtkIdType Take()
  {
    if (this->At >= this->From.Values->GetNumberOfValues())
    {
      ThrowInvalid("the faces of cell " + std::to_string(this->Cell) + " are incomplete");
    }
    return this->From.Values->GetValue(this->At++);
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
    this->To.Values->InsertNextValue(id);
  }

  const FaceStream From;
  FaceStream To;
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
  const bool hasFaces = faces.Get().Values->GetNumberOfValues() > 0;
  SetCells(extracted, types, cells, hasFaces ? faces.Get() : FaceStream{});
  return extracted;
}
}
