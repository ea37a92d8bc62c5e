// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunFaceStream.h"

#include "gatunError.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <string>

namespace gatun
{
namespace
{
template <typename Grid>
concept HasFaceCells = requires(Grid* grid)
{
  grid->GetPolyhedronFaces();
};

/** Appends a polyhedron with some of these faces to a stream. */
void Append(vtkIdTypeArray* stream, vtkIdType cell, vtkIdList* list, vtkCellArray* faces)
{
  stream->InsertNextValue(list->GetNumberOfIds());
  vtkNew<vtkIdList> corners;
  for (const vtkIdType face : *list)
  {
    if (face < 0 || face >= faces->GetNumberOfCells())
    {
      ThrowInvalid("the polyhedron " + std::to_string(cell) + " names face " +
        std::to_string(face) + " of " + std::to_string(faces->GetNumberOfCells()));
    }
    faces->GetCellAtId(face, corners);
    stream->InsertNextValue(corners->GetNumberOfIds());
    for (const vtkIdType corner : *corners)
    {
      stream->InsertNextValue(corner);
    }
  }
}

FaceStream MakeStream(vtkCellArray* lists, vtkCellArray* faces)
{
  FaceStream stream{ vtkSmartPointer<vtkIdTypeArray>::New(),
    vtkSmartPointer<vtkIdTypeArray>::New() };
  stream.Locations->SetNumberOfValues(lists->GetNumberOfCells());
  vtkNew<vtkIdList> list;
  for (vtkIdType cell = 0; cell < lists->GetNumberOfCells(); ++cell)
  {
    lists->GetCellAtId(cell, list);
    const bool isPolyhedron = list->GetNumberOfIds() > 0;
    stream.Locations->SetValue(cell, isPolyhedron ? stream.Values->GetNumberOfValues() : -1);
    if (isPolyhedron)
    {
      Append(stream.Values, cell, list, faces);
    }
  }
  return stream;
}

/** The reverse. */
void Divide(const FaceStream& stream, vtkCellArray* lists, vtkCellArray* faces)
{
  for (vtkIdType cell = 0; cell < stream.Locations->GetNumberOfValues(); ++cell)
  {
    vtkIdType at = stream.Locations->GetValue(cell);
    const vtkIdType count = at < 0 ? 0 : stream.Values->GetValue(at++);
    lists->InsertNextCell(static_cast<int>(count));
    for (vtkIdType i = 0; i < count; ++i)
    {
      const vtkIdType size = stream.Values->GetValue(at++);
      lists->InsertCellPoint(faces->InsertNextCell(size, stream.Values->GetPointer(at)));
      at += size;
    }
  }
}

template <typename Grid>
FaceStream StreamOf(Grid* grid)
{
  if constexpr (HasFaceCells<Grid>)
  {
    vtkCellArray* const lists = grid->GetPolyhedronFaceLocations();
    vtkCellArray* const faces = grid->GetPolyhedronFaces();
    return lists && faces ? MakeStream(lists, faces) : FaceStream{};
  }
  else
  {
    if (grid->GetFaces() && grid->GetFaceLocations())
    {
      return { grid->GetFaces(), grid->GetFaceLocations() };
    }
    return {};
  }
}

template <typename Grid>
void SetCellsOf(
  Grid* grid, vtkUnsignedCharArray* types, vtkCellArray* cells, const FaceStream& stream)
{
  if (!stream.Values)
  {
    grid->SetCells(types, cells);
  }
  else if constexpr (HasFaceCells<Grid>)
  {
    vtkNew<vtkCellArray> lists;
    vtkNew<vtkCellArray> faces;
    Divide(stream, lists, faces);
    grid->SetPolyhedralCells(types, cells, lists, faces);
  }
  else
  {
    grid->SetCells(types, cells, stream.Locations, stream.Values);
  }
}
}

//------------------------------------------------------------------------------
FaceStream GetFaceStream(vtkUnstructuredGrid* grid)
{
  return StreamOf(grid);
}

//------------------------------------------------------------------------------
void SetCells(vtkUnstructuredGrid* grid, vtkUnsignedCharArray* types, vtkCellArray* cells,
  const FaceStream& faces)
{
  SetCellsOf(grid, types, cells, faces);
}
}
