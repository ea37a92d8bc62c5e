// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunChunkTable.h"

#include "gatunFileReader.h"

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkTable.h"

#include <algorithm>
#include <string>

namespace
{

//------------------------------------------------------------------------------
vtkIdTypeArray* AddIdColumn(vtkTable* table, const char* name, vtkIdType rows)
{
  vtkNew<vtkIdTypeArray> column;
  column->SetName(name);
  column->SetNumberOfValues(rows);
  table->AddColumn(column);
  return column;
}

//------------------------------------------------------------------------------
void AddRanges(vtkTable* table, const gatun::FileReader& file, std::size_t array)
{
  const gatun::ArrayDescription& description = file.GetArrays()[array];
  const std::size_t ranges =
    description.Components > 1 ? description.Components + std::size_t{ 1 } : std::size_t{ 1 };
  const std::size_t chunks = file.GetChunks().size();

  vtkNew<vtkDoubleArray> column;
  const bool ofPoints = description.Where == gatun::Association::Point;
  column->SetName(((ofPoints ? "Point:" : "Cell:") + description.Name).c_str());
  column->SetNumberOfComponents(static_cast<int>(2 * ranges));
  column->SetNumberOfTuples(static_cast<vtkIdType>(chunks));
  std::vector<gatun::Range> all(ranges * chunks);
  for (std::size_t step = 0; step < file.GetNumberOfSteps(); ++step)
  {
    for (std::size_t chunk = 0; chunk < chunks; ++chunk)
    {
      const gatun::ArrayRanges ofChunk = file.GetChunkRanges(array, step, chunk);
      for (std::size_t i = 0; i < ranges; ++i)
      {
        all[ranges * chunk + i].Include(ofChunk[i]);
      }
    }
  }
  double* values = column->GetPointer(0);
  for (const gatun::Range& range : all)
  {
    *values++ = range.Min;
    *values++ = range.Max;
  }
  table->AddColumn(column);
}

} // anonymous namespace

namespace gatun
{

//------------------------------------------------------------------------------
vtkSmartPointer<vtkTable> MakeChunkTable(const FileReader& file)
{
  const auto& chunks = file.GetChunks();
  const auto rows = static_cast<vtkIdType>(chunks.size());
  auto table = vtkSmartPointer<vtkTable>::New();
  vtkIdTypeArray* cells = AddIdColumn(table, "Cells", rows);
  vtkIdTypeArray* firstCells = AddIdColumn(table, "FirstCell", rows);
  vtkIdTypeArray* points = AddIdColumn(table, "Points", rows);
  vtkNew<vtkDoubleArray> bounds;
  bounds->SetName("Bounds");
  bounds->SetNumberOfComponents(6);
  bounds->SetNumberOfTuples(rows);
  for (vtkIdType row = 0; row < rows; ++row)
  {
    const ChunkInfo& chunk = chunks[static_cast<std::size_t>(row)];
    cells->SetValue(row, static_cast<vtkIdType>(chunk.Tets));
    firstCells->SetValue(row, static_cast<vtkIdType>(chunk.FirstTet));
    points->SetValue(
      row, static_cast<vtkIdType>(chunk.OwnPoints) + static_cast<vtkIdType>(chunk.SharedPoints));
    Bounds box = chunk.Box;
    for (std::size_t step = 1; file.HasMovingPoints() && step < file.GetNumberOfSteps(); ++step)
    {
      box.Include(file.GetChunkBounds(static_cast<std::size_t>(row), 0, step));
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      bounds->SetTypedComponent(row, 2 * axis, box[axis].Min);
      bounds->SetTypedComponent(row, 2 * axis + 1, box[axis].Max);
    }
  }
  table->AddColumn(bounds);
  for (std::size_t array = 0; array < file.GetArrays().size(); ++array)
  {
    AddRanges(table, file, array);
  }
  return table;
}

}
