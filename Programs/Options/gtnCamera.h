// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnCamera_h
#define gtnCamera_h

// The camera of an image.

#include "gtnJson.h"

#include "gatunTypes.h"

#include "vtkSmartPointer.h"

#include <array>
#include <optional>
#include <string>

class vtkCamera;

namespace gtn
{
struct CameraOptions
{
  std::string File; ///< with a camera as JSON; may be empty
  std::optional<double> Azimuth;
  std::optional<double> Elevation;
  double Roll = 0;
  double Zoom = 1;
  bool Parallel = false;

  /** Replaces the file: rotations of the scene about x, then y, then z, in units of pi. The camera
   * looks along z, with x to the right and y down. */
  std::optional<std::array<double, 3>> Turns;
};

/** Makes a camera that sees a whole box, as vtkRenderer::ResetCamera places it, with the values of
 * the file in place of those. Then the other options move it, with a given number of degrees added
 * to the azimuth. Throws Failure for the file if the result is no view. */
vtkSmartPointer<vtkCamera> MakeCamera(
  const CameraOptions& options, const gatun::Bounds& bounds, double aspect, double turn);

/** Returns a camera in the form of such a file. */
Json::Value DescribeCamera(vtkCamera* camera);
}

#endif
