// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunSurfaceTriangles.h"

#include "gatunArrayBridge.h"
#include "gatunError.h"
#include "gatunNewArray.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolygon.h"
#include "vtkUnsignedCharArray.h"

#include <limits>
#include <numeric>

namespace gatun
{
namespace
{
void CheckIds(vtkIdType count, const vtkIdType* ids, vtkIdType points)
{
  for (vtkIdType i = 0; i < count; ++i)
  {
    if (ids[i] < 0 || ids[i] >= points)
    {
      throw Error(ErrorCode::InvalidInput, "a cell has a point that does not exist");
    }
  }
}

bool IsGhost(vtkPolyData* surface, vtkIdType cell)
{
  vtkUnsignedCharArray* const ghosts = surface->GetCellGhostArray();
  return ghosts && cell < ghosts->GetNumberOfTuples() &&
    (ghosts->GetValue(cell) & vtkDataSetAttributes::DUPLICATECELL) != 0;
}

// vtkPolygon has no Triangulate(ids) since VTK 9.6, which was renamed in VTK 9.4.
template <typename Polygon>
concept HasLocalIds = requires(Polygon* polygon, vtkIdList* ids)
{
  polygon->TriangulateLocalIds(0, ids);
};

template <typename Polygon>
bool Triangulate(Polygon* polygon, vtkIdList* triples)
{
  if constexpr (HasLocalIds<Polygon>)
  {
    return polygon->TriangulateLocalIds(0, triples) != 0;
  }
  else
  {
    return polygon->Triangulate(triples) != 0;
  }
}

/** Divides polygons. */
class Divider
{
public:
  explicit Divider(vtkPoints* points)
    : Points(points)
  {
  }

  /** Returns triples of places in the polygon. */
  vtkIdList* Divide(vtkIdType count, const vtkIdType* ids)
  {
    this->Polygon->PointIds->SetNumberOfIds(count);
    this->Polygon->Points->SetNumberOfPoints(count);
    for (vtkIdType i = 0; i < count; ++i)
    {
      this->Polygon->PointIds->SetId(i, ids[i]);
      this->Polygon->Points->SetPoint(i, this->Points->GetPoint(ids[i]));
    }
    this->Triples->Reset();
    const bool isDone = Triangulate(this->Polygon.Get(), this->Triples.Get()) &&
      this->Triples->GetNumberOfIds() == 3 * (count - 2);
    if (!isDone)
    {
      // Without an area, any triangles are as good as others.
      this->Triples->Reset();
      for (vtkIdType i = 1; i + 1 < count; ++i)
      {
        this->Triples->InsertNextId(0);
        this->Triples->InsertNextId(i);
        this->Triples->InsertNextId(i + 1);
      }
    }
    return this->Triples;
  }

private:
  vtkPoints* Points;
  vtkNew<vtkPolygon> Polygon;
  vtkNew<vtkIdList> Triples;
};
}

//------------------------------------------------------------------------------
void ForEachOwnCell(vtkPolyData* surface, vtkCellArray* cells, vtkIdType first,
  const std::function<void(vtkIdType, vtkIdType, const vtkIdType*)>& body)
{
  for (vtkIdType i = 0; cells && i < cells->GetNumberOfCells(); ++i)
  {
    if (!IsGhost(surface, first + i))
    {
      vtkIdType count = 0;
      const vtkIdType* ids = nullptr;
      cells->GetCellAtId(i, count, ids);
      CheckIds(count, ids, surface->GetNumberOfPoints());
      body(first + i, count, ids);
    }
  }
}

//------------------------------------------------------------------------------
SurfaceTriangles::SurfaceTriangles(vtkPolyData* surface)
  : IsMarked(static_cast<std::size_t>(surface->GetNumberOfPoints()), 0)
{
  if (surface->GetNumberOfPoints() >= std::numeric_limits<std::uint32_t>::max())
  {
    throw Error(
      ErrorCode::InvalidInput, "more than four thousand million points cannot be simplified");
  }
  const auto add = [&](vtkIdType cell, vtkIdType a, vtkIdType b, vtkIdType c)
  {
    this->Corners.push_back({ static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b),
      static_cast<std::uint32_t>(c) });
    this->Cells.push_back(cell);
  };
  const auto mark = [&](vtkIdType, vtkIdType count, const vtkIdType* ids)
  {
    for (vtkIdType i = 0; i < count; ++i)
    {
      this->IsMarked[static_cast<std::size_t>(ids[i])] = 1;
    }
  };
  vtkIdType first = 0;
  ForEachOwnCell(surface, surface->GetVerts(), first, mark);
  first += surface->GetNumberOfVerts();
  ForEachOwnCell(surface, surface->GetLines(), first, mark);
  first += surface->GetNumberOfLines();
  const auto triangles = static_cast<std::size_t>(surface->GetNumberOfPolys());
  this->Corners.reserve(triangles);
  this->Cells.reserve(triangles);
  Divider divider(surface->GetPoints());
  ForEachOwnCell(surface, surface->GetPolys(), first,
    [&](vtkIdType cell, vtkIdType count, const vtkIdType* ids)
    {
      if (count == 3)
      {
        add(cell, ids[0], ids[1], ids[2]);
      }
      else if (count > 3)
      {
        vtkIdList* const triples = divider.Divide(count, ids);
        for (vtkIdType i = 0; i + 2 < triples->GetNumberOfIds(); i += 3)
        {
          add(cell, ids[triples->GetId(i)], ids[triples->GetId(i + 1)], ids[triples->GetId(i + 2)]);
        }
      }
    });
  first += surface->GetNumberOfPolys();
  ForEachOwnCell(surface, surface->GetStrips(), first,
    [&](vtkIdType cell, vtkIdType count, const vtkIdType* ids)
    {
      for (vtkIdType i = 0; i + 2 < count; ++i)
      {
        // Every other triangle has the other orientation.
        add(cell, ids[i], ids[i + 1 + i % 2], ids[i + 2 - i % 2]);
      }
    });
  this->FindPointsOfGhosts(surface);
}

//------------------------------------------------------------------------------
void SurfaceTriangles::FindPointsOfGhosts(vtkPolyData* surface)
{
  if (!surface->GetCellGhostArray())
  {
    return;
  }
  this->IsOfGhosts.assign(this->IsMarked.size(), 0);
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    if (IsGhost(surface, cell))
    {
      surface->GetCellPoints(cell, ids);
      CheckIds(ids->GetNumberOfIds(), ids->GetPointer(0), surface->GetNumberOfPoints());
      for (const vtkIdType id : *ids)
      {
        this->IsOfGhosts[static_cast<std::size_t>(id)] = 1;
      }
    }
  }
  for (std::size_t point = 0; point < this->IsMarked.size(); ++point)
  {
    this->IsOfGhosts[point] &= this->IsMarked[point] == 0 ? 1 : 0;
  }
  for (const Triangle& triangle : this->Corners)
  {
    for (const auto corner : triangle)
    {
      this->IsOfGhosts[corner] = 0;
    }
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeTriangleSurface(vtkPolyData* surface)
{
  vtkCellArray* const polygons = surface->GetPolys();
  bool isDivided = surface->GetNumberOfStrips() == 0;
  for (vtkIdType i = 0; isDivided && i < polygons->GetNumberOfCells(); ++i)
  {
    isDivided = polygons->GetCellSize(i) == 3;
  }
  if (isDivided)
  {
    return surface;
  }
  const SurfaceTriangles triangles(surface);
  CellCollector cells;
  cells.Reserve(triangles.Corners.size(), 3 * triangles.Corners.size());
  for (const SurfaceTriangles::Triangle& triangle : triangles.Corners)
  {
    cells.Add({ static_cast<vtkIdType>(triangle[0]), static_cast<vtkIdType>(triangle[1]),
      static_cast<vtkIdType>(triangle[2]) });
  }
  // The data of vertices and lines come first and stay.
  std::vector<vtkIdType> sources(
    static_cast<std::size_t>(surface->GetNumberOfVerts() + surface->GetNumberOfLines()));
  std::iota(sources.begin(), sources.end(), vtkIdType{ 0 });
  sources.insert(sources.end(), triangles.Cells.begin(), triangles.Cells.end());
  auto divided = vtkSmartPointer<vtkPolyData>::New();
  divided->SetPoints(surface->GetPoints());
  divided->SetVerts(surface->GetVerts());
  divided->SetLines(surface->GetLines());
  divided->SetPolys(cells.Make());
  divided->GetPointData()->ShallowCopy(surface->GetPointData());
  GatherAll(surface->GetCellData(), sources, divided->GetCellData());
  divided->GetFieldData()->ShallowCopy(surface->GetFieldData());
  return divided;
}
}
