// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunVolumeImage_h
#define gatunVolumeImage_h

#include "gatunRayImage.h"
#include "gatunRayRefresh.h"
#include "gatunVolumeFrame.h"

#include <memory>
#include <vector>

namespace gatun
{
class RayScene;

/** The image of a volume mapper, of which only what changes is drawn again where that is possible.
 * Methods throw gatun::Error. */
class VolumeImage
{
public:
  /** Draws a scene, or another source of the same mesh if it is not null. */
  RayStatistics Draw(RayScene& scene, RaySource* other, const ImageSetup& setup,
    const RayGrid& grid, const RaySource::Progress& progress);

  /** Draws the tiles that another number of points changes, and which are the same for each way to
   * them. */
  void DrawChanges(std::shared_ptr<RaySource> source, ImageSetup setup, const RayGrid& grid,
    const RaySource::Progress& progress);

  /** Takes the colors of an image that was drawn elsewhere. */
  void Take(const std::vector<float>& colors, const Viewport& viewport);

  /** Shows the image in front of all, or at the depth of the volume's center. */
  void Show(const VolumeFrame& frame, bool inFront);

  void Release(vtkWindow* window) { this->Image.Release(window); }

  /** The part of the last image that was drawn again, 0 to 1. */
  double GetRedrawnFraction() const { return this->Redrawn; }

private:
  RayImage Image;
  double Redrawn = 0;

  // For bringing the last image up to date, if that is possible.
  std::shared_ptr<const ImageSetup> Setup;
  std::unique_ptr<RayRefresh> Refresh;
};
}

#endif
