// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunRayShading_h
#define gatunRayShading_h

#include "gatunRayBlock.h"
#include "vtkGatunCoreModule.h"

#include <array>
#include <cstddef>
#include <vector>

namespace gatun
{
/** A light, without falloff. */
struct RayLight
{
  /** In world coordinates, where it is (with 1 at the end), or the direction in which it is, for
   * one that is far away (with 0). */
  std::array<double, 4> Position{ 0, 0, 1, 0 };

  std::array<double, 3> Diffuse{ 1, 1, 1 }; ///< red, green, blue
  std::array<double, 3> Specular{ 1, 1, 1 };

  bool operator==(const RayLight&) const = default;
};

/**
 * How lights fall on surfaces of equal values: Phong's model, from both sides. The normal of a
 * tetrahedron is its gradient; one that has none, as where values are the same, is not shaded.
 */
struct RayShading
{
  std::vector<RayLight> Lights;
  std::array<double, 4> Eye{ 0, 0, 1, 0 }; ///< as a light's Position
  double Ambient = 0.1;                    ///< parts of the colour, as in vtkVolumeProperty
  double Diffuse = 0.7;
  double Specular = 0.2;
  double SpecularPower = 10;

  /** From the mesh's coordinates to those of the world, affine, in rows. */
  std::array<std::array<double, 4>, 3> ToWorld{ { { 1, 0, 0, 0 }, { 0, 1, 0, 0 },
    { 0, 0, 1, 0 } } };

  bool operator==(const RayShading&) const = default;
};

/** What becomes of a colour: as much of it as Scale says, and besides as much of white as Add says;
 * red, green and blue, the fourth numbers being 1 and 0. */
struct alignas(32) RayShade
{
  std::array<float, 4> Scale{ 1, 1, 1, 1 };
  std::array<float, 4> Add{};
};

/** For the tetrahedra of a block. */
VTKGATUNCORE_EXPORT RayShade GetShade(
  const RayShading& shading, const RayBlock& block, std::size_t tet);
}

#endif
