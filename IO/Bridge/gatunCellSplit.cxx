// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunCellSplit.h"

#include "gatunArrayBridge.h"
#include "gatunError.h"
#include "gatunFaceStream.h"
#include "gatunParallel.h"
#include "gatunPointSet.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cstddef>
#include <string>

namespace gatun
{
namespace
{
[[noreturn]] void ThrowPolyhedron(vtkIdType cell, const std::string& what)
{
  ThrowInvalid("the polyhedron " + std::to_string(cell) + " " + what);
}

/** Splits cells one after the other. One for each thread. */
template <typename T>
class Splitter
{
public:
  Splitter(vtkUnstructuredGrid* grid, const FaceStream& polyhedra, const PointOrder<T>& order,
    SplitCells& result)
    : Grid(grid)
    , Polyhedra(polyhedra)
    , Order(order)
    , Result(result)
    , Iterator(vtk::TakeSmartPointer(grid->GetCells()->NewIterator()))
  {
  }

  void Split(vtkIdType cell)
  {
    const int type = this->Grid->GetCellType(cell);
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    this->Iterator->GetCellAtId(cell, size, corners);
    const CellKind kind = GetCellKind(type);
    if (kind.Shape && kind.Shape->Corners == 4)
    {
      this->Add(corners, cell);
      return;
    }
    if (type == ConvexPointSetType)
    {
      SetHullFaces(this->Faces, { corners, static_cast<std::size_t>(size) }, this->Order);
    }
    else if (kind.Shape)
    {
      this->Faces.Set(*kind.Shape, corners);
    }
    else
    {
      this->ReadPolyhedron(cell);
    }
    SplitCell(
      this->Faces, this->Order, this->Space, [&](const auto& tet) { this->Add(tet.data(), cell); });
  }

private:
  void Add(const vtkIdType* corners, vtkIdType cell)
  {
    this->Result.Corners.insert(this->Result.Corners.end(), corners, corners + 4);
    this->Result.Cells.push_back(cell);
  }

  void ReadPolyhedron(vtkIdType cell)
  {
    vtkIdTypeArray* const stream = this->Polyhedra.Values;
    vtkIdTypeArray* const places = this->Polyhedra.Locations;
    if (!stream || places->GetNumberOfValues() <= cell)
    {
      ThrowPolyhedron(cell, "has no faces");
    }
    const vtkIdType end = stream->GetNumberOfValues();
    vtkIdType at = places->GetValue(cell);
    const auto next = [&]
    {
      if (at < 0 || at >= end)
      {
        ThrowPolyhedron(cell, "has faces that are not in the list of faces");
      }
      return stream->GetValue(at++);
    };
    this->Faces.Clear();
    for (vtkIdType faces = next(); faces > 0; --faces)
    {
      const vtkIdType corners = next();
      if (corners < 0 || corners > end - at)
      {
        ThrowPolyhedron(cell, "has a face of " + std::to_string(corners) + " points");
      }
      const std::span<const vtkIdType> ids(
        stream->GetPointer(at), static_cast<std::size_t>(corners));
      at += corners;
      const auto wrong = std::find_if(ids.begin(), ids.end(),
        [&](vtkIdType id) { return id < 0 || id >= this->Grid->GetNumberOfPoints(); });
      if (wrong != ids.end())
      {
        ThrowPolyhedron(cell,
          "names point " + std::to_string(*wrong) + " of " +
            std::to_string(this->Grid->GetNumberOfPoints()));
      }
      this->Faces.Add(ids, [](vtkIdType id) { return id; });
    }
    this->Faces.Align();
  }

  vtkUnstructuredGrid* const Grid;
  const FaceStream& Polyhedra;
  const PointOrder<T>& Order;
  SplitCells& Result;
  vtkSmartPointer<vtkCellArrayIterator> Iterator;
  CellFaces<vtkIdType> Faces;
  SplitSpace<vtkIdType> Space;
};

template <typename T>
SplitCells SplitBy(
  const T* coordinates, vtkUnstructuredGrid* grid, std::span<const vtkIdType> cells)
{
  constexpr std::size_t length = std::size_t{ 1 } << 14;
  const PointOrder<T> order(coordinates);
  const FaceStream polyhedra = GetFaceStream(grid);
  std::vector<SplitCells> parts((cells.size() + length - 1) / length);
  ParallelFor(parts.size(),
    [&](std::size_t part)
    {
      Splitter<T> splitter(grid, polyhedra, order, parts[part]);
      const std::size_t first = part * length;
      for (const vtkIdType cell : cells.subspan(first, std::min(length, cells.size() - first)))
      {
        splitter.Split(cell);
      }
    });
  SplitCells all;
  std::size_t tets = 0;
  for (const SplitCells& part : parts)
  {
    tets += part.Cells.size();
  }
  all.Corners.reserve(4 * tets);
  all.Cells.reserve(tets);
  for (SplitCells& part : parts)
  {
    all.Corners.insert(all.Corners.end(), part.Corners.begin(), part.Corners.end());
    all.Cells.insert(all.Cells.end(), part.Cells.begin(), part.Cells.end());
    part = {};
  }
  return all;
}
}

//------------------------------------------------------------------------------
SplitCells SplitIntoTets(vtkUnstructuredGrid* grid, std::span<const vtkIdType> cells)
{
  if (cells.empty() || !grid->GetPoints())
  {
    return {}; // without points, there are only polyhedra and point sets that have none
  }
  vtkDataArray* const points = grid->GetPoints()->GetData();
  if (points->GetDataType() == VTK_FLOAT)
  {
    const auto plain = Contiguous(points);
    return SplitBy(static_cast<const float*>(plain->GetVoidPointer(0)), grid, cells);
  }
  vtkSmartPointer<vtkDataArray> doubles = Contiguous(points);
  if (points->GetDataType() != VTK_DOUBLE)
  {
    doubles = vtkSmartPointer<vtkDoubleArray>::New();
    doubles->DeepCopy(points);
  }
  return SplitBy(static_cast<const double*>(doubles->GetVoidPointer(0)), grid, cells);
}
}
