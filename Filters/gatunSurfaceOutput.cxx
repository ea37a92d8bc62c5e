// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunSurfaceOutput.h"

#include "gatunArrayBridge.h"
#include "gatunNewArray.h"
#include "gatunStrips.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <type_traits>

namespace gatun
{
namespace
{
/** Fills cells with lists of points. count: of all points in them. Ids take 32 bits if they fit. */
template <typename Fill>
vtkSmartPointer<vtkCellArray> MakeCells(std::size_t cells, std::size_t count, Fill&& fill)
{
  const auto make = [&](auto* offsets, auto* connectivity)
  {
    SizeArray(offsets, static_cast<vtkIdType>(cells) + 1);
    SizeArray(connectivity, static_cast<vtkIdType>(count));
    fill(offsets->GetPointer(0), connectivity->GetPointer(0));
    auto made = vtkSmartPointer<vtkCellArray>::New();
    made->SetData(offsets, connectivity);
    return made;
  };
  if (count <= static_cast<std::size_t>(VTK_TYPE_INT32_MAX))
  {
    return make(vtkNew<vtkTypeInt32Array>().GetPointer(), vtkNew<vtkTypeInt32Array>().GetPointer());
  }
  return make(vtkNew<vtkTypeInt64Array>().GetPointer(), vtkNew<vtkTypeInt64Array>().GetPointer());
}

vtkSmartPointer<vtkCellArray> MakeTriangles(const Surface& surface)
{
  const std::size_t triangles = surface.GetNumberOfTriangles();
  return MakeCells(triangles, 3 * triangles,
    [&](auto* offsets, auto* connectivity)
    {
      for (std::size_t i = 0; i <= triangles; ++i)
      {
        offsets[i] = static_cast<std::remove_pointer_t<decltype(offsets)>>(3 * i);
      }
      surface.FillTriangles(connectivity, sizeof(*connectivity) == sizeof(std::int64_t));
    });
}

vtkSmartPointer<vtkCellArray> MakeStripCells(const Surface& surface)
{
  const auto strips = MakeStrips(surface.GetTriangles());
  const auto length = std::accumulate(strips.begin(), strips.end(), std::size_t{ 0 },
    [](std::size_t sum, const auto& strip) { return sum + strip.size(); });
  return MakeCells(strips.size(), length,
    [&](auto* offsets, auto* connectivity)
    {
      using Id = std::remove_pointer_t<decltype(connectivity)>;
      auto* to = connectivity;
      *offsets = 0;
      for (const auto& strip : strips)
      {
        to = std::transform(strip.begin(), strip.end(), to,
          [](std::uint32_t point) { return static_cast<Id>(point); });
        *++offsets = static_cast<Id>(to - connectivity);
      }
    });
}

void AddArrays(const Surface& surface, const SurfaceOutput& content, vtkPolyData* output)
{
  std::size_t pointArrays = 0;
  std::size_t cellArrays = 0;
  for (const ArrayDescription& array : content.Arrays)
  {
    const bool ofPoints = array.Where == Association::Point;
    if (!ofPoints && content.Strips)
    {
      continue;
    }
    const auto tupleSize = SizeOf(array.Type) * array.Components;
    ArrayFiller filler(array,
      static_cast<vtkIdType>(
        ofPoints ? surface.GetNumberOfPoints() : surface.GetNumberOfTriangles()));
    if (ofPoints)
    {
      surface.FillPointArray(pointArrays++, tupleSize, filler.GetBuffer());
      AddWithRoles(output->GetPointData(), filler.Finish(), array.AttributeRoles);
    }
    else
    {
      surface.FillCellArray(cellArrays++, tupleSize, filler.GetBuffer());
      AddWithRoles(output->GetCellData(), filler.Finish(), array.AttributeRoles);
    }
  }
}
}

//------------------------------------------------------------------------------
void FillPolyData(const Surface& surface, const SurfaceOutput& content, vtkPolyData* output)
{
  const auto count = static_cast<vtkIdType>(surface.GetNumberOfPoints());
  vtkNew<vtkPoints> points;
  points->SetDataType(content.CoordinateType == ScalarType::Float32 ? VTK_FLOAT : VTK_DOUBLE);
  SizePoints(points, count);
  surface.FillPoints(points->GetData()->GetVoidPointer(0));
  output->SetPoints(points);
  AddArrays(surface, content, output);
  if (content.Normals)
  {
    vtkNew<vtkFloatArray> normals;
    normals->SetName("Normals");
    normals->SetNumberOfComponents(3);
    SizeArray(normals, count);
    surface.FillNormals(normals->GetPointer(0));
    output->GetPointData()->SetNormals(normals);
  }
  if (content.Strips)
  {
    output->SetStrips(MakeStripCells(surface));
  }
  else
  {
    output->SetPolys(MakeTriangles(surface));
  }
}
}
