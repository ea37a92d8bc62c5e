// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunRayRendering.h"

#include "gatunError.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkVolumeMapper.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace gatun
{
namespace
{
vtkMatrix4x4* GetProjection(vtkCamera* camera, const RayGrid& grid)
{
  const double aspect = grid.Aspect > 0 ? grid.Aspect
    : grid.Height > 0                   ? static_cast<double>(grid.Width) / grid.Height
                                        : 1;
  return camera->GetProjectionTransformMatrix(aspect, -1, 1);
}

/** Moves borders outwards so that the rays in the middle of the outermost pixels are there. */
void Widen(double& low, double& high, int rays)
{
  const double half = rays > 1 ? (high - low) / (rays - 1) / 2 : 0;
  low -= half;
  high += half;
}

void AddLights(vtkLightCollection* from, std::vector<RayLight>& lights)
{
  vtkCollectionSimpleIterator next;
  from->InitTraversal(next);
  while (vtkLight* const light = from->GetNextLight(next))
  {
    if (!light->GetSwitch())
    {
      continue;
    }
    RayLight made;
    light->GetTransformedPosition(made.Position.data());
    light->GetDiffuseColor(made.Diffuse.data());
    light->GetSpecularColor(made.Specular.data());
    std::array<double, 3> focus{};
    light->GetTransformedFocalPoint(focus.data());
    made.Position[3] = light->GetPositional() ? 1 : 0;
    for (std::size_t i = 0; i < 3; ++i)
    {
      made.Position[i] -= light->GetPositional() ? 0 : focus[i];
      made.Diffuse[i] *= light->GetIntensity();
      made.Specular[i] *= light->GetIntensity();
    }
    lights.push_back(made);
  }
}
}

//------------------------------------------------------------------------------
RayEye MakeRayEye(vtkCamera* camera, const RayGrid& grid, vtkMatrix4x4* volumeMatrix)
{
  vtkMatrix4x4* const projection = GetProjection(camera, grid);
  RayEye eye;
  RayFrustum& frustum = eye.Frustum;
  frustum.Parallel = camera->GetParallelProjection() != 0;

  // An eye in stereo, or a sheared view: what the projection does besides is moved in front of it.
  vtkNew<vtkMatrix4x4> toEye;
  for (int axis = 0; axis < 2; ++axis)
  {
    const int from = frustum.Parallel ? 2 : 3;
    toEye->SetElement(
      axis, from, projection->GetElement(axis, from) / projection->GetElement(axis, axis));
  }
  vtkMatrix4x4::Multiply4x4(toEye, camera->GetViewTransformMatrix(), toEye);
  if (volumeMatrix)
  {
    vtkMatrix4x4::Multiply4x4(toEye, volumeMatrix, toEye);
  }
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 4; ++j)
    {
      eye.FromWorld[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] =
        toEye->GetElement(i, j);
    }
  }

  // The borders of the image are where the projection gives -1 and 1.
  const auto getBorder = [&](int axis, double side)
  {
    const double scale = projection->GetElement(axis, axis);
    const double shift =
      frustum.Parallel ? -projection->GetElement(axis, 3) : projection->GetElement(axis, 2);
    return (side + shift) / scale;
  };
  frustum.Left = getBorder(0, -1);
  frustum.Right = getBorder(0, 1);
  frustum.Bottom = getBorder(1, -1);
  frustum.Top = getBorder(1, 1);
  return eye;
}

//------------------------------------------------------------------------------
RayView MakeRayView(
  vtkCamera* camera, const RayGrid& grid, vtkMatrix4x4* volumeMatrix, bool clippingRange)
{
  auto [rows, frustum] = MakeRayEye(camera, grid, volumeMatrix);
  if (clippingRange)
  {
    camera->GetClippingRange(frustum.Near, frustum.Far);
  }
  const double depth = frustum.Parallel ? 1 : camera->GetDistance();
  const double pixel = grid.Height > 0 ? (frustum.Top - frustum.Bottom) * depth / grid.Height : 1;
  // A unit of length, in which the mesh must not be too far away.
  const double unit = std::max(pixel, 1e-5 * camera->GetDistance());
  if (grid.ToBorders)
  {
    Widen(frustum.Left, frustum.Right, grid.Width);
    Widen(frustum.Bottom, frustum.Top, grid.Height);
  }
  return RayView(rows, frustum, grid.Width, grid.Height, unit);
}

//------------------------------------------------------------------------------
void RequireNumber(const char* property, double value)
{
  if (std::isnan(value))
  {
    ThrowInvalid(property + std::string(" is not a number"));
  }
}

//------------------------------------------------------------------------------
std::optional<RayMode> RayModeOf(int blendMode)
{
  static_assert(int{ CompositeBlend } == vtkVolumeMapper::COMPOSITE_BLEND);
  static_assert(int{ MaximumIntensityBlend } == vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND);
  switch (blendMode)
  {
    case CompositeBlend:
      return RayMode::Composite;
    case MaximumIntensityBlend:
      return RayMode::Maximum;
    case XRayBlend:
      return RayMode::XRay;
    default:
      return std::nullopt;
  }
}

//------------------------------------------------------------------------------
RayTable MakeRayTable(
  vtkVolumeProperty* property, RayMode mode, const Range& values, double sampleDistance)
{
  vtkPiecewiseFunction* const opacity = property->GetScalarOpacity();
  const bool isGray = property->GetColorChannels() == 1;
  vtkPiecewiseFunction* const gray = isGray ? property->GetGrayTransferFunction() : nullptr;
  vtkColorTransferFunction* const colors = isGray ? nullptr : property->GetRGBTransferFunction();

  // Beyond their outermost points, functions that clamp do not change.
  Range range = values;
  const bool clamps =
    opacity->GetClamping() && (isGray ? gray->GetClamping() : colors->GetClamping());
  if (clamps)
  {
    std::array<double, 2> ofOpacity{};
    std::array<double, 2> ofColor{};
    opacity->GetRange(ofOpacity.data());
    if (isGray)
    {
      gray->GetRange(ofColor.data());
    }
    else
    {
      colors->GetRange(ofColor.data());
    }
    const double low = std::max(values.Min, std::min(ofOpacity[0], ofColor[0]));
    const double high = std::min(values.Max, std::max(ofOpacity[1], ofColor[1]));
    if (low < high)
    {
      range = { low, high };
    }
  }
  const auto getColor = [&](double value)
  {
    std::array<double, 4> color{};
    if (isGray)
    {
      color.fill(gray->GetValue(value));
    }
    else
    {
      colors->GetColor(value, color.data());
    }
    color[3] = opacity->GetValue(value);
    for (double& c : color)
    {
      c = c >= 0 ? std::min(c, 1.0) : 0; // NaN too
    }
    return color;
  };
  const double unit = property->GetScalarOpacityUnitDistance();
  if (!(unit > 0))
  {
    throw Error(ErrorCode::InvalidInput, "the unit distance of opacity must be positive");
  }
  return RayTable(mode, getColor, range, sampleDistance, unit);
}

//------------------------------------------------------------------------------
std::shared_ptr<const DetailView> MakeDetailView(
  double pixelError, const RayView& view, RayTable table)
{
  return std::make_shared<const DetailView>(
    DetailView{ view, pixelError, std::make_shared<const RayTable>(std::move(table)) });
}

//------------------------------------------------------------------------------
std::optional<RayShading> MakeRayShading(vtkVolumeProperty* property, vtkCamera* camera,
  vtkLightCollection* lights, vtkMatrix4x4* volumeMatrix)
{
  if (!property->GetShade())
  {
    return std::nullopt;
  }
  RayShading shading;
  shading.Ambient = property->GetAmbient();
  shading.Diffuse = property->GetDiffuse();
  shading.Specular = property->GetSpecular();
  shading.SpecularPower = property->GetSpecularPower();
  const double* const forward = camera->GetDirectionOfProjection();
  const std::array<double, 4> backward{ -forward[0], -forward[1], -forward[2], 0 };
  if (camera->GetParallelProjection())
  {
    shading.Eye = backward;
  }
  else
  {
    camera->GetPosition(shading.Eye.data());
    shading.Eye[3] = 1;
  }
  if (lights)
  {
    AddLights(lights, shading.Lights);
  }
  else
  {
    shading.Lights.push_back({ backward });
  }
  for (int i = 0; volumeMatrix && i < 3; ++i)
  {
    for (int j = 0; j < 4; ++j)
    {
      shading.ToWorld[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] =
        volumeMatrix->GetElement(i, j);
    }
  }
  return shading;
}

//------------------------------------------------------------------------------
RayLimits MakeRayLimits(const RayView& view, vtkPlaneCollection* planes, vtkMatrix4x4* volumeMatrix)
{
  RayLimits limits;
  for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
  {
    vtkPlane* const plane = planes->GetItem(i);
    std::array<double, 4> p{};
    plane->GetNormal(p.data());
    const double* const origin = plane->GetOrigin();
    p[3] = -(p[0] * origin[0] + p[1] * origin[1] + p[2] * origin[2]);
    if (volumeMatrix)
    {
      // p . (M x) = (transposed M p) . x
      vtkNew<vtkMatrix4x4> transposed;
      vtkMatrix4x4::Transpose(volumeMatrix, transposed);
      transposed->MultiplyPoint(p.data(), p.data());
    }
    ClipByPlane(view, p, limits);
  }
  return limits;
}

//------------------------------------------------------------------------------
void LimitByZBuffer(const RayView& view, vtkCamera* camera, const RayGrid& grid,
  std::span<const float> zBuffer, int width, int height, RayLimits& limits)
{
  if (std::all_of(zBuffer.begin(), zBuffer.end(), [](float z) { return z >= 1; }))
  {
    return;
  }
  // What the projection does to depths, in reverse.
  vtkMatrix4x4* const projection = GetProjection(camera, grid);
  const double scale = projection->GetElement(2, 2);
  const double shift = projection->GetElement(2, 3);
  const auto getDepth = [&](float z)
  {
    const double inClip = 2.0 * static_cast<double>(z) - 1;
    return view.Perspective ? shift / (inClip + scale) : (shift - inClip) / scale;
  };
  const auto toPixel = [&](int ray, int rays, int pixels)
  {
    const double along = grid.ToBorders ? ray / (rays - 1.0) : (ray + 0.5) / rays;
    return std::min(static_cast<int>(along * pixels), pixels - 1);
  };
  const auto rays = static_cast<std::size_t>(view.Width) * static_cast<std::size_t>(view.Height);
  limits.Near.resize(rays, 0.0f);
  limits.Far.resize(rays, 1e9f);
  for (int y = 0; y < view.Height; ++y)
  {
    const auto row =
      static_cast<std::size_t>(toPixel(y, view.Height, height)) * static_cast<std::size_t>(width);
    for (int x = 0; x < view.Width; ++x)
    {
      const float z = zBuffer[row + static_cast<std::size_t>(toPixel(x, view.Width, width))];
      if (z < 1)
      {
        float& far = limits.Far[static_cast<std::size_t>(y) * static_cast<std::size_t>(view.Width) +
          static_cast<std::size_t>(x)];
        far = std::min(far, static_cast<float>(getDepth(z) * view.GetSamplesPerDepth(x, y)));
      }
    }
  }
}
}
