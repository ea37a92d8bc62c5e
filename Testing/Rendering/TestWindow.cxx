// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Checks the harness of the image tests: a window opens, and its picture equals a baseline.

#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkPlatonicSolidSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRegressionTestImage.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTesting.h"

int TestWindow(int argc, char* argv[])
{
  vtkNew<vtkPlatonicSolidSource> tetrahedron;
  tetrahedron->SetSolidTypeToTetrahedron();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(tetrahedron->GetOutputPort());
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  renderer->SetBackground(0.0, 0.0, 0.5);
  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(100, 100);
  window->AddRenderer(renderer);
  window->Render();
  // VTK's measure of difference; a wrong pixel on the outline adds less than one.
  return vtkRegressionTestImageThreshold(window, 10) == vtkTesting::PASSED ? EXIT_SUCCESS
                                                                           : EXIT_FAILURE;
}
