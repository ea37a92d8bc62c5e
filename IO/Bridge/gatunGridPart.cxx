// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunGridPart.h"

#include "gatunArrayBridge.h"
#include "gatunCellArrays.h"
#include "gatunError.h"
#include "gatunFaceStream.h"
#include "gatunNewArray.h"

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
#include <vector>

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
  }

  void AddPolyhedron(vtkIdType cell)
  {
    this->Locations.push_back(static_cast<vtkIdType>(this->Values.size()));
    this->Cell = cell;
    this->At = this->From.Locations && cell < this->From.Locations->GetNumberOfValues()
      ? this->From.Locations->GetValue(cell)
      : -1;
    if (this->At < 0)
    {
      this->Values.push_back(0);
      return;
    }
    const vtkIdType faces = this->TakeCount();
    this->Values.push_back(faces);
    for (vtkIdType face = 0; face < faces; ++face)
    {
      const vtkIdType size = this->TakeCount();
      this->Values.push_back(size);
      for (vtkIdType i = 0; i < size; ++i)
      {
        this->AddPoint(this->Take());
      }
    }
  }

  void AddOther() { this->Locations.push_back(-1); }

  FaceStream Make() const
  {
    return this->Values.empty() ? FaceStream{}
                                : FaceStream{ MakeArray<vtkIdTypeArray>(this->Values),
                                    MakeArray<vtkIdTypeArray>(this->Locations) };
  }

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
    this->Values.push_back(id);
  }

  const FaceStream From;
  std::vector<vtkIdType> Values;
  std::vector<vtkIdType> Locations;
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
  SizeArray(types, static_cast<vtkIdType>(part.Cells.size()));
  unsigned char* typeOut = types->GetPointer(0);
  CellCollector cells;
  bool isWide = true;
  FaceCopier faces(grid, newIds);
  if (!part.Cells.empty())
  {
    isWide = HasWideIds(grid->GetCells());
    auto iterator = vtk::TakeSmartPointer(grid->GetCells()->NewIterator());
    for (const vtkIdType cell : part.Cells)
    {
      const int type = grid->GetCellType(cell);
      *typeOut++ = static_cast<unsigned char>(type);
      vtkIdType size = 0;
      const vtkIdType* ids = nullptr;
      iterator->GetCellAtId(cell, size, ids);
      for (vtkIdType i = 0; i < size; ++i)
      {
        cells.AddPoint(newIds[static_cast<std::size_t>(ids[i])]);
      }
      cells.EndCell();
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
  SetCells(extracted, types, cells.Make(isWide), faces.Make());
  return extracted;
}
}
