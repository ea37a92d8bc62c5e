// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunRayView_h
#define gatunRayView_h

#include "gatunExport.h"
#include "gatunTypes.h"

#include <array>
#include <vector>

namespace gatun
{
/** The view volume of an image, with the parameters of OpenGL's glFrustum and glOrtho. */
struct RayFrustum
{
  bool Parallel = false;
  /** Borders of the image, to the right and upwards, in world units. In perspective they are those
   * at depth 1. */
  double Left = -1, Right = 1, Bottom = -1, Top = 1;
  double Near = 0;   ///< depth of the near clipping plane, in world units
  double Far = 1e30; ///< depth of the far clipping plane
};

/**
 * The rays through the pixels of an image, and the samples on them.
 *
 * Sample k of a ray has a distance of k sample distances: from the eye and along the ray in a
 * perspective projection, from the camera's plane in a parallel one. Pixel (0, 0) is at the lower
 * left. The ray of a pixel passes its center at a ten-thousandth of a pixel, so that symmetric
 * meshes look the same from all sides.
 *
 * Ray coordinates in a parallel projection: x and y are in pixels, z is the depth in sample
 * distances. In a perspective projection z is the depth Z in world units, and x and y are pixels
 * times Z. Both are affine in world coordinates: planes stay planes, and z grows away from the eye.
 * The ray of pixel (i, j) has x = i and y = j, or x / Z = i and y / Z = j in perspective.
 */
struct GATUN_EXPORT RayView
{
  /** Offset of a ray from the center of its pixel, to the right and upwards, in pixels. */
  static constexpr double OffsetX = 2.7e-4;
  static constexpr double OffsetY = 3.1e-4;

  /** Largest number of a sample. Beyond it, single precision cannot distinguish samples. */
  static constexpr double MostSamples = 4e6;

  bool Perspective = false;
  int Width = 0;
  int Height = 0;
  std::array<std::array<double, 4>, 3> ToRays{}; ///< ray coordinates from world coordinates

  // In perspective, a step of 1 in depth along the ray of pixel (x, y) is one of
  // |((x - CenterX) ScaleX, (y - CenterY) ScaleY, 1)| in world units.
  double CenterX = 0;
  double CenterY = 0;
  double ScaleX = 0;
  double ScaleY = 0;

  double SampleDistance = 1; ///< world units
  double Near = 0;           ///< depths, world units
  double Far = 1e30;

  /**
   * toEye is an affine matrix, in rows, from world coordinates to those of the eye (x to the right,
   * y up, z towards the viewer). Throws InvalidInput for an unusable image size, distance or
   * matrix.
   */
  RayView(const std::array<std::array<double, 4>, 3>& toEye, const RayFrustum& frustum, int width,
    int height, double sampleDistance);

  /** Transforms a point from world coordinates to ray coordinates. */
  std::array<double, 3> Transform(const std::array<double, 3>& point) const;

  /** Returns the length of a unit of depth along the ray of a pixel, in samples. */
  double GetSamplesPerDepth(double x, double y) const;

  bool operator==(const RayView&) const = default;
};

/** For each pixel, row by row from below, the samples between which the ray is drawn; or empty. */
struct RayLimits
{
  std::vector<float> Near, Far;

  /** Planes whose negative sides are outside of the limits. Blocks there are skipped. */
  std::vector<std::array<double, 4>> Planes;

  bool operator==(const RayLimits&) const = default;
};

/** Removes the negative side of a plane a x + b y + c z + d = 0 in world coordinates from limits.
 */
GATUN_EXPORT void ClipByPlane(
  const RayView& view, const std::array<double, 4>& plane, RayLimits& limits);
}

#endif
