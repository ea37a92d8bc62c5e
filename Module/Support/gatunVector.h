// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunVector_h
#define gatunVector_h

// From the arrays of the core's interfaces to vectors of GLM, which set-up code computes with.

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>

namespace gatun
{
inline glm::dvec3 ToVector(const std::array<double, 3>& a)
{
  return { a[0], a[1], a[2] };
}

inline glm::dvec4 ToVector(const std::array<double, 4>& a)
{
  return { a[0], a[1], a[2], a[3] };
}

inline std::array<double, 3> ToArray(const glm::dvec3& v)
{
  return { v.x, v.y, v.z };
}

inline std::array<double, 4> ToArray(const glm::dvec4& v)
{
  return { v.x, v.y, v.z, v.w };
}

/** A row of an affine matrix times a point. */
inline double Transform(const std::array<double, 4>& row, const glm::dvec3& point)
{
  return glm::dot(glm::dvec3(ToVector(row)), point) + row[3];
}

/** Six times the signed volume of the tetrahedron that three vectors span. */
inline double GetDeterminant(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
  return glm::dot(a, glm::cross(b, c));
}
}

#endif
