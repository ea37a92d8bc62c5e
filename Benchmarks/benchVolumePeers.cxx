// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "benchVolumePeers.h"

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
  return std::sqrt(gatun::test::InnerProduct(vector, vector));
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

//------------------------------------------------------------------------------
PlainRaySum::PlainRaySum(const Volume& volume)
  : Base(static_cast<float>(volume.GetLowest()))
{
  const auto& size = volume.GetSize();
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    this->Stored[axis] = static_cast<std::ptrdiff_t>(size[axis]) + 2;
    this->Highest[axis] = static_cast<float>(size[axis]);
  }
  // One more voxel, row and slice, which count for nothing, for samples on the very border.
  const auto slice = this->Stored[0] * this->Stored[1];
  this->Voxels.resize(
    static_cast<std::size_t>(slice * (this->Stored[2] + 1) + this->Stored[0] + 1));
  auto from = volume.GetVoxels().begin();
  for (std::ptrdiff_t z = 1; z + 1 < this->Stored[2]; ++z)
  {
    for (std::ptrdiff_t y = 1; y + 1 < this->Stored[1]; ++y)
    {
      const auto to = this->Voxels.begin() + 1 + this->Stored[0] * (y + this->Stored[1] * z);
      std::transform(from, from + size[0], to, [this](float v) { return v - this->Base; });
      from += size[0];
    }
  }
}

//------------------------------------------------------------------------------
std::vector<float> PlainRaySum::Draw(const HartleyView& view) const
{
  std::vector<float> sums(std::size_t{ view.Width } * view.Height);
  const std::ptrdiff_t dy = this->Stored[0];
  const std::ptrdiff_t dz = this->Stored[0] * this->Stored[1];
  gatun::ParallelFor(view.Height,
    [&](std::size_t row)
    {
      for (unsigned column = 0; column < view.Width; ++column)
      {
        const Vector point = gatun::test::GetPixel(view, column, static_cast<double>(row));
        double begin = -1e30;
        double end = 1e30;
        double phase = 0;
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          const double step = view.Step[axis];
          phase += ((this->Highest[axis] - 1) / 2 - point[axis]) * step;
          if (std::abs(step) < 1e-12)
          {
            end = point[axis] > -1 && point[axis] < this->Highest[axis] ? end : -1e30;
            continue;
          }
          const double one = (-1 - point[axis]) / step;
          const double other = (this->Highest[axis] - point[axis]) / step;
          begin = std::max(begin, std::min(one, other));
          end = std::min(end, std::max(one, other));
        }
        phase /= gatun::test::InnerProduct(view.Step, view.Step);
        // A hair inside, so that rounding never leaves the border.
        const auto first = static_cast<int>(std::ceil(begin - phase + 1e-4));
        const auto last = static_cast<int>(std::floor(end - phase - 1e-4));
        float sum = 0;
        for (int i = first; i <= last && begin < end; ++i)
        {
          const double t = phase + i;
          const auto x = static_cast<float>(point[0] + t * view.Step[0] + 1);
          const auto y = static_cast<float>(point[1] + t * view.Step[1] + 1);
          const auto z = static_cast<float>(point[2] + t * view.Step[2] + 1);
          const auto cx = static_cast<std::ptrdiff_t>(x);
          const auto cy = static_cast<std::ptrdiff_t>(y);
          const auto cz = static_cast<std::ptrdiff_t>(z);
          const float fx = x - static_cast<float>(cx);
          const float fy = y - static_cast<float>(cy);
          const float fz = z - static_cast<float>(cz);
          const float* const v = &this->Voxels[static_cast<std::size_t>(cx + dy * cy + dz * cz)];
          const float a = v[0] + fx * (v[1] - v[0]);
          const float b = v[dy] + fx * (v[dy + 1] - v[dy]);
          const float c = v[dz] + fx * (v[dz + 1] - v[dz]);
          const float d = v[dz + dy] + fx * (v[dz + dy + 1] - v[dz + dy]);
          const float front = a + fy * (b - a);
          const float back = c + fy * (d - c);
          sum += front + fz * (back - front);
        }
        sums[row * view.Width + column] = sum;
      }
    });
  return sums;
}
}
