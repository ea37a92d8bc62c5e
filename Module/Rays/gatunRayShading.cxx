// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunRayShading.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>

namespace gatun
{
namespace
{
using Vec = glm::dvec3;

Vec ToVec(const std::array<double, 3>& v)
{
  return { v[0], v[1], v[2] };
}

Vec ToWorld(const RayShading& shading, const RayPoint& point)
{
  const auto& m = shading.ToWorld;
  const auto get = [&](std::size_t row)
  { return m[row][0] * point.X + m[row][1] * point.Y + m[row][2] * point.Z + m[row][3]; };
  return { get(0), get(1), get(2) };
}

/** Of length 1, or 0 where there is no direction. */
Vec Normalize(const Vec& v)
{
  const double length = glm::length(v);
  return length > 0 && std::isfinite(length) ? v / length : Vec(0.0);
}

/** From a point to what is there, or far away. */
Vec GetDirection(const std::array<double, 4>& to, const Vec& from)
{
  return Normalize(Vec(to[0], to[1], to[2]) - to[3] * from);
}

/** Up to a positive factor. */
Vec GetGradient(const std::array<Vec, 4>& p, const std::array<double, 4>& values)
{
  const Vec u = p[1] - p[0];
  const Vec v = p[2] - p[0];
  const Vec w = p[3] - p[0];
  const Vec sum = (values[1] - values[0]) * glm::cross(v, w) +
    (values[2] - values[0]) * glm::cross(w, u) + (values[3] - values[0]) * glm::cross(u, v);
  return glm::dot(u, glm::cross(v, w)) < 0 ? -sum : sum;
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
    scale += shading.Diffuse * std::abs(along) * ToVec(light.Diffuse);
    const double mirrored = glm::dot(2 * along * normal - toLight, toEye);
    if (mirrored > 0)
    {
      add += shading.Specular * std::pow(mirrored, shading.SpecularPower) * ToVec(light.Specular);
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
