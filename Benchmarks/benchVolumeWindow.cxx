// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "benchVolumeWindow.h"

#include "benchHarness.h"

#include "gatunParallel.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkFixedPointVolumeRayCastMapper.h"
#include "vtkImageData.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

namespace bench
{
namespace
{
using gatun::HartleyOpacityModel;
using gatun::HartleyView;
using gatun::test::ReferenceVolume;
using gatun::test::Vector;

/** A vector of index coordinates in space; images here have no direction. */
Vector InSpace(vtkImageData* image, const Vector& vector)
{
  const double* const spacing = image->GetSpacing();
  return { vector[0] * spacing[0], vector[1] * spacing[1], vector[2] * spacing[2] };
}

double Length(const Vector& vector)
{
  return std::hypot(vector[0], vector[1], vector[2]);
}
}

//------------------------------------------------------------------------------
FixedPointWindow::FixedPointWindow(
  const Volume& volume, unsigned pixels, const gatun::HartleyShading& shading)
  : Shown(volume)
{
  const double* const spacing = volume.GetImage()->GetSpacing();
  const double shortest = *std::min_element(spacing, spacing + 3);
  this->Mapper->SetInputData(volume.GetImage());
  this->Mapper->SetNumberOfThreads(gatun::GetNumberOfThreads());
  this->Mapper->AutoAdjustSampleDistancesOff();
  this->Mapper->SetImageSampleDistance(1);
  this->Mapper->SetSampleDistance(static_cast<float>(shortest));
  vtkNew<vtkColorTransferFunction> colors;
  vtkNew<vtkPiecewiseFunction> opacities;
  const int nodes = 256;
  for (int i = 0; i <= nodes; ++i)
  {
    const double density = volume.GetLowest() + volume.GetRange() * i / nodes;
    const auto [red, green, blue, opacity] = shading.OpacityModel == HartleyOpacityModel::XRay
      ? std::array<double, 4>{ 1, 1, 1, 0.005 * i / nodes }
      : ReferenceVolume::Shade(shading, density);
    colors->AddRGBPoint(density, red, green, blue);
    opacities->AddPoint(density, opacity);
  }
  if (shading.OpacityModel == HartleyOpacityModel::XRay)
  {
    this->Mapper->SetBlendModeToAdditive();
  }
  vtkNew<vtkVolume> prop;
  prop->SetMapper(this->Mapper);
  prop->GetProperty()->SetColor(colors);
  prop->GetProperty()->SetScalarOpacity(opacities);
  prop->GetProperty()->SetScalarOpacityUnitDistance(shortest);
  prop->GetProperty()->SetInterpolationTypeToLinear();
  prop->GetProperty()->ShadeOff();
  this->Window->SetOffScreenRendering(1);
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(static_cast<int>(pixels), static_cast<int>(pixels));
  this->Window->AddRenderer(this->Renderer);
  this->Window->Render();
  this->Window->WaitForCompletion();
  this->Renderer->AddVolume(prop);
}

FixedPointWindow::~FixedPointWindow() = default;

//------------------------------------------------------------------------------
void FixedPointWindow::Render(const HartleyView& view)
{
  vtkImageData* const image = this->Shown.GetImage();
  const Vector direction = InSpace(image, view.Step);
  const Vector up = InSpace(image, view.RowStep);
  double center[3];
  image->GetCenter(center);
  vtkCamera* const camera = this->Renderer->GetActiveCamera();
  const double away = 2 * image->GetLength() / Length(direction);
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(center);
  camera->SetPosition(center[0] - away * direction[0], center[1] - away * direction[1],
    center[2] - away * direction[2]);
  camera->SetViewUp(up.data());
  camera->SetParallelScale(view.Height * Length(up) / 2);
  this->Renderer->ResetCameraClippingRange();
  this->Window->Render();
  this->Window->WaitForCompletion();
}

//------------------------------------------------------------------------------
double FixedPointWindow::GetMean()
{
  const int* const size = this->Window->GetSize();
  vtkNew<vtkUnsignedCharArray> pixels;
  this->Window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels);
  double sum = 0;
  for (vtkIdType i = 0; i < pixels->GetNumberOfValues(); ++i)
  {
    sum += pixels->GetValue(i);
  }
  return sum / (255.0 * static_cast<double>(pixels->GetNumberOfValues()));
}
}
