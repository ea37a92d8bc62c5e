// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunRayShading_h
#define gatunRayShading_h

#include "gatunExport.h"
#include "gatunRayBlock.h"

#include <array>
#include <cstddef>
#include <vector>

namespace gatun
{
/** A light without attenuation. */
struct RayLight
{
  /** The position in world coordinates, with 1 at the end; or the direction to a light at infinity,
   * with 0 at the end. */
  std::array<double, 4> Position{ 0, 0, 1, 0 };

  std::array<double, 3> Diffuse{ 1, 1, 1 }; ///< red, green, blue
  std::array<double, 3> Specular{ 1, 1, 1 };

  bool operator==(const RayLight&) const = default;
};

/**
 * Two-sided Phong shading of surfaces of equal values. The normal of a tetrahedron is its gradient.
 * A tetrahedron without a gradient, such as one with constant values, is not shaded.
 */
struct RayShading
{
  std::vector<RayLight> Lights;
  std::array<double, 4> Eye{ 0, 0, 1, 0 }; ///< as a light's Position
  double Ambient = 0.1;                    ///< fractions of the color, as in vtkVolumeProperty
  double Diffuse = 0.7;
  double Specular = 0.2;
  double SpecularPower = 10;

  /** Affine matrix, in rows, from the coordinates of the mesh to those of the world. */
  std::array<std::array<double, 4>, 3> ToWorld{ { { 1, 0, 0, 0 }, { 0, 1, 0, 0 },
    { 0, 0, 1, 0 } } };

  bool operator==(const RayShading&) const = default;
};

/** The effect of light on a color: Scale times the color, plus Add times white. Red, green and
 * blue; the fourth numbers are 1 and 0. */
struct alignas(32) RayShade
{
  std::array<float, 4> Scale{ 1, 1, 1, 1 };
  std::array<float, 4> Add{};
};

/** Returns the effect of light on a tetrahedron of a block. */
GATUN_EXPORT RayShade GetShade(const RayShading& shading, const RayBlock& block, std::size_t tet);
}

#endif
