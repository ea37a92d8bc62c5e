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
class vtkGatunDefaults;

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

/** What is seen. */
struct CameraSubject
{
  gatun::Bounds Box;
  vtkGatunDefaults* Defaults = nullptr; ///< its input is the object
  double Aspect = 1;                    ///< of the image
};

/** Makes the camera of an image. It sees the whole object, which fills the image as
 * vtkGatunDefaults fits it, with the values of the file in place of those. The other options move
 * it. Throws Failure for the file if the result is no view. */
vtkSmartPointer<vtkCamera> MakeCamera(const CameraOptions& options, const CameraSubject& subject);

/** Returns a camera in the form of such a file. */
Json::Value DescribeCamera(vtkCamera* camera);
}

#endif
