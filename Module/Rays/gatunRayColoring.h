// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunRayColoring_h
#define gatunRayColoring_h

#include "gatunRayBlock.h"
#include "vtkGatunCoreModule.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace gatun
{
/**
 * Colors of points by RayHues, in place of those of the transfer function. Within a tetrahedron,
 * colors are linear between its corners, while opacities are those of the exact transfer function.
 */
struct VTKGATUNCORE_EXPORT RayColoring
{
  using Color = std::array<float, 3>;

  /** Of values from Low on, Scale entries for each unit of value; between them it is linear. If
   * empty, three values are red, green and blue: (value - Low) Scale, clamped to 0 and 1. */
  std::vector<Color> Table;
  double Low = 0;
  double Scale = 1;
  Color NotANumber{ 0.5f, 0.5f, 0.5f };

  Color Get(std::span<const double> values) const;

  bool operator==(const RayColoring&) const = default;
};

/** Colors as linear functions of ray coordinates in a tetrahedron: T + x X + y Y + z Z, for red,
 * green and blue, and what they are at most and at least. */
struct RayHue
{
  std::array<double, 3> T{}, X{}, Y{}, Z{};
  std::array<float, 3> Low{}, High{};
};

/** The colors of the points or tetrahedra of a block, if it has any. */
std::vector<RayColoring::Color> GetHueColors(const RayColoring& coloring, const RayHues& hues);

/** Points: in ray coordinates. Colors: as by GetHueColors. */
RayHue GetHue(const RayBlock& block, std::span<const RayPoint> points,
  std::span<const RayColoring::Color> colors, std::size_t tet);
}

#endif
