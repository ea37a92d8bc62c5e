// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef benchVolumeWindow_h
#define benchVolumeWindow_h

// What draws volumes from voxels: VTK's ray caster on the processor.

#include "benchVolume.h"

#include "vtkNew.h"

class vtkFixedPointVolumeRayCastMapper;
class vtkRenderWindow;
class vtkRenderer;

namespace bench
{
/** vtkFixedPointVolumeRayCastMapper in a window that nobody sees. Needs a display. */
class FixedPointWindow
{
public:
  /** The exponential and the linear model come as opacities of a sample; XRay as additive blending.
   */
  FixedPointWindow(const Volume& volume, unsigned pixels, const gatun::HartleyShading& shading);
  ~FixedPointWindow();
  FixedPointWindow(const FixedPointWindow&) = delete;
  FixedPointWindow& operator=(const FixedPointWindow&) = delete;

  /** Draws what the view sees, and waits until it is drawn. */
  void Render(const gatun::HartleyView& view);

  /** Mean of all colors of the last image, 0 to 1. */
  double GetMean();

private:
  const Volume& Shown;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkFixedPointVolumeRayCastMapper> Mapper;
};
}

#endif
