// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunSimplifiedSurface.h"

#include "gatunCopyTuples.h"
#include "gatunNewArray.h"
#include "gatunParallel.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace gatun
{
namespace
{
/** Copies vertices or lines with new numbers of points. */
void CopyCells(vtkPolyData* surface, vtkCellArray* cells, vtkIdType first,
  const std::vector<vtkIdType>& places, CellCollector& output, vtkIdList* outputCells)
{
  ForEachOwnCell(surface, cells, first,
    [&](vtkIdType cell, vtkIdType count, const vtkIdType* ids)
    {
      for (vtkIdType i = 0; i < count; ++i)
      {
        output.AddPoint(places[static_cast<std::size_t>(ids[i])]);
      }
      output.EndCell();
      outputCells->InsertNextId(cell);
    });
}

}

//------------------------------------------------------------------------------
SimplifiedSurface::SimplifiedSurface(vtkPolyData* input, const MergeWeights& weights,
  const SurfaceMergeSettings& settings, const std::function<bool(double)>& progress)
  : Surface(vtkSmartPointer<vtkPolyData>::New())
  , Triangles(input)
{
  this->Surface->ShallowCopy(input);
  this->Tree = BuildMergeTree(
    input, this->Triangles.Corners, weights, settings, progress, this->Triangles.IsMarked);
}

//------------------------------------------------------------------------------
void SimplifiedSurface::Fill(const MergeTree& tree, std::size_t merges, vtkPolyData* output) const
{
  const auto ancestors = tree.FindAncestors(merges);
  std::vector<vtkIdType> places(ancestors.size(), -1);
  vtkNew<vtkIdList> kept;
  const auto& isLeftOut = this->Triangles.IsOfGhosts;
  for (std::size_t i = 0; i < ancestors.size(); ++i)
  {
    if (ancestors[i] == i && (isLeftOut.empty() || isLeftOut[i] == 0))
    {
      places[i] = kept->InsertNextId(static_cast<vtkIdType>(i));
    }
  }
  vtkNew<vtkPoints> points;
  if (this->Surface->GetPoints())
  {
    points->SetDataType(this->Surface->GetPoints()->GetDataType());
    SizePoints(points, kept->GetNumberOfIds());
    this->Surface->GetPoints()->GetPoints(kept, points);
  }
  output->SetPoints(points);
  CopyTuples(this->Surface->GetPointData(), kept, output->GetPointData());

  vtkNew<vtkIdList> cells;
  CellCollector verts;
  CellCollector lines;
  CopyCells(this->Surface, this->Surface->GetVerts(), 0, places, verts, cells);
  CopyCells(this->Surface, this->Surface->GetLines(), this->Surface->GetNumberOfVerts(), places,
    lines, cells);
  const vtkIdType before = cells->GetNumberOfIds();

  // Parts of the triangles, one after the other in the output.
  const auto& triangles = this->Triangles.Corners;
  const std::size_t parts = std::max<std::size_t>(1, triangles.size() >> 15);
  const auto getFirst = [&](std::size_t part) { return triangles.size() * part / parts; };
  const auto find = [&](std::size_t i, SurfaceTriangles::Triangle& triangle)
  {
    triangle = triangles[i];
    return Simplify(triangle, ancestors);
  };
  std::vector<vtkIdType> starts(parts + 1, 0);
  ParallelFor(parts,
    [&](std::size_t part)
    {
      SurfaceTriangles::Triangle triangle{};
      for (auto i = getFirst(part); i < getFirst(part + 1); ++i)
      {
        starts[part + 1] += find(i, triangle) ? 1 : 0;
      }
    });
  for (std::size_t part = 0; part < parts; ++part)
  {
    starts[part + 1] += starts[part];
  }
  const vtkIdType left = starts[parts];
  vtkNew<vtkIdTypeArray> corners;
  vtkNew<vtkIdTypeArray> offsets;
  SizeArray(corners, 3 * left);
  SizeArray(offsets, left + 1);
  vtkNew<vtkIdList> allCells;
  allCells->SetNumberOfIds(before + left);
  std::copy_n(cells->GetPointer(0), before, allCells->GetPointer(0));
  vtkIdType* const corner = corners->GetPointer(0);
  vtkIdType* const offset = offsets->GetPointer(0);
  vtkIdType* const cell = allCells->GetPointer(before);
  ParallelFor(parts,
    [&](std::size_t part)
    {
      vtkIdType at = starts[part];
      SurfaceTriangles::Triangle triangle{};
      for (auto i = getFirst(part); i < getFirst(part + 1); ++i)
      {
        if (find(i, triangle))
        {
          offset[at] = 3 * at;
          cell[at] = this->Triangles.Cells[i];
          for (std::size_t j = 0; j < 3; ++j)
          {
            corner[3 * at + static_cast<vtkIdType>(j)] = places[triangle[j]];
          }
          ++at;
        }
      }
    });
  offset[left] = 3 * left;
  vtkNew<vtkCellArray> polys;
  polys->SetData(offsets, corners);
  output->SetVerts(verts.Make());
  output->SetLines(lines.Make());
  output->SetPolys(polys);
  CopyTuples(this->Surface->GetCellData(), allCells, output->GetCellData());
  output->GetFieldData()->ShallowCopy(this->Surface->GetFieldData());
}
}
