// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunDetailWeights.h"

#include "gatunVector.h"

#include <glm/matrix.hpp>

#include <cmath>
#include <limits>

namespace gatun
{
namespace
{
constexpr double Fade = 0.1;   // of the size of the object
constexpr double Near = 0.001; // of it, too

using Plane = std::array<double, 4>;

double Evaluate(const Plane& plane, const std::array<double, 3>& p)
{
  return plane[0] * p[0] + plane[1] * p[1] + plane[2] * p[2] + plane[3];
}

/** The largest or smallest value in a box. */
double EvaluateExtreme(const Plane& plane, const Bounds& box, bool largest)
{
  double sum = plane[3];
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const bool takesMax = (plane[axis] > 0) == largest;
    sum += plane[axis] * (takesMax ? box[axis].Max : box[axis].Min);
  }
  return sum;
}
}

//------------------------------------------------------------------------------
double GetDiagonal(const Bounds& box)
{
  double length = 0;
  for (const Range& side : box)
  {
    length = std::hypot(length, side.IsEmpty() ? 0 : side.Max - side.Min);
  }
  return length;
}

//------------------------------------------------------------------------------
DetailWeights::DetailWeights(const RayView& view, double size)
  : Size(size)
  , Scale(1 / std::min(view.ScaleX, view.ScaleY))
  , LeastDepth(std::max(view.Near, Near * size))
  , Perspective(view.Perspective)
{
  this->Depth = view.ToRays[2];
  if (!view.Perspective)
  {
    for (double& x : this->Depth)
    {
      x *= view.SampleDistance;
    }
  }
  const Plane one = view.Perspective ? this->Depth : Plane{ 0, 0, 0, 1 };
  const auto add = [&](const Plane& row, double factor, double border)
  {
    Plane side{};
    for (std::size_t i = 0; i < 4; ++i)
    {
      side[i] = factor * (row[i] - border * one[i]);
    }
    const double length = std::hypot(side[0], side[1], side[2]);
    for (double& x : side)
    {
      x /= length;
    }
    this->Sides.push_back(side);
  };
  add(view.ToRays[0], 1, -0.5);
  add(view.ToRays[0], -1, view.Width - 0.5);
  add(view.ToRays[1], 1, -0.5);
  add(view.ToRays[1], -1, view.Height - 0.5);
  const auto addDepth = [&](double factor, double border)
  {
    this->Sides.push_back({ factor * this->Depth[0], factor * this->Depth[1],
      factor * this->Depth[2], factor * (this->Depth[3] - border) });
  };
  addDepth(1, view.Near);
  addDepth(-1, view.Far);

  // The place with ray coordinates 0, and the direction in which the first two are.
  const auto& rows = view.ToRays;
  const glm::dmat3 rays(ToVector(rows[0]), ToVector(rows[1]), ToVector(rows[2]));
  const glm::dmat3 inverse = glm::inverse(rays);
  this->Eye = ToArray(glm::dvec3(-rows[0][3], -rows[1][3], -rows[2][3]) * inverse);
  this->Back = ToArray(glm::dvec3(0, 0, -1) * inverse);
}

//------------------------------------------------------------------------------
float DetailWeights::Weigh(double depth, double outside) const
{
  const double left = 1 - outside / (Fade * this->Size);
  const double pixels =
    this->Scale * this->Size / (this->Perspective ? std::max(depth, this->LeastDepth) : 1);
  // Not a number only if the point is not.
  return left > 0
    ? static_cast<float>(std::min(left * pixels, double{ std::numeric_limits<float>::max() }))
    : 0;
}

//------------------------------------------------------------------------------
float DetailWeights::Get(const std::array<double, 3>& point) const
{
  double outside = 0;
  for (const Plane& side : this->Sides)
  {
    const double distance = Evaluate(side, point);
    if (!std::isfinite(distance))
    {
      return 0;
    }
    outside = std::max(outside, -distance);
  }
  return this->Weigh(Evaluate(this->Depth, point), outside);
}

//------------------------------------------------------------------------------
float DetailWeights::Get(const Bounds& box) const
{
  if (box.IsEmpty())
  {
    return 0;
  }
  double outside = 0;
  for (const Plane& side : this->Sides)
  {
    outside = std::max(outside, -EvaluateExtreme(side, box, true));
  }
  return this->Weigh(EvaluateExtreme(this->Depth, box, false), outside);
}
}
