// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "benchScene.h"

#include "benchHarness.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

namespace bench
{
namespace
{
/** Of the largest value, over a hundredth of the diagonal; that of the smallest is 0. */
constexpr double Opacity = 0.3;

/** From blue over gray to red: of the smallest value, of that half way, and of the largest. */
constexpr std::array<std::array<double, 3>, 3> Colors{ { { 0.1, 0.2, 0.9 }, { 0.9, 0.9, 0.9 },
  { 0.9, 0.1, 0.1 } } };
}

//------------------------------------------------------------------------------
double Scene::GetDiagonal() const
{
  return std::hypot(
    this->Box[1] - this->Box[0], this->Box[3] - this->Box[2], this->Box[5] - this->Box[4]);
}

//------------------------------------------------------------------------------
void Scene::SetUp(vtkCamera* camera, double turn) const
{
  const double center[3] = { (this->Box[0] + this->Box[1]) / 2, (this->Box[2] + this->Box[3]) / 2,
    (this->Box[4] + this->Box[5]) / 2 };
  const double radius = this->GetDiagonal() / 2;
  const double distance =
    radius / std::sin(vtkMath::RadiansFromDegrees(camera->GetViewAngle() / 2));
  camera->SetFocalPoint(center);
  camera->SetPosition(center[0], center[1], center[2] + distance);
  camera->SetViewUp(0, 1, 0);
  camera->Azimuth(30);
  camera->Elevation(20);
  camera->Azimuth(turn);
  camera->SetClippingRange(distance - 1.01 * radius, distance + 1.01 * radius);
}

//------------------------------------------------------------------------------
void Scene::SetUp(vtkVolumeProperty* property) const
{
  vtkNew<vtkColorTransferFunction> colors;
  vtkNew<vtkPiecewiseFunction> opacities;
  for (std::size_t i = 0; i < Colors.size(); ++i)
  {
    const double at =
      this->Values[0] + (this->Values[1] - this->Values[0]) * 0.5 * static_cast<double>(i);
    colors->AddRGBPoint(at, Colors[i][0], Colors[i][1], Colors[i][2]);
  }
  opacities->AddPoint(this->Values[0], 0);
  opacities->AddPoint(this->Values[1], Opacity);
  property->SetColor(colors);
  property->SetScalarOpacity(opacities);
  property->SetScalarOpacityUnitDistance(this->GetDiagonal() / 100);
  property->SetInterpolationTypeToLinear();
  property->ShadeOff();
}

//------------------------------------------------------------------------------
gatun::RayView Scene::MakeView(int size) const
{
  vtkNew<vtkCamera> camera;
  this->SetUp(camera);
  vtkMatrix4x4* const matrix = camera->GetViewTransformMatrix();
  std::array<std::array<double, 4>, 3> toEye{};
  for (std::size_t i = 0; i < 12; ++i)
  {
    toEye[i / 4][i % 4] = matrix->GetElement(static_cast<int>(i / 4), static_cast<int>(i % 4));
  }
  const double border = std::tan(vtkMath::RadiansFromDegrees(camera->GetViewAngle() / 2));
  gatun::RayFrustum frustum;
  frustum.Left = frustum.Bottom = -border;
  frustum.Right = frustum.Top = border;
  return gatun::RayView(toEye, frustum, size, size, 2 * border / size * camera->GetDistance());
}

//------------------------------------------------------------------------------
gatun::RayTable Scene::MakeTable(const gatun::RayView& view, gatun::RayMode mode) const
{
  const auto getColor = [this](double value)
  {
    const double at = (value - this->Values[0]) / (this->Values[1] - this->Values[0]);
    const std::size_t from = at < 0.5 ? 0 : 1;
    const double part = 2 * at - static_cast<double>(from);
    std::array<double, 4> color{};
    for (std::size_t c = 0; c < 3; ++c)
    {
      color[c] = Colors[from][c] + part * (Colors[from + 1][c] - Colors[from][c]);
    }
    color[3] = at * Opacity;
    return color;
  };
  return gatun::RayTable(mode, getColor, { this->Values[0], this->Values[1] }, view.SampleDistance,
    this->GetDiagonal() / 100);
}

//------------------------------------------------------------------------------
Scene MakeScene(vtkUnstructuredGrid* grid, const std::string& array)
{
  vtkDataArray* const values = grid->GetPointData()->GetArray(array.c_str());
  if (!values)
  {
    throw Failure("there is no point array " + array);
  }
  Scene scene;
  grid->GetBounds(scene.Box.data());
  values->GetRange(scene.Values.data());
  return scene;
}

//------------------------------------------------------------------------------
Scene MakeScene(const gatun::FileReader& file, const std::string& array)
{
  const gatun::Range& values = file.GetRanges(FindPointArray(file, array), 0)[0];
  Scene scene;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    scene.Box[2 * axis] = file.GetBounds()[axis].Min;
    scene.Box[2 * axis + 1] = file.GetBounds()[axis].Max;
  }
  scene.Values = { values.Min, values.Max };
  return scene;
}

//------------------------------------------------------------------------------
std::uint32_t FindPointArray(const gatun::FileReader& file, const std::string& array)
{
  const auto& arrays = file.GetArrays();
  for (std::size_t i = 0; i < arrays.size(); ++i)
  {
    if (arrays[i].Where == gatun::Association::Point && arrays[i].Name == array)
    {
      return static_cast<std::uint32_t>(i);
    }
  }
  throw Failure(file.GetPath(), "has no point array " + array);
}
}
