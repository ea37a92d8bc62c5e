// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunRayView.h"

#include "gatunError.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace gatun
{
namespace
{
void Require(bool holds, const char* what)
{
  if (!holds)
  {
    throw Error(ErrorCode::InvalidInput, what);
  }
}
}

//------------------------------------------------------------------------------
RayView::RayView(const std::array<std::array<double, 4>, 3>& toEye, const RayFrustum& frustum,
  int width, int height, double sampleDistance)
  : Perspective(!frustum.Parallel)
  , Width(width)
  , Height(height)
  , SampleDistance(sampleDistance)
  , Near(frustum.Near)
  , Far(frustum.Far)
{
  Require(width > 0 && height > 0, "the picture has no pixels");
  Require(width <= 32000 && height <= 32000, "the picture has more than 32000 pixels in a row");
  Require(std::isfinite(sampleDistance) && sampleDistance > 0,
    "the sample distance must be a positive number");
  const double w = frustum.Right - frustum.Left;
  const double h = frustum.Top - frustum.Bottom;
  Require(std::isfinite(w) && std::isfinite(h) && w > 0 && h > 0, "the view has no extent");
  const double determinant = toEye[0][0] * (toEye[1][1] * toEye[2][2] - toEye[1][2] * toEye[2][1]) +
    toEye[0][1] * (toEye[1][2] * toEye[2][0] - toEye[1][0] * toEye[2][2]) +
    toEye[0][2] * (toEye[1][0] * toEye[2][1] - toEye[1][1] * toEye[2][0]);
  Require(std::isfinite(determinant) && determinant != 0, "the camera's matrix has no inverse");

  this->ScaleX = w / width;
  this->ScaleY = h / height;
  this->CentreX = -frustum.Left / this->ScaleX - 0.5 - OffsetX;
  this->CentreY = -frustum.Bottom / this->ScaleY - 0.5 - OffsetY;
  for (std::size_t i = 0; i < 4; ++i)
  {
    const double depth = -toEye[2][i];
    const double one = i == 3 ? 1 : 0;
    const double times = frustum.Parallel ? one : depth;
    this->ToRays[0][i] = toEye[0][i] / this->ScaleX + this->CentreX * times;
    this->ToRays[1][i] = toEye[1][i] / this->ScaleY + this->CentreY * times;
    this->ToRays[2][i] = frustum.Parallel ? depth / sampleDistance : depth;
  }
}

//------------------------------------------------------------------------------
std::array<double, 3> RayView::Transform(const std::array<double, 3>& point) const
{
  std::array<double, 3> result{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    const auto& row = this->ToRays[i];
    result[i] = row[0] * point[0] + row[1] * point[1] + row[2] * point[2] + row[3];
  }
  return result;
}

//------------------------------------------------------------------------------
double RayView::GetSamplesPerDepth(double x, double y) const
{
  if (!this->Perspective)
  {
    return 1 / this->SampleDistance;
  }
  const double u = (x - this->CentreX) * this->ScaleX;
  const double v = (y - this->CentreY) * this->ScaleY;
  return std::sqrt(1 + u * u + v * v) / this->SampleDistance;
}

//------------------------------------------------------------------------------
void ClipByPlane(const RayView& view, const std::array<double, 4>& plane, RayLimits& limits)
{
  // The plane in ray coordinates is n . p + d = 0 with n M = (a, b, c): by Cramer's rule.
  const auto& m = view.ToRays;
  const auto cross = [](const auto& a, const auto& b)
  {
    return std::array<double, 3>{ a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
      a[0] * b[1] - a[1] * b[0] };
  };
  const auto dot = [](const auto& a, const auto& b)
  { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  const double volume = dot(m[0], cross(m[1], m[2]));
  const std::array<double, 3> n = { dot(plane, cross(m[1], m[2])) / volume,
    dot(plane, cross(m[2], m[0])) / volume, dot(plane, cross(m[0], m[1])) / volume };
  const double d = plane[3] - (n[0] * m[0][3] + n[1] * m[1][3] + n[2] * m[2][3]);
  const auto width = static_cast<std::size_t>(view.Width);
  const auto pixels = width * static_cast<std::size_t>(view.Height);
  limits.Planes.push_back(plane);
  limits.Near.resize(pixels, 0.0f);
  limits.Far.resize(pixels, 1e9f);
  for (std::size_t i = 0; i < pixels; ++i)
  {
    const auto x = static_cast<double>(i % width);
    const std::size_t row = i / width;
    const auto y = static_cast<double>(row);
    // Along the ray it is slope * z + offset.
    const double across = n[0] * x + n[1] * y;
    const double slope = view.Perspective ? across + n[2] : n[2];
    const double offset = view.Perspective ? d : across + d;
    const double perZ = view.Perspective ? view.GetSamplesPerDepth(x, y) : 1;
    const auto where = static_cast<float>(std::clamp(-offset / slope * perZ, -1e9, 1e9));
    float& near = limits.Near[i];
    float& far = limits.Far[i];
    if (slope > 0)
    {
      near = std::max(near, where);
    }
    else if (slope < 0)
    {
      far = std::min(far, where);
    }
    else if (offset < 0)
    {
      far = -1e9f;
    }
  }
}
}
