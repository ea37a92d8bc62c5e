// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnRenderOptions_h
#define gtnRenderOptions_h

// What gtn render can be told.

#include "gtnCamera.h"
#include "gtnCommands.h"
#include "gtnPicture.h"
#include "gtnRenderInput.h"

#include "gatunTypes.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

namespace gtn
{
struct RenderOptions
{
  std::string Out;
  bool Overwrite = false;
  int Width = 1024;
  int Height = 768;
  int Turntable = 0; ///< how many pictures; 0: one, and no number in its name
  std::optional<Colour> Background;

  RenderInputOptions Input;
  CameraOptions Camera;

  std::string TransferFunction = "dusk";
  std::optional<gatun::Range> Range;
  double Opacity = 1;
  std::optional<double> UnitDistance;
  bool Shade = false;

  int Mode = 0; ///< of vtkGatunRayCaster::ModeType
  std::optional<double> SampleDistance;
  double Ratio = 0;
  double TimeBudget = 0;
  int Memory = 512;

  bool Statistics = false;
  bool Json = false;
};

/** Adds the command with all of its options. */
CLI::App* AddRenderOptions(CLI::App& app, Settings& settings, RenderOptions& options);

/** What a mode is called on the command line. */
const char* NameOfMode(int mode);
}

#endif
