// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnRenderOptions.h"

#include "gtnInput.h"
#include "gtnOptions.h"
#include "gtnParse.h"
#include "gtnText.h"
#include "gtnTransfer.h"

#include "vtkGatunRayCaster.h"

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

constexpr std::array<NamedMode, 4> Modes{ { { "composite", vtkGatunRayCaster::COMPOSITE_BLEND },
  { "area", vtkGatunRayCaster::AREA_BLEND }, { "mip", vtkGatunRayCaster::MAXIMUM_INTENSITY_BLEND },
  { "xray", vtkGatunRayCaster::XRAY_BLEND } } };

void AddMeshOptions(CLI::App* command, RenderOptions& options)
{
  const char* const group = "What is drawn";
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
      "composite (the default): colour and opacity from front to back; area: the same, but one "
      "sample a tetrahedron, which is fast and coarse; mip: the largest value; xray: opacities add "
      "up, whatever lies in front")
    ->check(CLI::IsMember({ "composite", "area", "mip", "xray" }))
    ->option_text("NAME")
    ->group("Picture");
}

void AddShadeOption(CLI::App* command, RenderOptions& options)
{
  command
    ->add_flag("--shade", options.Shade,
      "Light from the camera falls on surfaces of equal values (modes composite and area)")
    ->group("Colours and opacities");
}

void AddCostOptions(CLI::App* command, RenderOptions& options)
{
  const char* const group = "Cost";
  command
    ->add_option("--sample-distance", options.SampleDistance,
      "Of samples along a ray, above 0, in units of the coordinates (default: as wide as a pixel "
      "in the middle of the mesh)")
    ->check(Positive())
    ->option_text("D")
    ->group(group);
  command
    ->add_option(
      "--memory", options.Memory, "MiB of decoded mesh to keep for the next picture, 0 to 1048576")
    ->check(CLI::Range(0, 1 << 20))
    ->option_text("MIB [512]")
    ->group(group);
  command
    ->add_option("--ratio", options.Ratio,
      "Part of the points to merge away, 0 to 1; of a .gtn file that has a hierarchy (gtn pack "
      "--hierarchy), or found out first")
    ->check(CLI::Range(0., 1.))
    ->option_text("R [0]");
  command
    ->add_option("--budget", options.TimeBudget,
      "Seconds that a picture may take once the mesh is there: as many points are merged away as "
      "that needs, by what was measured on the pictures before")
    ->check(CLI::NonNegativeNumber)
    ->option_text("SECONDS");
  command->add_flag("--stats", options.Statistics, "Print what it took; of a turntable, medians")
    ->group(group);
  command->add_flag("--json", options.Json, "Print the same of each picture, as JSON")
    ->group(group);
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
    "Draw a mesh as a volume, into a .png or .exr file; no display is needed. A .gtn file is "
    "drawn\n"
    "as it is: only those chunks that are seen are decoded, one by one, and the mesh is never in\n"
    "memory as a whole; other meshes are. The .exr file has floats, opacity multiplied in, and "
    "the\n"
    "distance of what is seen as channel Z.",
    "  gtn render mesh.gtn mesh.png\n"
    "  gtn render --array pressure --tf heat --background black --size 1920x1080 mesh.gtn "
    "mesh.png\n"
    "  gtn render --tf bone --range 0,1500 --opacity 2 --elevation 90 scan.gtn scan.png\n"
    "  gtn render --turntable 36 --stats mesh.gtn around.png      around-000.png to "
    "around-035.png\n"
    "  gtn render --mode xray --tf xray --camera view.json mesh.vtu mesh.exr");
  AddForce(command, options.Overwrite);
  AddPictureOptions(command, options);
  AddModeOption(command, options);
  AddMeshOptions(command, options);
  AddViewOptions(command, options.Camera, "mesh");
  command
    ->add_flag("--parallel", options.Camera.Parallel, "Parallel projection (default: perspective)")
    ->group("View");
  AddColourOptions(command, options, "mesh");
  AddShadeOption(command, options);
  AddCostOptions(command, options);
  command->add_option("IN", options.Input.File, std::string("A mesh: ") + InputFormats)->required();
  command->add_option("OUT", options.Out, "The .png or .exr file")->required();
  return command;
}
}
