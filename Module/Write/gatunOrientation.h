// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunOrientation_h
#define gatunOrientation_h

#include <array>

namespace gatun
{
/**
 * The sign of (b - a) x (c - a) . (d - a), the orientation of a tetrahedron: 1, -1, or 0 if the
 * points are in a plane. Exact, if no product of three differences of coordinates, relative to the
 * largest one, is below the smallest numbers of double precision. 0 if a coordinate is not finite.
 */
int GetOrientation(const std::array<double, 3>& a, const std::array<double, 3>& b,
  const std::array<double, 3>& c, const std::array<double, 3>& d);
}

#endif
