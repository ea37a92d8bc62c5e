// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnRenderOptions.h"

#include "gtnInput.h"
#include "gtnOptions.h"
#include "gtnParse.h"
#include "gtnText.h"

#include "vtkGatunRayCaster.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace gtn
{
namespace
{

struct NamedMode
{
  const char* Name;
  int BlendMode;
};

constexpr std::array<NamedMode, 3> Modes{ { { "composite", vtkGatunRayCaster::COMPOSITE_BLEND },
  { "mip", vtkGatunRayCaster::MAXIMUM_INTENSITY_BLEND },
  { "xray", vtkGatunRayCaster::XRAY_BLEND } } };

void AddMeshOptions(CLI::App* command, RenderOptions& options)
{
  const char* const group = "Data";
  for (CLI::Option* option : AddArray(command, options.Input.Array, "Point or cell array"))
  {
    option->group(group);
  }
  for (CLI::Option* option : AddStep(command, options.Input.Step))
  {
    option->group(group);
  }
}

void AddModeOption(CLI::App* command, RenderOptions& options)
{
  command
    ->add_option_function<std::string>(
      "--mode",
      [&options](const std::string& name)
      {
        options.BlendMode = std::find_if(Modes.begin(), Modes.end(),
          [&name](const NamedMode& mode) {
            return name == mode.Name;
          })->BlendMode;
      },
      "Blend mode: composite (exact integral, front to back), mip (maximum intensity) or xray (sum "
      "of opacities) (default: composite)")
    ->check(CLI::IsMember({ "composite", "mip", "xray" }))
    ->option_text("NAME")
    ->group("Image");
}

void AddShadeOption(CLI::App* command, RenderOptions& options)
{
  command->add_flag("--shade", options.Shade, "Shade isosurfaces by a headlight (mode composite)")
    ->group("Colors and opacities");
}

void AddDetailOptions(CLI::App* command, RenderOptions& options)
{
  const char* const group = "Cost";
  command
    ->add_option("--pixel-error", options.PixelError,
      "Largest error in pixels, 0 to 1e6, of the shape and, relative to their range, of the "
      "values: "
      "the mesh is simplified as far as it allows, more where it is farther away (default: 0, not "
      "simplified)")
    ->check(CLI::Range(0., 1e6))
    ->option_text("PIXELS")
    ->group(group);
  command
    ->add_flag("--uniform", options.Uniform,
      "With --budget, simplify the mesh everywhere alike instead of less near the eye")
    ->group(group);
}

void AddCostOptions(CLI::App* command, RenderOptions& options)
{
  const char* const group = "Cost";
  command
    ->add_option("--ratio", options.Ratio,
      "Fraction of points removed before rendering, 0 to 1 (default: 0). The edge collapses are "
      "read from the hierarchy of a .gtn file (gtn pack --hierarchy), or computed first")
    ->check(CLI::Range(0., 1.))
    ->option_text("R")
    ->group(group);
  command
    ->add_option("--budget", options.TimeBudget,
      "Time budget in seconds, once the mesh is loaded; the level of detail is chosen by typical "
      "times (default: no limit)")
    ->check(CLI::NonNegativeNumber)
    ->option_text("SECONDS")
    ->group(group);
  AddDetailOptions(command, options);
  command->add_flag("--stats", options.Statistics, "Print statistics")->group(group);
  command->add_flag("--json", options.Json, "Print statistics as JSON")->group(group);
}

} // anonymous namespace

//------------------------------------------------------------------------------
const char* NameOfMode(int blendMode)
{
  return std::find_if(Modes.begin(), Modes.end(),
    [blendMode](const NamedMode& mode) { return blendMode == mode.BlendMode; })
    ->Name;
}

//------------------------------------------------------------------------------
CLI::App* AddRenderOptions(CLI::App& app, Settings& settings, RenderOptions& options)
{
  CLI::App* command = AddCommand(app, settings, "render",
    "Render a mesh as a volume to a .png or .exr file; no display is needed. Only the visible "
    "chunks of\n"
    "a .gtn file are decoded, one after the other; other meshes are read as a whole. An .exr file "
    "has\n"
    "float values with premultiplied opacity, and the depth as channel Z. Surfaces are drawn by "
    "OpenGL,\n"
    "which needs a display, opaque.",
    "  gtn render mesh.gtn mesh.png\n"
    "  gtn render --array pressure --background black --size 1920x1080 mesh.gtn mesh.png\n"
    "  gtn render --range 0,1500 --opacity 2 --elevation 90 scan.gtn scan.png\n"
    "  gtn render --mode xray --camera view.json mesh.vtu mesh.exr\n"
    "  gtn render --pixel-error 1 --camera close.json lod.gtn close.png\n"
    "  gtn render --array curvature scan.ply scan.png");
  AddForce(command, options.Overwrite);
  AddImageOptions(command, options);
  AddModeOption(command, options);
  AddMeshOptions(command, options);
  AddViewOptions(command, options.Camera, "mesh");
  command
    ->add_flag("--parallel", options.Camera.Parallel, "Parallel projection (default: perspective)")
    ->group("View");
  AddColorOptions(command, options, "mesh");
  AddShadeOption(command, options);
  AddCostOptions(command, options);
  command
    ->add_option("IN", options.Input.File,
      std::string("The mesh: ") + InputFormats + "; or a surface: " + SurfaceInputFormats)
    ->required();
  command->add_option("OUT", options.Out, "The .png or .exr file to write")->required();
  return command;
}
}
