// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnCamera_h
#define gtnCamera_h

// From where a mesh is looked at.

#include "gatunTypes.h"

#include "vtkSmartPointer.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>

class vtkCamera;

namespace gtn
{
class Json;

struct CameraOptions
{
  std::string File; ///< with what the camera is, or none
  std::optional<double> Azimuth;
  std::optional<double> Elevation;
  double Roll = 0;
  double Zoom = 1;
  bool Parallel = false;

  /** Instead of a file: rotations of what is seen about x, then y, then z, in units of pi; it is
   * then looked at along z, with x to the right and y downwards. */
  std::optional<std::array<double, 3>> Turns;
};

/** A camera that sees all of a box, as vtkRenderer::ResetCamera places it, but for what the file
 * says; then moved as the other options say, with so many degrees added to the azimuth. Throws
 * Failure, for the file, if what it says makes no view. */
vtkSmartPointer<vtkCamera> MakeCamera(
  const CameraOptions& options, const gatun::Bounds& bounds, double aspect, double turn);

/** Describes a camera as such a file does. */
void AddCamera(Json& json, std::string_view name, vtkCamera* camera);
}

#endif
