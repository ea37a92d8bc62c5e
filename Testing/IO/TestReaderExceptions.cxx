// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Whatever is thrown while the reader works ends in the reader: as an error code and a message,
// with an empty output; and the next update is as good as the first.

#include "vtkCallbackCommand.h"
#include "vtkCellType.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkGatunReader.h"
#include "vtkGatunWriter.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkTestUtilities.h"
#include "vtkUnstructuredGrid.h"

#include <cstdlib>
#include <iostream>
#include <new>
#include <stdexcept>
#include <string>

namespace
{

constexpr vtkIdType Tets = 1000;

void WriteFile(const std::string& path)
{
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkPoints> points;
  grid->SetPoints(points);
  grid->Allocate(Tets);
  for (vtkIdType i = 0; i < Tets + 3; ++i)
  {
    const double t = static_cast<double>(i);
    points->InsertNextPoint(0.1 * t, t / 3 - static_cast<double>(i / 3), 0.5 * (i % 2));
  }
  for (vtkIdType i = 0; i < Tets; ++i)
  {
    const vtkIdType corners[4] = { i, i + 1, i + 2, i + 3 };
    grid->InsertNextCell(VTK_TETRA, 4, corners);
  }
  vtkNew<vtkGatunWriter> writer;
  writer->SetInputData(grid);
  writer->SetFileName(path.c_str());
  writer->SetChunkSize(100);
  if (writer->Write() != 1)
  {
    std::cerr << "cannot write " << path << "\n";
    std::exit(EXIT_FAILURE);
  }
}

// Throws one of several things at one of the reader's reports of progress. Those of the beginning
// and the end may be the executive's own.
struct Thrower
{
  int At = 0;
  int Kind = 0;
  int Reports = 0;

  static void Report(vtkObject*, unsigned long, void* data, void* progress)
  {
    auto* self = static_cast<Thrower*>(data);
    const double done = *static_cast<double*>(progress);
    if (done > 0 && done < 1 && self->Reports++ == self->At)
    {
      switch (self->Kind)
      {
        case 0:
          throw std::bad_alloc();
        case 1:
          throw std::runtime_error("a reason");
        default:
          throw 17;
      }
    }
  }
};

void NoteError(vtkObject*, unsigned long, void* notes, void* text)
{
  *static_cast<std::string*>(notes) += static_cast<const char*>(text);
}

} // anonymous namespace

int TestReaderExceptions(int argc, char* argv[])
{
  char* temporary =
    vtkTestUtilities::GetArgOrEnvOrDefault("-T", argc, argv, "VTK_TEMP_DIR", "Testing/Temporary");
  const std::string path = std::string(temporary) + "/exceptions.gtn";
  delete[] temporary;
  WriteFile(path);

  const char* const reasons[] = { "not enough memory", "a reason", "failed for an unknown reason" };
  int thrown = 0;
  for (int kind = 0; kind < 3; ++kind)
  {
    for (int at = 0;; ++at)
    {
      Thrower thrower{ at, kind };
      std::string notes;
      vtkNew<vtkCallbackCommand> report;
      report->SetCallback(Thrower::Report);
      report->SetClientData(&thrower);
      vtkNew<vtkCallbackCommand> note;
      note->SetCallback(NoteError);
      note->SetClientData(&notes);
      vtkNew<vtkCallbackCommand> ignore;
      vtkNew<vtkGatunReader> reader;
      reader->AddObserver("ProgressEvent", report);
      reader->AddObserver("ErrorEvent", note);
      reader->GetExecutive()->AddObserver("ErrorEvent", ignore);
      reader->SetFileName(path.c_str());
      try
      {
        reader->UpdatePiece(0, 3, 1);
      }
      catch (...)
      {
        std::cerr << "kind " << kind << " crosses at report " << at << "\n";
        return EXIT_FAILURE;
      }
      if (thrower.Reports <= at)
      {
        break; // there are no more reports
      }
      ++thrown;
      if (report->GetReferenceCount() > 2)
      {
        report->UnRegister(nullptr); // VTK keeps a reference to a command that throws
      }
      if (reader->GetErrorCode() != vtkErrorCode::UnknownError ||
        notes.find(path + ": " + reasons[kind]) == std::string::npos ||
        reader->GetOutput()->GetNumberOfPoints() != 0)
      {
        std::cerr << "kind " << kind << " at report " << at << ": code " << reader->GetErrorCode()
                  << ", " << notes << "\n";
        return EXIT_FAILURE;
      }
      reader->UpdatePiece(0, 1, 0);
      if (reader->GetErrorCode() != vtkErrorCode::NoError ||
        reader->GetOutput()->GetNumberOfCells() != Tets)
      {
        std::cerr << "kind " << kind << " at report " << at << ": does not read afterwards\n";
        return EXIT_FAILURE;
      }
    }
  }
  vtkNew<vtkGatunReader> reader;
  return thrown >= 3 && reader->CanReadFile(nullptr) == 0 && reader->CanReadFile(path.c_str()) == 1
    ? EXIT_SUCCESS
    : EXIT_FAILURE;
}
