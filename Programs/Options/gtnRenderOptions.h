// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnRenderOptions_h
#define gtnRenderOptions_h

// The options of gtn render.

#include "gtnCommandLine.h"
#include "gtnImageOptions.h"
#include "gtnRenderInput.h"
#include "gtnSettings.h"

#include <string>

namespace gtn
{
struct RenderOptions : ImageOptions
{
  RenderInputOptions Input;
  bool Shade = false;

  int BlendMode = 0; ///< of vtkGatunRayCaster::BlendModes
  double Ratio = 0;
  double TimeBudget = 0;

  // Where the mesh is simplified.
  bool Uniform = false;
  double PixelError = 0;
};

/** Adds the command with all of its options. */
CLI::App* AddRenderOptions(CLI::App& app, Settings& settings, RenderOptions& options);

/** The name of a blend mode on the command line. */
const char* NameOfMode(int blendMode);
}

#endif
