// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnRenderImage_h
#define gtnRenderImage_h

// What the commands that render have in common: the image and what is printed of it.

#include "gtnImageOptions.h"
#include "gtnRenderStatistics.h"
#include "gtnSettings.h"

#include "vtkSmartPointer.h"

#include <functional>
#include <string>

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
  std::function<Statistics()> GetStatistics; ///< of the image
};

struct RenderedImage
{
  vtkSmartPointer<vtkCamera> Camera;
  Statistics Taken;      ///< seconds and bytes read, and the statistics of the renderer
  double PeakMemory = 0; ///< while rendering, in bytes
};

/** Throws UsageError or Failure if the image cannot be written by its name. */
void CheckImage(const ImageOptions& options);

/** Renders and writes the image. */
RenderedImage RenderImage(
  const ImageOptions& options, const Settings& settings, const Renderer& renderer);

/** Prints a line, and statistics if they are wanted; or adds the image to the JSON and prints it.
 * What: the rendered data, for the line. */
void PrintImage(const ImageOptions& options, const Settings& settings,
  const RenderedImage& rendered, const std::string& what, Json::Value json);
}

#endif
