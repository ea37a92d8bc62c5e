// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Surfaces that cannot be filled: a message that says why, an error code, an empty output.

#include "vtkGatunTetrahedralize.h"

#include "vtkAppendPolyData.h"
#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCleanPolyData.h"
#include "vtkCubeSource.h"
#include "vtkErrorCode.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"
#include "vtkUnstructuredGrid.h"

#include <iostream>
#include <limits>
#include <string>

namespace
{

void Remember(vtkObject*, unsigned long, void* clientData, void* callData)
{
  *static_cast<std::string*>(clientData) += static_cast<const char*>(callData);
}

bool Refuses(vtkGatunTetrahedralize* mesher, const std::string& why)
{
  std::string message;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetCallback(Remember);
  observer->SetClientData(&message);
  const unsigned long tag = mesher->AddObserver(vtkCommand::ErrorEvent, observer);
  mesher->Update();
  mesher->RemoveObserver(tag);
  const bool good = message.find(why) != std::string::npos &&
    mesher->GetErrorCode() != vtkErrorCode::NoError && mesher->GetOutput()->GetNumberOfCells() == 0;
  if (!good)
  {
    std::cerr << "expected \"" << why << "\", got \"" << message << "\"\n";
  }
  return good;
}

bool Refuses(vtkPolyData* surface, const std::string& why)
{
  vtkNew<vtkGatunTetrahedralize> mesher;
  mesher->SetInputData(surface);
  return Refuses(mesher, why);
}

vtkSmartPointer<vtkPolyData> Cube(double x = 0)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetCenter(x, x / 2, x / 3);
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputConnection(cube->GetOutputPort());
  clean->Update();
  return clean->GetOutput();
}

vtkSmartPointer<vtkPolyData> Append(vtkPolyData* a, vtkPolyData* b)
{
  vtkNew<vtkAppendPolyData> both;
  both->AddInputData(a);
  both->AddInputData(b);
  both->Update();
  return both->GetOutput();
}

} // anonymous namespace

int TestTetrahedralizeErrors(int, char*[])
{
  vtkNew<vtkPolyData> nothing;
  if (!Refuses(nothing, "has no triangles"))
  {
    return EXIT_FAILURE;
  }

  vtkNew<vtkSphereSource> open;
  open->SetEndTheta(180);
  open->Update();
  if (!Refuses(open->GetOutput(), "is not closed"))
  {
    return EXIT_FAILURE;
  }

  // Two cubes that share an edge exactly.
  vtkNew<vtkCubeSource> other;
  other->SetCenter(1, 1, 0);
  other->Update();
  if (!Refuses(Append(Cube(), other->GetOutput()), "is not a manifold"))
  {
    return EXIT_FAILURE;
  }

  if (!Refuses(Append(Cube(), Cube(0.3)), "cuts itself"))
  {
    return EXIT_FAILURE;
  }

  vtkSmartPointer<vtkPolyData> infinite = Cube();
  infinite->GetPoints()->SetPoint(3, 0, std::numeric_limits<double>::infinity(), 0);
  if (!Refuses(infinite, "is not finite"))
  {
    return EXIT_FAILURE;
  }

  vtkNew<vtkGatunTetrahedralize> mesher;
  mesher->SetInputData(Cube());
  mesher->SetQuality(0.5);
  if (!Refuses(mesher, "cannot be reached"))
  {
    return EXIT_FAILURE;
  }
  mesher->SetQuality(1.4);
  mesher->SetSwitches("o2");
  if (!Refuses(mesher, "cannot be used"))
  {
    return EXIT_FAILURE;
  }
  // What failed once works once it is put right.
  mesher->SetSwitches("O1");
  mesher->Update();
  return mesher->GetErrorCode() == vtkErrorCode::NoError &&
      mesher->GetOutput()->GetNumberOfCells() > 0
    ? EXIT_SUCCESS
    : EXIT_FAILURE;
}
