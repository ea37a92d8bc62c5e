// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// What C++ sees of the reader and the writer: every property is printed, the mesh comes in the
// caller's own order and types, and the chunk table can be had as information.

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArraySelection.h"
#include "vtkErrorCode.h"
#include "vtkFloatArray.h"
#include "vtkGatunErrorCode.h"
#include "vtkGatunMergeBlocks.h"
#include "vtkGatunReader.h"
#include "vtkGatunSplitBlocks.h"
#include "vtkGatunWriter.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkLongLongArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkTable.h"
#include "vtkTestUtilities.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVariant.h"

#include <cstdlib>
#include <iostream>
#include <sstream>
#include <string>

namespace
{

int failures = 0;

void Check(bool right, const std::string& what)
{
  if (!right)
  {
    std::cerr << "Wrong: " << what << "\n";
    ++failures;
  }
}

void CheckPrinted(vtkObject* object, std::initializer_list<const char*> names)
{
  std::ostringstream text;
  object->Print(text);
  for (const char* name : names)
  {
    Check(text.str().find(std::string(name) + ":") != std::string::npos,
      std::string(object->GetClassName()) + " does not print " + name);
  }
}

// A row of tetrahedra, each sharing a face with the next.
vtkNew<vtkUnstructuredGrid> MakeGrid(vtkIdType tets)
{
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> heat;
  vtkNew<vtkLongLongArray> number;
  heat->SetName("heat");
  number->SetName("number");
  grid->SetPoints(points);
  grid->Allocate(tets);
  for (vtkIdType i = 0; i < tets + 3; ++i)
  {
    const double t = static_cast<double>(i);
    points->InsertNextPoint(0.1 * t, t / 3 - static_cast<double>(i / 3), 0.5 * (i % 2));
    heat->InsertNextValue(static_cast<float>(t * t));
  }
  for (vtkIdType i = 0; i < tets; ++i)
  {
    const vtkIdType corners[4] = { i, i + 1, i + 2, i + 3 };
    grid->InsertNextCell(VTK_TETRA, 4, corners);
    number->InsertNextValue(-i);
  }
  grid->GetPointData()->SetScalars(heat);
  grid->GetCellData()->AddArray(number);
  return grid;
}

} // anonymous namespace

int TestReaderInterface(int argc, char* argv[])
{
  char* temporary =
    vtkTestUtilities::GetArgOrEnvOrDefault("-T", argc, argv, "VTK_TEMP_DIR", "Testing/Temporary");
  const std::string path = std::string(temporary) + "/interface.gtn";
  delete[] temporary;

  constexpr vtkIdType tets = 1000;
  const auto grid = MakeGrid(tets);
  vtkNew<vtkGatunWriter> writer;
  writer->SetInputData(grid);
  writer->SetFileName(path.c_str());
  writer->SetKeepOrderToAll();
  writer->SetChunkSize(100);
  Check(writer->Write() == 1 && writer->GetErrorCode() == vtkErrorCode::NoError, "writing");
  Check(writer->GetStatistics()->GetValueByName(0, "Cells").ToInt() == 1000, "statistics");

  vtkNew<vtkGatunReader> reader;
  reader->SetFileName(path.c_str());
  reader->UpdateInformation();
  auto* table =
    vtkTable::SafeDownCast(reader->GetOutputInformation(0)->Get(vtkGatunReader::CHUNK_TABLE()));
  Check(table && table == reader->GetChunkTable() && table->GetNumberOfRows() >= 10, "chunk table");
  Check(table && table->GetColumnByName("Point:heat") && table->GetColumnByName("Cell:number"),
    "ranges in the chunk table");

  reader->Update();
  vtkUnstructuredGrid* output = reader->GetOutput();
  Check(output->GetNumberOfCells() == tets && output->GetNumberOfPoints() == tets + 3, "counts");
  auto* heat = vtkFloatArray::SafeDownCast(output->GetPointData()->GetScalars());
  auto* number = vtkLongLongArray::SafeDownCast(output->GetCellData()->GetAbstractArray("number"));
  Check(heat && number, "types of arrays");
  for (vtkIdType i = 0; heat && number && i < tets; ++i)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    output->GetCellPoints(i, size, corners);
    double here[3];
    double there[3];
    output->GetPoint(i, here);
    grid->GetPoint(i, there);
    Check(size == 4 && corners[0] == i && corners[3] == i + 3 && here[0] == there[0] &&
        here[1] == there[1] && here[2] == there[2] && number->GetValue(i) == -i &&
        heat->GetValue(i) == static_cast<float>(i * i),
      "cell " + std::to_string(i));
  }

  CheckPrinted(reader,
    { "FileName", "RestoreOrder", "SplitCells", "Box", "ValueRangeArray", "ValueRange",
      "MemoryBudget", "PrefetchTimeSteps", "LargeMesh", "SimplificationRatio", "Statistics",
      "PointDataArraySelection", "CellDataArraySelection" });
  CheckPrinted(writer,
    { "FileName", "KeepOrder", "ChunkSize", "KeyStepInterval", "ArrayTolerances", "Hierarchy",
      "LayerArray", "WriteAllTimeSteps", "SplitCells", "PointTolerance", "NumberOfPieces",
      "Statistics", "PointDataArraySelection", "CellDataArraySelection" });
  const auto nameOf = [](unsigned long code)
  { return std::string(vtkGatunErrorCode::GetStringFromErrorCode(code)); };
  Check(nameOf(vtkGatunErrorCode::UnsupportedVersionError) == "UnsupportedVersionError" &&
      nameOf(vtkGatunErrorCode::InvalidInputError) == "InvalidInputError" &&
      nameOf(vtkGatunErrorCode::AbortedError) == "AbortedError" &&
      nameOf(vtkErrorCode::FileNotFoundError) ==
        vtkErrorCode::GetStringFromErrorCode(vtkErrorCode::FileNotFoundError),
    "names of error codes");
  vtkNew<vtkGatunMergeBlocks> merge;
  CheckPrinted(merge, { "MergeCoincidentPoints" });
  vtkNew<vtkGatunSplitBlocks> split;
  CheckPrinted(split, {});
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
