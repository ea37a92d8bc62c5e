// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnPictureOptions.h"

#include "gtnFailure.h"
#include "gtnJson.h"
#include "gtnParse.h"
#include "gtnText.h"

#include "gatunVersion.h"

#include "vtkCamera.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string_view>

namespace gtn
{
namespace
{

// "640x480" at the x, "0,1" at the comma; the second part is empty without.
std::pair<std::string_view, std::string_view> Split(std::string_view text, char separator)
{
  const std::size_t place = text.find(separator);
  return place == text.npos ? std::pair(text, std::string_view())
                            : std::pair(text.substr(0, place), text.substr(place + 1));
}

void ParseSize(const std::string& text, PictureOptions& options)
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

void ParseTransferRange(const std::string& text, PictureOptions& options)
{
  options.Range = ParseRange("--range", text);
}

void ParseBackground(const std::string& text, PictureOptions& options)
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
void AddParsed(CLI::App* command, const char* name, PictureOptions& options,
  void (*parse)(const std::string&, PictureOptions&), const std::string& description,
  const char* value, const char* group)
{
  command
    ->add_option_function<std::string>(
      name, [&options, parse](const std::string& text) { parse(text, options); }, description)
    ->option_text(value)
    ->group(group);
}

// On one line.
std::string DescribeCamera(vtkCamera* camera)
{
  Json json;
  AddCamera(json, {}, camera);
  std::string line;
  for (const char c : json.GetText())
  {
    if (c == '\n' || (c == ' ' && (line.empty() || line.back() == ' ')))
    {
      continue;
    }
    line += c;
  }
  return line;
}

} // anonymous namespace

//------------------------------------------------------------------------------
gatun::Range ParseRange(const char* option, const std::string& text)
{
  const auto [low, high] = Split(text, ',');
  const gatun::Range range{ Parse<double>(low).value_or(std::nan("")),
    Parse<double>(high).value_or(std::nan("")) };
  if (!std::isfinite(range.Min) || !std::isfinite(range.Max) || !(range.Min < range.Max))
  {
    Refuse(option, text, "two numbers in ascending order, as 0.5,2");
  }
  return range;
}

//------------------------------------------------------------------------------
void AddPictureOptions(CLI::App* command, PictureOptions& options)
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
}

//------------------------------------------------------------------------------
void AddViewOptions(CLI::App* command, CameraOptions& camera, const std::string& what)
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
    fmt::format(
      "More than 1 shows less, and larger, 0.2 to 1000; at 1 all of the {} is in the picture", what)
      .c_str(),
    "F [1]");
  command
    ->add_option("--camera", camera.File,
      "JSON object with any of position, focalPoint, viewUp (three numbers each), viewAngle "
      "(degrees, 30) and parallelScale; what it does not tell is as without. Pictures keep theirs "
      "as Gatun:camera")
    ->option_text("FILE")
    ->group(group);
}

//------------------------------------------------------------------------------
void AddColourOptions(CLI::App* command, PictureOptions& options, const std::string& what)
{
  const char* const group = "Colours and opacities";
  command
    ->add_option("--tf", options.TransferFunction,
      fmt::format("Transfer function: {}, or a .json file of a colour map as ParaView exports it "
                  "(the first one in it). Presets, and files whose colours are for 0 to 1, are "
                  "stretched to the values of the array; other files are taken as they are. Values "
                  "beyond its ends are as those at the ends",
        Joined(GetPresetNames())))
    ->option_text(fmt::format("FILE|PRESET [{}]", options.TransferFunction))
    ->group(group);
  AddParsed(command, "--range", options, ParseTransferRange,
    "Stretch the transfer function, whatever it is, to these values", "LO,HI", group);
  command
    ->add_option("--opacity", options.Opacity, "Multiply opacities, 0 to 1000; they stay at most 1")
    ->check(Between(0, 1000))
    ->option_text("F [1]")
    ->group(group);
  command
    ->add_option("--unit-distance", options.UnitDistance,
      fmt::format("The length of ray that has the opacity of the transfer function, above 0, in "
                  "units of the coordinates (default: a hundredth of the {}'s diagonal)",
        what))
    ->check(Positive())
    ->option_text("D")
    ->group(group);
}

//------------------------------------------------------------------------------
std::vector<std::string> NamePictures(const PictureOptions& options)
{
  const std::string& out = options.Out;
  const int turntable = options.Turntable;
  if (turntable == 0)
  {
    return { out };
  }
  const std::filesystem::path path(out);
  const std::size_t digits = std::max<std::size_t>(3, std::to_string(turntable - 1).size());
  std::vector<std::string> names;
  for (int i = 0; i < turntable; ++i)
  {
    names.push_back((path.parent_path() /
      fmt::format("{}-{:0{}}{}", path.stem().string(), i, digits, path.extension().string()))
                      .string());
  }
  return names;
}

//------------------------------------------------------------------------------
Transfer MakeTransfer(const PictureOptions& options, const PictureContent& content)
{
  Transfer transfer = FindTransfer(options.TransferFunction);
  if (options.Range)
  {
    Stretch(transfer, *options.Range);
  }
  else if (IsNormalized(transfer))
  {
    gatun::Range range = content.Range;
    if (!(range.Min <= range.Max) || !std::isfinite(range.Min) || !std::isfinite(range.Max))
    {
      throw Failure(content.File,
        fmt::format(
          "array '{}' has no finite range of values; give --range", Printable(content.Array)));
    }
    if (range.Min == range.Max)
    {
      // A lone value gets the middle.
      const double margin = std::max(0.5, std::abs(range.Min) / 100);
      range = { range.Min - margin, range.Max + margin };
    }
    Stretch(transfer, range);
  }
  ScaleOpacity(transfer, options.Opacity);
  return transfer;
}

//------------------------------------------------------------------------------
double DiagonalOf(const gatun::Bounds& bounds)
{
  double diagonal = 0;
  for (const gatun::Range& range : bounds)
  {
    diagonal = std::hypot(diagonal, range.Max - range.Min);
  }
  return diagonal > 0 && std::isfinite(diagonal) ? diagonal : 1;
}

//------------------------------------------------------------------------------
std::vector<std::pair<std::string, std::string>> MakeRemarks(
  const PictureContent& content, const std::string& commandLine, vtkCamera* camera)
{
  return { { "Software", std::string("Gatun ") + gatun::PackageVersion() },
    { "Gatun:command", Printable(commandLine) }, { "Gatun:input", Printable(content.File) },
    { "Gatun:camera", DescribeCamera(camera) } };
}
}
