// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunRayRendering_h
#define gatunRayRendering_h

// VTK's cameras and properties as the ray caster wants them.

#include "gatunRayCaster.h"

class vtkCamera;
class vtkMatrix4x4;
class vtkPlaneCollection;
class vtkVolumeProperty;

namespace gatun
{
/**
 * The rays of a camera. SampleDistance: in world units; 0 for the size of a pixel at the focal
 * point. VolumeMatrix: null, or what brings the mesh into the world. ClippingRange: whether what is
 * out of the camera's is left out.
 */
RayView MakeRayView(vtkCamera* camera, int width, int height, double sampleDistance,
  vtkMatrix4x4* volumeMatrix, bool clippingRange);

/** Colours and opacities of a property, for values in a range. Unit distance: the property's. */
RayTable MakeRayTable(
  vtkVolumeProperty* property, RayMode mode, const Range& values, double sampleDistance);

/** Clips by planes that are given in world coordinates. Null for none. */
RayLimits MakeRayLimits(
  const RayView& view, vtkPlaneCollection* planes, vtkMatrix4x4* volumeMatrix);
}

#endif
