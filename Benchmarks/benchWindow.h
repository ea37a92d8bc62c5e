// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef benchWindow_h
#define benchWindow_h

// Volume mappers, Gatun's and VTK's, in windows that nobody sees.

#include "benchScene.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <string>

class vtkRenderWindow;
class vtkRenderer;
class vtkUnstructuredGridVolumeMapper;

namespace bench
{
using Mapper = vtkSmartPointer<vtkUnstructuredGridVolumeMapper>;

/** vtkGatunVolumeMapper with a memory budget in MiB, or vtkUnstructuredGridVolumeRayCastMapper; a
 * ray for each pixel. */
Mapper MakeMapper(bool isGatun, const std::string& array, int budget);

/** A square window with at most one volume. Needs a display. */
class VolumeWindow
{
public:
  /** Opens the window and draws it empty. */
  explicit VolumeWindow(int size);
  ~VolumeWindow();
  VolumeWindow(const VolumeWindow&) = delete;
  VolumeWindow& operator=(const VolumeWindow&) = delete;

  void SetVolume(vtkUnstructuredGridVolumeMapper* mapper, const Scene& scene);

  /** Draws the volume from a place around it, and waits until it is drawn. */
  void Render(double turn = 0);

  /** The mean of all colors of the last image, 0 to 1, so that a wrong one does not pass for a fast
   * one. Throws Failure if it is black. */
  double GetMean();

private:
  Scene View;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
};
}

#endif
