// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunRayView.h"

#include "gatunError.h"
#include "gatunVector.h"

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
  Require(width > 0 && height > 0, "the image has no pixels");
  Require(width <= 32000 && height <= 32000, "the image has more than 32000 pixels in a row");
  Require(std::isfinite(sampleDistance) && sampleDistance > 0,
    "the sample distance must be a positive number");
  const double w = frustum.Right - frustum.Left;
  const double h = frustum.Top - frustum.Bottom;
  Require(std::isfinite(w) && std::isfinite(h) && w > 0 && h > 0, "the view has no extent");
  const std::array rows{ ToVector(toEye[0]), ToVector(toEye[1]), ToVector(toEye[2]) };
  const double determinant =
    GetDeterminant(glm::dvec3(rows[0]), glm::dvec3(rows[1]), glm::dvec3(rows[2]));
  Require(std::isfinite(determinant) && determinant != 0, "the camera's matrix has no inverse");

  this->ScaleX = w / width;
  this->ScaleY = h / height;
  this->CenterX = -frustum.Left / this->ScaleX - 0.5 - OffsetX;
  this->CenterY = -frustum.Bottom / this->ScaleY - 0.5 - OffsetY;
  const glm::dvec4 depth = -rows[2];
  const glm::dvec4 times = frustum.Parallel ? glm::dvec4(0, 0, 0, 1) : depth;
  this->ToRays[0] = ToArray(rows[0] / this->ScaleX + this->CenterX * times);
  this->ToRays[1] = ToArray(rows[1] / this->ScaleY + this->CenterY * times);
  this->ToRays[2] = ToArray(frustum.Parallel ? depth / sampleDistance : depth);
}

//------------------------------------------------------------------------------
std::array<double, 3> RayView::Transform(const std::array<double, 3>& point) const
{
  const glm::dvec3 p = ToVector(point);
  const auto& rows = this->ToRays;
  return { gatun::Transform(rows[0], p), gatun::Transform(rows[1], p),
    gatun::Transform(rows[2], p) };
}

//------------------------------------------------------------------------------
double RayView::GetSamplesPerDepth(double x, double y) const
{
  if (!this->Perspective)
  {
    return 1 / this->SampleDistance;
  }
  const double u = (x - this->CenterX) * this->ScaleX;
  const double v = (y - this->CenterY) * this->ScaleY;
  return std::sqrt(1 + u * u + v * v) / this->SampleDistance;
}

//------------------------------------------------------------------------------
void ClipByPlane(const RayView& view, const std::array<double, 4>& plane, RayLimits& limits)
{
  // The plane in ray coordinates is n . p + d = 0 with n M = (a, b, c). By Cramer's rule.
  const glm::dvec3 a(ToVector(view.ToRays[0]));
  const glm::dvec3 b(ToVector(view.ToRays[1]));
  const glm::dvec3 c(ToVector(view.ToRays[2]));
  const glm::dvec3 shift(view.ToRays[0][3], view.ToRays[1][3], view.ToRays[2][3]);
  const glm::dvec3 given(ToVector(plane));
  const glm::dvec3 n = glm::dvec3(GetDeterminant(given, b, c), GetDeterminant(given, c, a),
                         GetDeterminant(given, a, b)) /
    GetDeterminant(a, b, c);
  const double d = plane[3] - glm::dot(n, shift);
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
    const double across = n.x * x + n.y * y;
    const double slope = view.Perspective ? across + n.z : n.z;
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
