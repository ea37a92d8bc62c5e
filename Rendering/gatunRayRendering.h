// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunRayRendering_h
#define gatunRayRendering_h

// VTK's cameras and properties as the ray caster wants them.

#include "gatunDetailView.h"
#include "gatunRayCaster.h"

#include "vtkType.h" // For VTK_ABI_NAMESPACE_BEGIN

#include <memory>
#include <optional>
#include <span>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkCamera;
class vtkLightCollection;
class vtkMatrix4x4;
class vtkPlaneCollection;
class vtkVolumeProperty;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/** How rays are spread over an image. */
struct RayGrid
{
  int Width = 0;
  int Height = 0;
  double Aspect = 0; ///< of the image; 0: as there are as many rays

  /** Whether the outermost rays are at the borders of the image instead of half a ray inside:
   * between them, all of the image can be interpolated. At least two rays each way. */
  bool ToBorders = false;
};

/** What a camera sees: eye coordinates, x to the right, y upwards and z backwards, of those of the
 * world, and the borders of its image in them. */
struct RayEye
{
  std::array<std::array<double, 4>, 3> FromWorld{};
  RayFrustum Frustum; ///< but for the clipping range
};

/** That of a camera, or its left or right eye if it is in stereo. VolumeMatrix: null, or what
 * brings the volume into the world; FromWorld then begins with coordinates of the volume. */
RayEye MakeRayEye(vtkCamera* camera, const RayGrid& grid, vtkMatrix4x4* volumeMatrix);

/**
 * The rays of a camera, that of its left or right eye if it is in stereo. VolumeMatrix: null, or
 * what brings the mesh into the world. ClippingRange: whether what is out of the camera's is left
 * out.
 */
RayView MakeRayView(
  vtkCamera* camera, const RayGrid& grid, vtkMatrix4x4* volumeMatrix, bool clippingRange);

/** Throws Error(InvalidInput) if a property is NaN, which clamping lets through. */
void RequireNumber(const char* property, double value);

/** Blend modes of vtkGatunRayCaster and vtkGatunVolumeMapper. */
enum BlendMode
{
  CompositeBlend = 0,
  MaximumIntensityBlend = 1,
  XRayBlend = 101
};

/** The core's mode for a blend mode; nothing if there is no such mode. */
std::optional<RayMode> RayModeOf(int blendMode);

/** Colors and opacities of a property, for values in a range. Unit distance: the property's. */
RayTable MakeRayTable(
  vtkVolumeProperty* property, RayMode mode, const Range& values, double sampleDistance);

/** What an image needs of a mesh. View: with a ray for each pixel. */
std::shared_ptr<const DetailView> MakeDetailView(
  double pixelError, const RayView& view, RayTable table);

/** How light falls on a volume, if its property wants shading. Lights: null for one at the camera.
 */
std::optional<RayShading> MakeRayShading(vtkVolumeProperty* property, vtkCamera* camera,
  vtkLightCollection* lights, vtkMatrix4x4* volumeMatrix);

/** Clips by planes that are given in world coordinates. Null for none. */
RayLimits MakeRayLimits(
  const RayView& view, vtkPlaneCollection* planes, vtkMatrix4x4* volumeMatrix);

/**
 * Ends rays at what is drawn already. ZBuffer: of the camera's image, width times height values
 * from 0, at the near end of the clipping range, to 1, where there is nothing.
 */
void LimitByZBuffer(const RayView& view, vtkCamera* camera, const RayGrid& grid,
  std::span<const float> zBuffer, int width, int height, RayLimits& limits);
}

#endif
