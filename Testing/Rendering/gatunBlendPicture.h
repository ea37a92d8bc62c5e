// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunBlendPicture_h
#define gatunBlendPicture_h

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataSetTriangleFilter.h"
#include "vtkGatunVolumeMapper.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRTAnalyticSource.h"
#include "vtkRegressionTestImage.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTesting.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

/** Draws VTK's wavelet in tetrahedra, and compares the picture with the test's baseline. */
inline int CompareBlendPicture(int argc, char* argv[], int blendMode, bool shade = false)
{
  vtkNew<vtkRTAnalyticSource> wavelet;
  wavelet->SetWholeExtent(-8, 8, -8, 8, -8, 8);
  vtkNew<vtkDataSetTriangleFilter> tetrahedra;
  tetrahedra->SetInputConnection(wavelet->GetOutputPort());
  vtkNew<vtkGatunVolumeMapper> mapper;
  mapper->SetInputConnection(tetrahedra->GetOutputPort());
  mapper->SetBlendMode(blendMode);

  vtkNew<vtkColorTransferFunction> colors;
  colors->AddRGBPoint(80, 0.1, 0.2, 0.9);
  colors->AddRGBPoint(160, 0.1, 0.9, 0.3);
  colors->AddRGBPoint(200, 0.9, 0.8, 0.1);
  colors->AddRGBPoint(270, 0.9, 0.1, 0.1);
  vtkNew<vtkPiecewiseFunction> opacities;
  opacities->AddPoint(100, 0.02);
  opacities->AddPoint(200, 0.05);
  opacities->AddPoint(220, 0.3);
  opacities->AddPoint(270, 0.8);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->GetProperty()->SetColor(colors);
  volume->GetProperty()->SetScalarOpacity(opacities);
  volume->GetProperty()->SetScalarOpacityUnitDistance(2);
  volume->GetProperty()->SetShade(shade);

  vtkNew<vtkRenderer> renderer;
  renderer->AddVolume(volume);
  renderer->SetBackground(0.0, 0.0, 0.2);
  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(200, 200);
  window->AddRenderer(renderer);
  renderer->GetActiveCamera()->SetPosition(0.6, 0.5, 1);
  renderer->ResetCamera();
  renderer->GetActiveCamera()->Zoom(1.4);
  window->Render();
  // VTK's measure of difference; rounding adds much less than one.
  return vtkRegressionTestImageThreshold(window, 10) == vtkTesting::PASSED ? EXIT_SUCCESS
                                                                           : EXIT_FAILURE;
}

#endif
