// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// The part of SpooledMesh that reads pieces.

#include "gtnSpooledMesh.h"

#include "gatunArrayBridge.h"
#include "gatunFaceStream.h"
#include "gatunNewArray.h"
#include "vtkGatunWriter.h"

#include "vtkAbstractArray.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace gtn
{
//------------------------------------------------------------------------------
std::uint64_t SpooledMesh::GetLargestPiece() const
{
  std::uint64_t largest = 0;
  for (const Piece& piece : this->Pieces)
  {
    largest = std::max(largest, piece.Bytes);
  }
  return largest;
}

//------------------------------------------------------------------------------
void SpooledMesh::FillArray(vtkDataArray* array, const SpooledArray& from, std::size_t piece) const
{
  const std::size_t stream = from.FirstStream + piece;
  gatun::SizeArray(array, static_cast<vtkIdType>(this->File.GetSize(stream) / from.TupleBytes));
  this->File.Read(stream, 0,
    { static_cast<std::uint8_t*>(array->GetVoidPointer(0)),
      static_cast<std::size_t>(this->File.GetSize(stream)) });
}

//------------------------------------------------------------------------------
template <typename Array>
void SpooledMesh::FillCells(vtkUnstructuredGrid* grid, std::size_t piece) const
{
  using Id = typename Array::ValueType;
  vtkNew<vtkUnsignedCharArray> types;
  vtkNew<Array> ends;
  vtkNew<Array> corners;
  this->FillArray(types, { this->Types, 1 }, piece);
  const auto sizes = this->File.ReadAll<std::uint32_t>(this->Sizes + piece);
  gatun::SizeArray(ends, static_cast<vtkIdType>(sizes.size()) + 1);
  Id* end = ends->GetPointer(0);
  *end = 0;
  for (const std::uint32_t size : sizes)
  {
    end[1] = *end + static_cast<Id>(size);
    ++end;
  }
  {
    const auto points = this->File.ReadAll<std::uint32_t>(this->Corners + piece);
    gatun::SizeArray(corners, static_cast<vtkIdType>(points.size()));
    std::copy(points.begin(), points.end(), corners->GetPointer(0));
  }
  vtkNew<vtkCellArray> cells;
  cells->SetData(ends, corners);
  if (this->Mesh->HasPolyhedra())
  {
    this->FillFaces(grid, piece, types, cells);
  }
  else
  {
    grid->SetCells(types, cells);
  }
}

//------------------------------------------------------------------------------
void SpooledMesh::FillFaces(vtkUnstructuredGrid* grid, std::size_t piece,
  vtkUnsignedCharArray* types, vtkCellArray* cells) const
{
  const auto sizes = this->File.ReadAll<std::uint32_t>(this->FaceSizes + piece);
  const auto values = this->File.ReadAll<std::uint32_t>(this->Faces + piece);
  vtkNew<vtkIdTypeArray> faces;
  gatun::SizeArray(faces, static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), faces->GetPointer(0));
  vtkNew<vtkIdTypeArray> begins;
  gatun::SizeArray(begins, static_cast<vtkIdType>(sizes.size()));
  vtkIdType at = 0;
  for (std::size_t i = 0; i < sizes.size(); ++i)
  {
    begins->SetValue(static_cast<vtkIdType>(i), sizes[i] > 0 ? at : -1);
    at += static_cast<vtkIdType>(sizes[i]);
  }
  gatun::SetCells(grid, types, cells, { faces.GetPointer(), begins.GetPointer() });
}

//------------------------------------------------------------------------------
void SpooledMesh::FillJoinArray(vtkUnstructuredGrid* grid, std::size_t piece) const
{
  vtkNew<vtkTypeInt64Array> numbers;
  numbers->SetName(JoinArrayName);
  numbers->GetInformation()->Set(vtkGatunWriter::JOIN_POINTS(), 1);
  const auto points = this->File.ReadAll<std::uint32_t>(this->GetNumbers(piece));
  const auto marks = piece < this->FirstUnused
    ? this->File.ReadAll<std::uint8_t>(this->Shared + piece)
    : std::vector<std::uint8_t>(points.size());
  gatun::SizeArray(numbers, static_cast<vtkIdType>(points.size()));
  std::transform(points.begin(), points.end(), marks.begin(), numbers->GetPointer(0),
    [](std::uint32_t point, std::uint8_t mark) { return mark != 0 ? vtkTypeInt64{ point } : -1; });
  grid->GetPointData()->AddArray(numbers);
}

//------------------------------------------------------------------------------
// All pieces get what those have whose cells are split: the cell of each tetrahedron, and no global
// ids.
void SpooledMesh::FillCellNumbers(vtkUnstructuredGrid* grid, std::size_t piece) const
{
  constexpr const char* name = "OriginalCellIds";
  vtkCellData* data = grid->GetCellData();
  data->SetActiveAttribute(-1, vtkDataSetAttributes::GLOBALIDS);
  if (data->HasArray(name))
  {
    return;
  }
  vtkNew<vtkIdTypeArray> numbers;
  numbers->SetName(name);
  this->FillArray(numbers, this->CellNumbers, piece);
  data->AddArray(numbers);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkUnstructuredGrid> SpooledMesh::MakePiece(
  std::size_t piece, std::size_t step) const
{
  vtkUnstructuredGrid* const form = this->Mesh->GetTemplate(0);
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(form->GetPoints() ? form->GetPoints()->GetDataType() : VTK_FLOAT);
  if (form->GetPoints())
  {
    gatun::CopyNames(form->GetPoints()->GetData(), points->GetData());
  }
  this->FillArray(points->GetData(), this->Coordinates, piece);
  grid->SetPoints(points);
  const bool hasCells = piece < this->FirstUnused;
  if (hasCells && this->Mesh->HasWideIds())
  {
    this->FillCells<vtkTypeInt64Array>(grid, piece);
  }
  else if (hasCells)
  {
    this->FillCells<vtkTypeInt32Array>(grid, piece);
  }
  for (const int association : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    vtkDataSetAttributes* from = form->GetAttributes(association);
    vtkDataSetAttributes* to = grid->GetAttributes(association);
    const int count = from->GetNumberOfArrays();
    for (int i = 0; i < count; ++i)
    {
      vtkAbstractArray* model = from->GetAbstractArray(i);
      auto array = vtk::TakeSmartPointer(vtkDataArray::SafeDownCast(model->NewInstance()));
      array->SetNumberOfComponents(model->GetNumberOfComponents());
      gatun::CopyNames(model, array);
      this->FillArray(array,
        this->Arrays[association]
                    [step * static_cast<std::size_t>(count) + static_cast<std::size_t>(i)],
        piece);
      to->AddArray(array);
    }
    for (int type = 0; type < vtkDataSetAttributes::NUM_ATTRIBUTES; ++type)
    {
      vtkAbstractArray* active = from->GetAbstractAttribute(type);
      if (active && active->GetName())
      {
        to->SetActiveAttribute(active->GetName(), type);
      }
    }
  }
  if (this->Pieces.size() > 1)
  {
    this->FillJoinArray(grid, piece);
  }
  if (this->HasCellNumbers)
  {
    this->FillCellNumbers(grid, piece);
  }
  grid->GetFieldData()->ShallowCopy(this->Mesh->GetTemplate(step)->GetFieldData());
  return grid;
}
}
