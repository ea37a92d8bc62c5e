// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunSurfaceOutput.h"

#include "gatunArrayBridge.h"
#include "gatunStrips.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTypeInt64Array.h"

#include <numeric>

namespace gatun
{
namespace
{
vtkSmartPointer<vtkCellArray> MakeTriangles(const Surface& surface)
{
  const auto count = static_cast<vtkIdType>(surface.GetNumberOfTriangles());
  vtkNew<vtkTypeInt64Array> offsets;
  offsets->SetNumberOfValues(count + 1);
  for (vtkIdType i = 0; i <= count; ++i)
  {
    offsets->SetValue(i, 3 * i);
  }
  vtkNew<vtkTypeInt64Array> connectivity;
  connectivity->SetNumberOfValues(3 * count);
  vtkTypeInt64* to = connectivity->GetPointer(0);
  for (const auto& triangle : surface.GetTriangles())
  {
    to = std::copy(triangle.begin(), triangle.end(), to);
  }
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, connectivity);
  return cells;
}

vtkSmartPointer<vtkCellArray> MakeStripCells(const Surface& surface)
{
  const auto strips = MakeStrips(surface.GetTriangles());
  const auto length = std::accumulate(strips.begin(), strips.end(), std::size_t{ 0 },
    [](std::size_t sum, const auto& strip) { return sum + strip.size(); });
  vtkNew<vtkTypeInt64Array> offsets;
  offsets->SetNumberOfValues(static_cast<vtkIdType>(strips.size()) + 1);
  vtkNew<vtkTypeInt64Array> connectivity;
  connectivity->SetNumberOfValues(static_cast<vtkIdType>(length));
  vtkTypeInt64* const first = connectivity->GetPointer(0);
  vtkTypeInt64* to = first;
  offsets->SetValue(0, 0);
  vtkIdType number = 0;
  for (const auto& strip : strips)
  {
    to = std::copy(strip.begin(), strip.end(), to);
    offsets->SetValue(++number, to - first);
  }
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, connectivity);
  return cells;
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
  points->SetNumberOfPoints(count);
  surface.FillPoints(points->GetVoidPointer(0));
  output->SetPoints(points);
  AddArrays(surface, content, output);
  if (content.Normals)
  {
    vtkNew<vtkFloatArray> normals;
    normals->SetName("Normals");
    normals->SetNumberOfComponents(3);
    normals->SetNumberOfTuples(count);
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
