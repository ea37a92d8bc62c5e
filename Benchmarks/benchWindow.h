// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef benchWindow_h
#define benchWindow_h

// Volume mappers, Gatun's and VTK's, in windows that nobody sees.

#include "benchScene.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkRenderWindow;
class vtkRenderer;
class vtkUnstructuredGridVolumeMapper;

namespace bench
{
using Mapper = vtkSmartPointer<vtkUnstructuredGridVolumeMapper>;

/** gatun, bunyk (vtkUnstructuredGridVolumeRayCastMapper), zsweep, projected (tetrahedra). */
const std::vector<std::string>& GetMapperNames();

/** A mapper by its name, for a point array; a ray for each pixel. Budget: Gatun's, in MiB. */
Mapper MakeMapper(const std::string& name, const std::string& array, int budget);

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

  /** The same from a place on the way into it; see Scene::Approach. */
  void RenderOnApproach(double part);

  /** Pictures a second that are wanted from now on, from which the time for one is derived. */
  void SetUpdateRate(double rate);

  /** Of the last picture. */
  Seen Look();

  /** Red, green and blue of the last picture, 0 to 255. */
  std::vector<unsigned char> GetPixels();

private:
  Scene View;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
};
}

#endif
