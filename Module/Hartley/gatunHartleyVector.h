// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyVector_h
#define gatunHartleyVector_h

// GLM's vectors and the arrays that interfaces use instead of them.

#include <glm/vec3.hpp>

#include <array>

namespace gatun
{
inline glm::dvec3 ToVec(const std::array<double, 3>& values)
{
  return { values[0], values[1], values[2] };
}

inline std::array<double, 3> ToArray(const glm::dvec3& vector)
{
  return { vector.x, vector.y, vector.z };
}
}

#endif
