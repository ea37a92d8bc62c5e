// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnImageOptions_h
#define gtnImageOptions_h

// The options of images of any kind.

#include "gtnCamera.h"
#include "gtnCommandLine.h"
#include "gtnWriteImage.h"

#include "gatunTypes.h"

#include "vtkSmartPointer.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

class vtkCamera;
class vtkGatunDefaults;
class vtkVolumeProperty;

namespace gtn
{
struct ImageOptions
{
  std::string Out;
  bool Overwrite = false;
  int Width = 1024;
  int Height = 768;
  std::optional<Color> Background;

  CameraOptions Camera;

  std::optional<gatun::Range> Range;
  double Opacity = 1;
  std::optional<double> UnitDistance;

  bool Statistics = false;
  bool Json = false;
};

/** The source of an image. */
struct ImageContent
{
  std::string File;
  std::string Array;
  gatun::Range Range; ///< of the array
};

/** --size and --background. */
void AddImageOptions(CLI::App* command, ImageOptions& options);

/** All options of a camera except --parallel. What: the kind of data, as "mesh". */
void AddViewOptions(CLI::App* command, CameraOptions& camera, const std::string& what);

/** --range, --opacity and --unit-distance. */
void AddColorOptions(CLI::App* command, ImageOptions& options, const std::string& what);

/** Parses two finite numbers in ascending order, as "0.5,2". */
gatun::Range ParseRange(const char* option, const std::string& text);

/** Opacities of a transfer function. */
enum class OpacityKind
{
  Structure, ///< as vtkGatunDefaults makes them from a histogram, for a length
  Ramp       ///< that grow with the values, for images in which lengths do not matter
};

/** Returns colors and opacities, with the unit distance, scaled as the options demand. Defaults:
 * their input is the object, whose box is given. Throws Failure. */
vtkSmartPointer<vtkVolumeProperty> MakeImageProperty(const ImageOptions& options,
  const ImageContent& content, vtkGatunDefaults* defaults, const gatun::Bounds& box,
  OpacityKind kind);

/** Returns the keys and strings that are stored in an image. */
std::vector<std::pair<std::string, std::string>> MakeRemarks(
  const ImageContent& content, const std::string& commandLine, vtkCamera* camera);
}

#endif
