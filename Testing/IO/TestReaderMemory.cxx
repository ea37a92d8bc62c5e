// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// A reader that runs out of memory, wherever that may be, says so by an error code and a message,
// leaves an empty output, and reads well once there is memory again. Nothing is thrown.

#include "../gatunSanitizer.h"

#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkGatunReader.h"
#include "vtkGatunWriter.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkTable.h"
#include "vtkTestUtilities.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVariant.h"

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace
{

constexpr int Skipped = 125;
constexpr vtkIdType Tets = 60000;

enum Outcome
{
  Read = 0,
  Refused = 1,
  Wrong = 2
};

// A coil of tetrahedra, each sharing a face with the next, and some arrays.
void WriteFile(const std::string& path)
{
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> heat;
  vtkNew<vtkDoubleArray> stress;
  heat->SetName("heat");
  stress->SetName("stress");
  stress->SetNumberOfComponents(6);
  stress->SetNumberOfTuples(Tets);
  grid->SetPoints(points);
  grid->Allocate(Tets);
  for (vtkIdType i = 0; i < Tets + 3; ++i)
  {
    const double t = static_cast<double>(i);
    points->InsertNextPoint(0.1 * t, t / 3 - static_cast<double>(i / 3), 0.5 * (i % 2));
    heat->InsertNextValue(t * t);
  }
  for (vtkIdType i = 0; i < Tets; ++i)
  {
    const vtkIdType corners[4] = { i, i + 1, i + 2, i + 3 };
    grid->InsertNextCell(VTK_TETRA, 4, corners);
    for (int c = 0; c < 6; ++c)
    {
      stress->SetTypedComponent(i, c, static_cast<double>(i * c % 1013));
    }
  }
  grid->GetPointData()->SetScalars(heat);
  grid->GetCellData()->AddArray(stress);
  vtkNew<vtkGatunWriter> writer;
  writer->SetInputData(grid);
  writer->SetFileName(path.c_str());
  writer->SetKeepOrderToAll();
  writer->SetChunkSize(10000);
  if (writer->Write() != 1)
  {
    std::cerr << "cannot write " << path << "\n";
    std::exit(EXIT_FAILURE);
  }
}

rlim_t GetAddressSpace()
{
  std::ifstream in("/proc/self/statm");
  rlim_t pages = 0;
  in >> pages;
  return pages * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE));
}

void SetLimit(rlim_t bytes)
{
  rlimit memory{};
  ::getrlimit(RLIMIT_AS, &memory);
  memory.rlim_cur = bytes;
  ::setrlimit(RLIMIT_AS, &memory);
}

void NoteError(vtkObject*, unsigned long, void* notes, void* text)
{
  *static_cast<std::string*>(notes) += static_cast<const char*>(text);
}

// Reads with little memory, in a process of its own.
Outcome ReadWithin(const std::string& path, rlim_t bytes, bool informed, int pieces)
{
  std::string notes;
  notes.reserve(1 << 16);
  vtkNew<vtkCallbackCommand> note;
  note->SetCallback(NoteError);
  note->SetClientData(&notes);
  vtkNew<vtkCallbackCommand> ignore;
  vtkNew<vtkGatunReader> reader;
  reader->AddObserver("ErrorEvent", note);
  reader->GetExecutive()->AddObserver("ErrorEvent", ignore);
  reader->SetFileName(path.c_str());
  if (informed)
  {
    reader->UpdateInformation();
  }
  try
  {
    SetLimit(GetAddressSpace() + bytes);
    reader->UpdatePiece(0, pieces, pieces > 1 ? 1 : 0);
    SetLimit(RLIM_INFINITY);
  }
  catch (...)
  {
    SetLimit(RLIM_INFINITY);
    std::cerr << bytes << ": something was thrown\n";
    return Wrong;
  }
  const bool failed = reader->GetErrorCode() != vtkErrorCode::NoError;
  if (failed &&
    (reader->GetErrorCode() != vtkErrorCode::UnknownError ||
      notes.find(path) == std::string::npos ||
      notes.find("not enough memory") == std::string::npos))
  {
    std::cerr << bytes << ": error " << reader->GetErrorCode() << ", " << notes << "\n";
    return Wrong;
  }
  if (failed &&
    (reader->GetOutput()->GetNumberOfPoints() != 0 ||
      reader->GetStatistics()->GetValueByName(0, "CachedBytes").ToInt() != 0))
  {
    std::cerr << bytes << ": something is left\n";
    return Wrong;
  }
  reader->UpdatePiece(0, 1, 0);
  if (reader->GetErrorCode() != vtkErrorCode::NoError ||
    reader->GetOutput()->GetNumberOfCells() != Tets ||
    reader->GetOutput()->GetPointData()->GetScalars()->GetComponent(Tets, 0) !=
      static_cast<double>(Tets) * Tets)
  {
    std::cerr << bytes << ": does not read afterwards\n";
    return Wrong;
  }
  return failed ? Refused : Read;
}

} // anonymous namespace

int TestReaderMemory(int argc, char* argv[])
{
#ifdef GATUN_HAS_SANITIZER
  std::cout << "sanitizers need address space of their own\n";
  return Skipped;
#endif
  // Threads would fail for lack of memory by themselves. VTK reads this when it is loaded.
  if (!std::getenv("VTK_SMP_BACKEND_IN_USE"))
  {
    std::cerr << "VTK_SMP_BACKEND_IN_USE is not set\n";
    return EXIT_FAILURE;
  }

  char* temporary =
    vtkTestUtilities::GetArgOrEnvOrDefault("-T", argc, argv, "VTK_TEMP_DIR", "Testing/Temporary");
  const std::string path = std::string(temporary) + "/memory.gtn";
  delete[] temporary;
  // In a process of its own, so that no free memory is left in this one.
  int status = -1;
  if (const pid_t child = ::fork(); child == 0)
  {
    WriteFile(path);
    std::_Exit(EXIT_SUCCESS);
  }
  else
  {
    ::waitpid(child, &status, 0);
  }
  if (status != 0)
  {
    return EXIT_FAILURE;
  }

  int refused = 0;
  for (const bool informed : { true, false })
  {
    for (const int pieces : { 1, 3 })
    {
      Outcome last = Refused;
      for (rlim_t bytes = 0; last == Refused && bytes < rlim_t{ 256 } << 20;
           bytes += rlim_t{ 350 } << 10)
      {
        const pid_t child = ::fork();
        if (child == 0)
        {
          std::_Exit(ReadWithin(path, bytes, informed, pieces));
        }
        ::waitpid(child, &status, 0);
        last = WIFEXITED(status) ? static_cast<Outcome>(WEXITSTATUS(status)) : Wrong;
        refused += last == Refused;
      }
      if (last != Read)
      {
        std::cerr << "wrong: " << pieces << " pieces, informed: " << informed << "\n";
        return EXIT_FAILURE;
      }
    }
  }
  std::cout << refused << " times out of memory\n";
  return refused >= 10 ? EXIT_SUCCESS : EXIT_FAILURE;
}
