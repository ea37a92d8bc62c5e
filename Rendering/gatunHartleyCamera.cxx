// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunHartleyCamera.h"

#include "gatunError.h"
#include "gatunRayRendering.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkMath.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace gatun
{
namespace
{
using Vector = VolumePlace::Vector;

//------------------------------------------------------------------------------
bool IsFinite(const Vector& vector)
{
  return std::all_of(vector.begin(), vector.end(), [](double x) { return std::isfinite(x); });
}

//------------------------------------------------------------------------------
Vector Combine(const std::array<Vector, 3>& axes, const Vector& parts)
{
  Vector sum{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      sum[i] += parts[axis] * axes[axis][i];
    }
  }
  return sum;
}

//------------------------------------------------------------------------------
Vector Add(const Vector& a, const Vector& b, double factor = 1)
{
  return { a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2] };
}

//------------------------------------------------------------------------------
Vector Cross(const Vector& a, const Vector& b)
{
  Vector cross{};
  vtkMath::Cross(a.data(), b.data(), cross.data());
  return cross;
}
}

//------------------------------------------------------------------------------
VolumePlace::VolumePlace(const VolumeInput& volume)
{
  double length = 1;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::string name(1, "xyz"[axis]);
    const double spacing = volume.Spacing[axis];
    if (!std::isfinite(spacing) || spacing == 0)
    {
      ThrowInvalid("the spacing along " + name + " is " + std::to_string(spacing));
    }
    for (std::size_t i = 0; i < 3; ++i)
    {
      this->Axes[axis][i] = volume.Direction[3 * i + axis] * spacing;
    }
    length *= vtkMath::Norm(this->Axes[axis].data());
  }
  // The rows of the inverse are at right angles to two axes each.
  const double determinant =
    vtkMath::Dot(this->Axes[0].data(), Cross(this->Axes[1], this->Axes[2]).data());
  if (!std::isfinite(determinant) || !IsFinite(volume.Origin))
  {
    ThrowInvalid("origin, spacing and direction are not all finite numbers");
  }
  if (!(std::abs(determinant) > 1e-9 * length))
  {
    ThrowInvalid("the direction matrix is singular, so that the voxels span no space");
  }
  std::array<Vector, 3> rows{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    rows[axis] = Cross(this->Axes[(axis + 1) % 3], this->Axes[(axis + 2) % 3]);
  }
  Vector first{};
  Vector middle{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      this->Inverse[i][axis] = rows[axis][i] / determinant;
    }
    first[axis] = volume.FirstIndex[axis];
    middle[axis] = (volume.Size[axis] - 1.) / 2;
  }
  this->First = Add(volume.Origin, Combine(this->Axes, first));
  this->Centre = this->ToWorld(middle);
  for (unsigned corner = 0; corner < 8; ++corner)
  {
    Vector arm{};
    Vector longer{};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const double side = corner >> axis & 1u ? 1 : -1;
      arm[axis] = side * middle[axis];
      longer[axis] = side * (middle[axis] + 1);
    }
    this->Radius = std::max(this->Radius, vtkMath::Norm(Combine(this->Axes, arm).data()));
    this->Reach = std::max(this->Reach, vtkMath::Norm(Combine(this->Axes, longer).data()));
  }
  this->VoxelEdge = std::cbrt(std::abs(determinant));
}

//------------------------------------------------------------------------------
Vector VolumePlace::ToWorld(const Vector& index) const
{
  return Add(this->First, Combine(this->Axes, index));
}

//------------------------------------------------------------------------------
Vector VolumePlace::ToIndex(const Vector& world) const
{
  return this->ToIndexStep(Add(world, this->First, -1));
}

//------------------------------------------------------------------------------
Vector VolumePlace::ToIndexStep(const Vector& step) const
{
  return Combine(this->Inverse, step);
}

//------------------------------------------------------------------------------
void ShowVolume(vtkCamera* camera, const VolumePlace& place, double aspect)
{
  const double radius = place.GetReach();
  Vector direction{};
  camera->GetDirectionOfProjection(direction.data());
  const Vector& centre = place.GetCentre();
  camera->SetFocalPoint(centre.data());
  camera->SetPosition(Add(centre, direction, -2 * radius).data());
  camera->SetParallelScale(radius / std::min(1., aspect));
  camera->SetClippingRange(radius, 3 * radius);
  camera->ParallelProjectionOn();
}

//------------------------------------------------------------------------------
HartleyFrame MakeHartleyFrame(vtkCamera* camera, const std::array<int, 2>& size,
  const VolumePlace& place, double sampleDistance)
{
  if (!camera->GetParallelProjection())
  {
    ThrowInvalid("the camera is one of perspective, but all rays must have one direction for the "
                 "projection-slice theorem to hold; call ParallelProjectionOn");
  }
  const RayEye eye = MakeRayEye(camera, { size[0], size[1] }, nullptr);
  vtkNew<vtkMatrix4x4> toWorld;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 4; ++j)
    {
      toWorld->SetElement(
        i, j, eye.FromWorld[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]);
    }
  }
  toWorld->Invert();
  const auto column = [&toWorld](int j)
  {
    return Vector{ toWorld->GetElement(0, j), toWorld->GetElement(1, j),
      toWorld->GetElement(2, j) };
  };

  HartleyFrame frame;
  const RayFrustum& frustum = eye.Frustum;
  frame.Spacing = { (frustum.Right - frustum.Left) / size[0],
    (frustum.Top - frustum.Bottom) / size[1] };
  frame.First = { frustum.Left + frame.Spacing[0] / 2, frustum.Bottom + frame.Spacing[1] / 2 };
  // Rays have no beginning; those numbers are the most exact that are near the volume.
  Vector first = Add(column(3), column(2), -camera->GetDistance());
  first = Add(Add(first, column(0), frame.First[0]), column(1), frame.First[1]);
  Vector forward = column(2);
  vtkMath::Normalize(forward.data());
  const Vector nothing{};
  frame.View.Width = static_cast<unsigned>(size[0]);
  frame.View.Height = static_cast<unsigned>(size[1]);
  frame.View.Origin = place.ToIndex(first);
  frame.View.ColumnStep = place.ToIndexStep(Add(nothing, column(0), frame.Spacing[0]));
  frame.View.RowStep = place.ToIndexStep(Add(nothing, column(1), frame.Spacing[1]));
  frame.View.Step = place.ToIndexStep(Add(nothing, forward, -sampleDistance));
  return frame;
}

//------------------------------------------------------------------------------
void FillHartleyTable(
  vtkVolumeProperty* property, const Range& range, double sampleDistance, HartleyShading& shading)
{
  constexpr int entries = 4096;
  // A constant volume has a table, too.
  const double margin = range.Min < range.Max ? 0 : std::max(0.5, std::abs(range.Min) / 1000);
  shading.First = range.Min - margin;
  shading.Last = range.Max + margin;
  std::vector<float> colours(3 * entries);
  std::vector<float> opacities(entries);
  if (property->GetColorChannels() == 1)
  {
    std::vector<float> grey(entries);
    property->GetGrayTransferFunction()->GetTable(
      shading.First, shading.Last, entries, grey.data());
    for (std::size_t i = 0; i < colours.size(); ++i)
    {
      colours[i] = grey[i / 3];
    }
  }
  else
  {
    property->GetRGBTransferFunction()->GetTable(
      shading.First, shading.Last, entries, colours.data());
  }
  property->GetScalarOpacity()->GetTable(shading.First, shading.Last, entries, opacities.data());
  const double samples = sampleDistance / property->GetScalarOpacityUnitDistance();
  shading.Table.resize(entries);
  for (std::size_t i = 0; i < shading.Table.size(); ++i)
  {
    const double opacity = std::clamp(static_cast<double>(opacities[i]), 0., 1.);
    shading.Table[i] = { colours[3 * i], colours[3 * i + 1], colours[3 * i + 2],
      static_cast<float>(1 - std::pow(1 - opacity, samples)) };
  }
}
}
