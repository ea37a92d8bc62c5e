// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunRayImage_h
#define gatunRayImage_h

#include "vtkSmartPointer.h"

#include <functional>
#include <memory>
#include <vector>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkRayCastImageDisplayHelper;
class vtkRenderer;
class vtkVolume;
class vtkWindow;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
class RayCaster;
class RayRefresh;
class RaySource;
struct RayGrid;

/** The depth of a point of the world, from 0 to 1 as in a z-buffer. */
float GetDepth(vtkRenderer* renderer, const double* point);

/** An image on its way from the ray caster into a window. */
class RayImage
{
public:
  /** Width and height that can be shown with a ray in each pixel; larger ones need rays to the
   * borders. Twice as many texels are in reach of every graphics card. */
  static constexpr int MostPixels = 8192;

  RayImage();
  ~RayImage();

  void Take(RayCaster& caster, const RayGrid& grid);

  /** Brings up to date what was taken last, of the same refresh, or takes its first. Returns what
   * part was drawn. */
  double Take(RayRefresh& refresh, std::shared_ptr<RaySource> source, const RayGrid& grid,
    const std::function<bool(double)>& progress);

  /** Takes a pixel's color for each pixel; see RayCaster::Finish. ToBorders: they are those of rays
   * of which the outermost are on the borders of the image. */
  void Take(std::vector<float> colors, int width, int height, bool toBorders = false);

  /**
   * Blends what was taken over all of a renderer's viewport; in front of all there is, or else at
   * the depth of the volume's center. Throws InvalidInput if VTK cannot draw images of volumes.
   */
  void Show(vtkRenderer* renderer, vtkVolume* volume, bool inFront);

  void Release(vtkWindow* window);

private:
  void SetGrid(const RayGrid& grid);

  vtkSmartPointer<vtkRayCastImageDisplayHelper> Helper;
  int Width = 0; // rays
  int Height = 0;
  bool IsExact = false; // a ray is a pixel
  std::vector<float> Colors;
  std::vector<unsigned short> Texels; // of the strip that is being shown
};
}

#endif
