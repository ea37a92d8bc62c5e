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

#include <array>
#include <cmath>
#include <string_view>

namespace gtn
{
namespace
{

constexpr std::array<const char*, 4> Modes{ "composite", "area", "mip", "xray" };
static_assert(vtkGatunRayCaster::Composite == 0 && vtkGatunRayCaster::Area == 1 &&
  vtkGatunRayCaster::Maximum == 2 && vtkGatunRayCaster::XRay == 3);

// "640x480" at the x, "0,1" at the comma; the second part is empty without.
std::pair<std::string_view, std::string_view> Split(std::string_view text, char separator)
{
  const std::size_t place = text.find(separator);
  return place == text.npos ? std::pair(text, std::string_view())
                            : std::pair(text.substr(0, place), text.substr(place + 1));
}

void ParseSize(const std::string& text, RenderOptions& options)
{
  constexpr int most = 32000;
  const auto [width, height] = Split(text, 'x');
  options.Width = Parse<int>(width).value_or(0);
  options.Height = Parse<int>(height).value_or(0);
  for (const int size : { options.Width, options.Height })
  {
    if (size < 1 || size > most)
    {
      Refuse("--size", text, fmt::format("WxH with 1 to {} pixels each, as 1024x768", most));
    }
  }
}

void ParseRange(const std::string& text, RenderOptions& options)
{
  const auto [low, high] = Split(text, ',');
  const gatun::Range range{ Parse<double>(low).value_or(std::nan("")),
    Parse<double>(high).value_or(std::nan("")) };
  if (!std::isfinite(range.Min) || !std::isfinite(range.Max) || !(range.Min < range.Max))
  {
    Refuse("--range", text, "two numbers in ascending order, as 0.5,2");
  }
  options.Range = range;
}

void ParseBackground(const std::string& text, RenderOptions& options)
{
  options.Background.reset();
  if (text == "transparent")
  {
    return;
  }
  if (text == "black" || text == "white")
  {
    const double part = text == "black" ? 0 : 1;
    options.Background = Colour{ part, part, part };
    return;
  }
  const auto number = text.size() == 7 && text[0] == '#'
    ? Parse<unsigned>(std::string_view(text).substr(1), 16)
    : std::nullopt;
  if (!number)
  {
    Refuse("--background", text, "#RRGGBB (as #202830), black, white or transparent");
  }
  options.Background =
    Colour{ (*number >> 16) / 255., (*number >> 8 & 255) / 255., (*number & 255) / 255. };
}

// An option whose text a function takes apart.
void AddParsed(CLI::App* command, const char* name, RenderOptions& options,
  void (*parse)(const std::string&, RenderOptions&), const std::string& description,
  const char* value, const char* group)
{
  command
    ->add_option_function<std::string>(
      name, [&options, parse](const std::string& text) { parse(text, options); }, description)
    ->option_text(value)
    ->group(group);
}

void AddPictureOptions(CLI::App* command, RenderOptions& options)
{
  const char* const group = "Picture";
  AddParsed(command, "--size", options, ParseSize,
    "Width and height in pixels, 1 to 32000 each (default: 1024x768)", "WxH", group);
  AddParsed(command, "--background", options, ParseBackground,
    "#RRGGBB, black, white, or transparent (the default)", "COLOUR", group);
  command
    ->add_option("--turntable", options.Turntable,
      "So many pictures from all around, 1 to 9999, with -000, -001 and so on before the extension "
      "of OUT")
    ->check(Between(1, 9999))
    ->option_text("N")
    ->group(group);
  command
    ->add_option_function<std::string>(
      "--mode",
      [&options](const std::string& name)
      {
        while (name != Modes.at(static_cast<std::size_t>(options.Mode)))
        {
          ++options.Mode;
        }
      },
      "composite (the default): colour and opacity from front to back; area: the same, but one "
      "sample a tetrahedron, which is fast and coarse; mip: the largest value; xray: opacities add "
      "up, whatever lies in front")
    ->check(CLI::IsMember(std::vector<std::string>(Modes.begin(), Modes.end())))
    ->option_text("NAME")
    ->group(group);
}

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

void AddViewOptions(CLI::App* command, CameraOptions& camera)
{
  const char* const group = "View";
  const auto add = [&](const char* name, auto& value, const CLI::Validator& check,
                     const char* description, const char* text)
  { command->add_option(name, value, description)->check(check)->option_text(text)->group(group); };
  add("--azimuth", camera.Azimuth, Between(-360, 360),
    "Turn the camera around the axis that points up, -360 to 360 (default: 30; 0 if --camera tells "
    "the position)",
    "DEG");
  add("--elevation", camera.Elevation, Between(-180, 180),
    "Then raise it, -180 to 180; 90 looks down (default: 20; 0 if --camera tells the position)",
    "DEG");
  add("--roll", camera.Roll, Between(-360, 360), "Then turn it around where it looks, -360 to 360",
    "DEG [0]");
  add("--zoom", camera.Zoom, Between(0.2, 1000),
    "More than 1 shows less, and larger, 0.2 to 1000; at 1 all of the mesh is in the picture",
    "F [1]");
  command->add_flag("--parallel", camera.Parallel, "Parallel projection (default: perspective)")
    ->group(group);
  command
    ->add_option("--camera", camera.File,
      "JSON object with any of position, focalPoint, viewUp (three numbers each), viewAngle "
      "(degrees, 30) and parallelScale; what it does not tell is as without. Pictures keep theirs "
      "as Gatun:camera")
    ->option_text("FILE")
    ->group(group);
}

void AddColourOptions(CLI::App* command, RenderOptions& options)
{
  const char* const group = "Colours and opacities";
  command
    ->add_option("--tf", options.TransferFunction,
      fmt::format("Transfer function: {}, or a .json file of a colour map as ParaView exports it "
                  "(the first one in it). Presets, and files whose colours are for 0 to 1, are "
                  "stretched to the values of the array; other files are taken as they are. Values "
                  "beyond its ends are as those at the ends",
        Joined(GetPresetNames())))
    ->option_text("FILE|PRESET [dusk]")
    ->group(group);
  AddParsed(command, "--range", options, ParseRange,
    "Stretch the transfer function, whatever it is, to these values", "LO,HI", group);
  command
    ->add_option("--opacity", options.Opacity, "Multiply opacities, 0 to 1000; they stay at most 1")
    ->check(Between(0, 1000))
    ->option_text("F [1]")
    ->group(group);
  command
    ->add_option("--unit-distance", options.UnitDistance,
      "The length of ray that has the opacity of the transfer function, above 0, in units of the "
      "coordinates (default: a hundredth of the mesh's diagonal)")
    ->check(Positive())
    ->option_text("D")
    ->group(group);
  command
    ->add_flag("--shade", options.Shade,
      "Light from the camera falls on surfaces of equal values (modes composite and area)")
    ->group(group);
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
const char* NameOfMode(int mode)
{
  return Modes.at(static_cast<std::size_t>(mode));
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
  AddMeshOptions(command, options);
  AddViewOptions(command, options.Camera);
  AddColourOptions(command, options);
  AddCostOptions(command, options);
  command->add_option("IN", options.Input.File, std::string("A mesh: ") + InputFormats)->required();
  command->add_option("OUT", options.Out, "The .png or .exr file")->required();
  return command;
}
}
