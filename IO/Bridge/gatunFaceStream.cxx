// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunFaceStream.h"

#include "gatunError.h"
#include "gatunNewArray.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <string>
#include <vector>

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
void Append(std::vector<vtkIdType>& stream, vtkIdType cell, vtkIdList* list, vtkCellArray* faces)
{
  stream.push_back(list->GetNumberOfIds());
  vtkNew<vtkIdList> corners;
  for (const vtkIdType face : *list)
  {
    if (face < 0 || face >= faces->GetNumberOfCells())
    {
      ThrowInvalid("the polyhedron " + std::to_string(cell) + " names face " +
        std::to_string(face) + " of " + std::to_string(faces->GetNumberOfCells()));
    }
    faces->GetCellAtId(face, corners);
    stream.push_back(corners->GetNumberOfIds());
    for (const vtkIdType corner : *corners)
    {
      stream.push_back(corner);
    }
  }
}

[[maybe_unused]] FaceStream MakeStream(
  vtkUnstructuredGrid* grid, vtkCellArray* lists, vtkCellArray* faces)
{
  std::vector<vtkIdType> values;
  std::vector<vtkIdType> locations;
  locations.reserve(static_cast<std::size_t>(lists->GetNumberOfCells()));
  vtkNew<vtkIdList> list;
  for (vtkIdType cell = 0; cell < lists->GetNumberOfCells(); ++cell)
  {
    lists->GetCellAtId(cell, list);
    const bool isPolyhedron = grid->GetCellType(cell) == VTK_POLYHEDRON;
    locations.push_back(isPolyhedron ? static_cast<vtkIdType>(values.size()) : -1);
    if (isPolyhedron)
    {
      Append(values, cell, list, faces);
    }
  }
  return { MakeArray<vtkIdTypeArray>(values), MakeArray<vtkIdTypeArray>(locations) };
}

/** The reverse. */
void Divide(const FaceStream& stream, CellCollector& lists, CellCollector& faces)
{
  for (vtkIdType cell = 0; cell < stream.Locations->GetNumberOfValues(); ++cell)
  {
    vtkIdType at = stream.Locations->GetValue(cell);
    const vtkIdType count = at < 0 ? 0 : stream.Values->GetValue(at++);
    for (vtkIdType i = 0; i < count; ++i)
    {
      lists.AddPoint(static_cast<vtkIdType>(faces.GetNumberOfCells()));
      for (vtkIdType size = stream.Values->GetValue(at++); size > 0; --size)
      {
        faces.AddPoint(stream.Values->GetValue(at++));
      }
      faces.EndCell();
    }
    lists.EndCell();
  }
}

template <typename Grid>
FaceStream StreamOf(Grid* grid)
{
  if constexpr (HasFaceCells<Grid>)
  {
    vtkCellArray* const lists = grid->GetPolyhedronFaceLocations();
    vtkCellArray* const faces = grid->GetPolyhedronFaces();
    return lists && faces ? MakeStream(grid, lists, faces) : FaceStream{};
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
    CellCollector lists;
    CellCollector faces;
    Divide(stream, lists, faces);
    grid->SetPolyhedralCells(types, cells, lists.Make(), faces.Make());
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
