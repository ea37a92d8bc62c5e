// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnPictureOptions_h
#define gtnPictureOptions_h

// What can be told of pictures, whatever is in them.

#include "gtnCamera.h"
#include "gtnPicture.h"
#include "gtnTransfer.h"

#include "gatunTypes.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <utility>
#include <vector>

class vtkCamera;

namespace gtn
{
struct PictureOptions
{
  std::string Out;
  bool Overwrite = false;
  int Width = 1024;
  int Height = 768;
  int Turntable = 0; ///< how many pictures; 0: one, and no number in its name
  std::optional<Colour> Background;

  CameraOptions Camera;

  std::string TransferFunction = "dusk";
  std::optional<gatun::Range> Range;
  double Opacity = 1;
  std::optional<double> UnitDistance;

  bool Statistics = false;
  bool Json = false;
};

/** What is drawn. */
struct PictureContent
{
  std::string File;
  std::string Array;
  gatun::Range Range; ///< of the array
};

/** --size, --background and --turntable. */
void AddPictureOptions(CLI::App* command, PictureOptions& options);

/** The options of a camera but --parallel. What: "mesh", say. */
void AddViewOptions(CLI::App* command, CameraOptions& camera, const std::string& what);

/** --tf and what changes it. */
void AddColourOptions(CLI::App* command, PictureOptions& options, const std::string& what);

/** Two finite numbers in ascending order, "0.5,2". */
gatun::Range ParseRange(const char* option, const std::string& text);

/** OUT, or of a turntable OUT with numbers before its extension. */
std::vector<std::string> NamePictures(const PictureOptions& options);

/** The transfer function, stretched as the options say. Throws Failure. */
Transfer MakeTransfer(const PictureOptions& options, const PictureContent& content);

/** That of a box, or 1. */
double DiagonalOf(const gatun::Bounds& bounds);

/** What a picture says of itself. */
std::vector<std::pair<std::string, std::string>> MakeRemarks(
  const PictureContent& content, const std::string& commandLine, vtkCamera* camera);
}

#endif
