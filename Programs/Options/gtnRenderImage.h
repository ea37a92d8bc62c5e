// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnTurntable_h
#define gtnTurntable_h

// The loop over the images that a command renders: one, or those of a turntable.

#include "gtnImageOptions.h"
#include "gtnRenderStatistics.h"
#include "gtnSettings.h"

#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <vector>

class vtkCamera;
class vtkGatunDefaults;
class vtkImageData;

namespace gtn
{
class Progress;

/** The functions of a command that renders. They may throw. */
struct Renderer
{
  ImageContent Content;
  gatun::Bounds Bounds;
  vtkGatunDefaults* Defaults = nullptr; ///< for the camera
  std::function<vtkImageData*(vtkCamera* camera, Progress& progress)> Render;
  std::function<Statistics()> GetStatistics; ///< of the last image
};

struct RenderedImage
{
  std::string File;
  vtkSmartPointer<vtkCamera> Camera;
  Statistics Taken; ///< seconds and bytes read, and the statistics of the renderer
};

struct RenderedImages
{
  std::vector<RenderedImage> Images;
  double PeakMemory = 0; ///< while rendering, in bytes
};

/** Throws UsageError or Failure if the images cannot be written by their names. */
void CheckImages(const ImageOptions& options);

/** Renders and writes all images. */
RenderedImages RenderImages(
  const ImageOptions& options, const Settings& settings, const Renderer& renderer);

/** Prints a line, and statistics if they are wanted; or adds all images to the JSON and prints it.
 * What: the rendered data, for the line. */
void PrintImages(const ImageOptions& options, const Settings& settings,
  const RenderedImages& rendered, const std::string& what, Json::Value json);
}

#endif
