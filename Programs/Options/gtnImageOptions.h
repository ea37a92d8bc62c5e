// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnImageOptions_h
#define gtnImageOptions_h

// The options of images of any kind.

#include "gtnCamera.h"
#include "gtnCommandLine.h"
#include "gtnTransfer.h"
#include "gtnWriteImage.h"

#include "gatunTypes.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

class vtkCamera;
class vtkGatunDefaults;
class vtkVolumeProperty;

namespace gtn
{
/** The transfer function that vtkGatunDefaults makes. */
constexpr const char* AutomaticTransfer = "auto";

struct ImageOptions
{
  std::string Out;
  bool Overwrite = false;
  int Width = 1024;
  int Height = 768;
  int Turntable = 0; ///< number of images; 0: one, without a number in its name
  std::optional<Color> Background;

  CameraOptions Camera;

  std::string TransferFunction = AutomaticTransfer;
  std::optional<gatun::Range> Range;
  double Opacity = 1;
  std::optional<double> UnitDistance;
  std::string SaveTransfer; ///< file; may be empty

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

/** --size, --background and --turntable. */
void AddImageOptions(CLI::App* command, ImageOptions& options);

/** All options of a camera except --parallel. What: the kind of data, as "mesh". */
void AddViewOptions(CLI::App* command, CameraOptions& camera, const std::string& what);

/** --tf, --range, --opacity and --unit-distance. */
void AddColorOptions(CLI::App* command, ImageOptions& options, const std::string& what);

/** Parses two finite numbers in ascending order, as "0.5,2". */
gatun::Range ParseRange(const char* option, const std::string& text);

/** Returns OUT, or for a turntable OUT with numbers before its extension. */
std::vector<std::string> NameImages(const ImageOptions& options);

/** Returns the preset or file, scaled as the options demand. Throws Failure. */
Transfer MakeTransfer(const ImageOptions& options, const ImageContent& content);

/** Returns the transfer function, with the unit distance, scaled as the options demand, and saves
 * it if they want that. Defaults:
 * their input is the object, whose box is given. Throws Failure. */
vtkSmartPointer<vtkVolumeProperty> MakeImageProperty(const ImageOptions& options,
  const ImageContent& content, vtkGatunDefaults* defaults, const gatun::Bounds& box);

/** Saves the functions of a property if the options want that. Throws Failure. */
void SaveTransfer(const ImageOptions& options, vtkVolumeProperty* property);

/** Returns the diagonal of a box, or 1 if it is not finite and above 0. */
double DiagonalOf(const gatun::Bounds& bounds);

/** Returns the keys and strings that are stored in an image. */
std::vector<std::pair<std::string, std::string>> MakeRemarks(
  const ImageContent& content, const std::string& commandLine, vtkCamera* camera);
}

#endif
