// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunRayView_h
#define gatunRayView_h

#include "gatunTypes.h"
#include "vtkGatunCoreModule.h"

#include <array>
#include <vector>

namespace gatun
{
/** The part of space that a picture shows, as OpenGL's glFrustum and glOrtho have it. */
struct RayFrustum
{
  bool Parallel = false;
  /** Borders of the picture, to the right and upwards: in world units, or in perspective those at
   * depth 1. */
  double Left = -1, Right = 1, Bottom = -1, Top = 1;
  double Near = 0;   ///< depth in front of which nothing is seen; world units
  double Far = 1e30; ///< and behind which
};

/**
 * Rays through the pixels of a picture, and the samples on them.
 *
 * Sample k of a ray is k sample distances away: from the eye, along the ray, in a perspective; from
 * the camera's plane in a parallel projection. Pixel (0, 0) is at the lower left. The ray of a
 * pixel is through its centre but for a ten-thousandth, so that symmetric meshes look the same from
 * all sides.
 *
 * Ray coordinates are, in a parallel projection, x and y in pixels and z the depth in sample
 * distances; in a perspective z is the depth Z in world units, and x and y are pixels times Z.
 * Either way they are affine in world coordinates, planes stay planes, and z grows away from the
 * eye. The ray of pixel (i, j) is where x, or x / Z, is i, and so on.
 */
struct VTKGATUNCORE_EXPORT RayView
{
  /** Where the ray of a pixel meets it, right of its centre and above it; in pixels. */
  static constexpr double OffsetX = 2.7e-4;
  static constexpr double OffsetY = 3.1e-4;

  /** Samples from the eye at most: beyond, single precision no longer tells them apart. */
  static constexpr double MostSamples = 4e6;

  bool Perspective = false;
  int Width = 0;
  int Height = 0;
  std::array<std::array<double, 4>, 3> ToRays{}; ///< ray coordinates from world coordinates

  // In perspective, a step of 1 in depth along the ray of pixel (x, y) is one of
  // |((x - CentreX) ScaleX, (y - CentreY) ScaleY, 1)| in world units.
  double CentreX = 0;
  double CentreY = 0;
  double ScaleX = 0;
  double ScaleY = 0;

  double SampleDistance = 1; ///< world units
  double Near = 0;           ///< depths, world units
  double Far = 1e30;

  /**
   * toEye brings world coordinates to those of the eye (x to the right, y up, z towards who looks),
   * in rows, affine. Throws InvalidInput for a picture, a distance or a matrix that is of no use.
   */
  RayView(const std::array<std::array<double, 4>, 3>& toEye, const RayFrustum& frustum, int width,
    int height, double sampleDistance);

  /** Ray coordinates of a point in world coordinates. */
  std::array<double, 3> Transform(const std::array<double, 3>& point) const;

  /** How far a unit of depth is along the ray of a pixel, in samples. */
  double GetSamplesPerDepth(double x, double y) const;

  bool operator==(const RayView&) const = default;
};

/** For each pixel, row by row from below, the samples between which a ray counts; or none. */
struct RayLimits
{
  std::vector<float> Near, Far;

  /** What is on the negative side of one is limited away: nobody need look at it. */
  std::vector<std::array<double, 4>> Planes;

  bool operator==(const RayLimits&) const = default;
};

/** Cuts away what is on the negative side of a plane a x + b y + c z + d = 0 in world coordinates.
 */
VTKGATUNCORE_EXPORT void ClipByPlane(
  const RayView& view, const std::array<double, 4>& plane, RayLimits& limits);
}

#endif
