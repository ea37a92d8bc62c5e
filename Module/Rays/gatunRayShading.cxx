// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunRayShading.h"

#include "gatunVector.h"

#include <algorithm>
#include <cmath>

namespace gatun
{
namespace
{
using Vec = glm::dvec3;

Vec ToWorld(const RayShading& shading, const RayPoint& point)
{
  const auto& rows = shading.ToWorld;
  const Vec p(point.X, point.Y, point.Z);
  return { Transform(rows[0], p), Transform(rows[1], p), Transform(rows[2], p) };
}

/** A vector of length 1, or 0 if v has no direction. */
Vec Normalize(const Vec& v)
{
  const double length = glm::length(v);
  return length > 0 && std::isfinite(length) ? v / length : Vec(0.0);
}

/** The direction from a point to a position, which may be at infinity. */
Vec GetDirection(const std::array<double, 4>& to, const Vec& from)
{
  return Normalize(Vec(ToVector(to)) - to[3] * from);
}

/** The gradient of the values times a positive factor. */
Vec GetGradient(const std::array<Vec, 4>& p, const std::array<double, 4>& values)
{
  const Vec u = p[1] - p[0];
  const Vec v = p[2] - p[0];
  const Vec w = p[3] - p[0];
  const Vec sum = (values[1] - values[0]) * glm::cross(v, w) +
    (values[2] - values[0]) * glm::cross(w, u) + (values[3] - values[0]) * glm::cross(u, v);
  return GetDeterminant(u, v, w) < 0 ? -sum : sum;
}
}

//------------------------------------------------------------------------------
RayShade GetShade(const RayShading& shading, const RayBlock& block, std::size_t tet)
{
  RayShade shade;
  if (!block.CellValues.empty())
  {
    return shade;
  }
  std::array<Vec, 4> points;
  std::array<double, 4> values;
  for (std::size_t i = 0; i < 4; ++i)
  {
    const RayPoint& point = block.Points[block.Tets[tet][i]];
    points[i] = ToWorld(shading, point);
    values[i] = point.Value;
  }
  const Vec normal = Normalize(GetGradient(points, values));
  if (normal == Vec(0.0))
  {
    return shade;
  }
  const Vec middle = 0.25 * (points[0] + points[1] + points[2] + points[3]);
  const Vec toEye = GetDirection(shading.Eye, middle);
  Vec scale(shading.Ambient);
  Vec add(0.0);
  for (const RayLight& light : shading.Lights)
  {
    const Vec toLight = GetDirection(light.Position, middle);
    const double along = glm::dot(normal, toLight);
    scale += shading.Diffuse * std::abs(along) * ToVector(light.Diffuse);
    const double mirrored = glm::dot(2 * along * normal - toLight, toEye);
    if (mirrored > 0)
    {
      add +=
        shading.Specular * std::pow(mirrored, shading.SpecularPower) * ToVector(light.Specular);
    }
  }
  for (int c = 0; c < 3; ++c)
  {
    shade.Scale[static_cast<std::size_t>(c)] = static_cast<float>(scale[c]);
    shade.Add[static_cast<std::size_t>(c)] = static_cast<float>(add[c]);
  }
  return shade;
}
}
