// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnImageOptions.h"

#include "gtnFailure.h"
#include "gtnJson.h"
#include "gtnMessages.h"
#include "gtnParse.h"
#include "gtnText.h"

#include "gatunDefaultOpacity.h"
#include "gatunVersion.h"
#include "vtkGatunDefaults.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

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

// "640x480" at the x, "0,1" at the comma; the second part is empty without.
std::pair<std::string_view, std::string_view> Split(std::string_view text, char separator)
{
  const std::size_t place = text.find(separator);
  return place == text.npos ? std::pair(text, std::string_view())
                            : std::pair(text.substr(0, place), text.substr(place + 1));
}

void ParseSize(const std::string& text, ImageOptions& options)
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

void ParseTransferRange(const std::string& text, ImageOptions& options)
{
  options.Range = ParseRange("--range", text);
}

void ParseBackground(const std::string& text, ImageOptions& options)
{
  options.Background.reset();
  if (text == "transparent")
  {
    return;
  }
  if (text == "black" || text == "white")
  {
    const double part = text == "black" ? 0 : 1;
    options.Background = Color{ part, part, part };
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
    Color{ (*number >> 16) / 255., (*number >> 8 & 255) / 255., (*number & 255) / 255. };
}

// An option whose text a function takes apart.
void AddParsed(CLI::App* command, const char* name, ImageOptions& options,
  void (*parse)(const std::string&, ImageOptions&), const std::string& description,
  const char* value, const char* group)
{
  command
    ->add_option_function<std::string>(
      name, [&options, parse](const std::string& text) { parse(text, options); }, description)
    ->option_text(value)
    ->group(group);
}

/** Throws Failure if no value is a number that colors can be given to. */
void RequireRange(const ImageContent& content)
{
  const gatun::Range& range = content.Range;
  if (range.IsEmpty() || !std::isfinite(range.Min) || !std::isfinite(range.Max))
  {
    throw Failure(content.File,
      fmt::format("array '{}' has no finite range of values; give --range",
        MakePrintableLine(content.Array)));
  }
}

vtkSmartPointer<vtkVolumeProperty> MakeStructure(
  const ImageOptions& options, const ImageContent& content, vtkGatunDefaults* defaults, double unit)
{
  if (options.Range)
  {
    defaults->SetRange(options.Range->Min, options.Range->Max);
  }
  else
  {
    RequireRange(content);
  }
  defaults->SetUnitDistance(unit);
  auto property = vtkSmartPointer<vtkVolumeProperty>::New();
  const bool isMade = defaults->MakeProperty(property);
  CheckMessages(content.File, true);
  if (!isMade)
  {
    throw Failure(content.File, "there is no default transfer function");
  }
  return property;
}

vtkSmartPointer<vtkVolumeProperty> MakeRamp(
  const ImageOptions& options, const ImageContent& content)
{
  gatun::Range range = options.Range.value_or(content.Range);
  if (!options.Range)
  {
    RequireRange(content);
  }
  if (range.Min == range.Max)
  {
    // A lone value gets the middle.
    const double margin = std::max(0.5, std::abs(range.Min) / 100);
    range = { range.Min - margin, range.Max + margin };
  }
  vtkNew<vtkColorTransferFunction> colors;
  vtkGatunDefaults::MakeColors(range.Min, range.Max, colors);
  vtkNew<vtkPiecewiseFunction> opacities;
  vtkGatunDefaults::MakeRamp(range.Min, range.Max, opacities);
  auto property = vtkSmartPointer<vtkVolumeProperty>::New();
  property->SetColor(colors);
  property->SetScalarOpacity(opacities);
  return property;
}

/** Multiplies all opacities, which stay at most 1. */
void ScaleOpacity(vtkPiecewiseFunction* opacity, double factor)
{
  for (int i = 0; i < opacity->GetSize(); ++i)
  {
    std::array<double, 4> node{}; // value, opacity, midpoint, sharpness
    opacity->GetNodeValue(i, node.data());
    node[1] = std::min(node[1] * factor, 1.0);
    opacity->SetNodeValue(i, node.data());
  }
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
void AddImageOptions(CLI::App* command, ImageOptions& options)
{
  const char* const group = "Image";
  AddParsed(command, "--size", options, ParseSize,
    "Width and height in pixels, 1 to 32000 each (default: 1024x768)", "WxH", group);
  AddParsed(command, "--background", options, ParseBackground,
    "Background color: #RRGGBB, black, white or transparent (default: transparent)", "COLOR",
    group);
}

//------------------------------------------------------------------------------
void AddViewOptions(CLI::App* command, CameraOptions& camera, const std::string& what)
{
  const char* const group = "View";
  const auto add = [&](const char* name, auto& value, const CLI::Validator& check,
                     const char* description, const char* text)
  { command->add_option(name, value, description)->check(check)->option_text(text)->group(group); };
  add("--azimuth", camera.Azimuth, Between(-360, 360),
    "Rotation of the camera about the up axis in degrees, -360 to 360 (default: 30, or 0 if "
    "--camera has a position)",
    "DEG");
  add("--elevation", camera.Elevation, Between(-180, 180),
    "Elevation of the camera in degrees, -180 to 180; 90 looks down (default: 20, or 0 if --camera "
    "has a position)",
    "DEG");
  add("--roll", camera.Roll, Between(-360, 360),
    "Rotation of the camera about its viewing direction in degrees, -360 to 360 (default: 0)",
    "DEG");
  add("--zoom", camera.Zoom, Between(0.2, 1000),
    fmt::format("Magnification, 0.2 to 1000; with 1 the {} fills the image (default: 1)", what)
      .c_str(),
    "F");
  command
    ->add_option("--camera", camera.File,
      "File with a JSON object with any of position, focalPoint, viewUp (three numbers each), "
      "viewAngle (degrees) and parallelScale; missing members have their defaults. Images store "
      "their camera in this form under the key Gatun:camera")
    ->option_text("FILE")
    ->group(group);
}

//------------------------------------------------------------------------------
void AddColorOptions(CLI::App* command, ImageOptions& options, const std::string& what)
{
  const char* const group = "Colors and opacities";
  AddParsed(command, "--range", options, ParseTransferRange,
    "Range of values that colors and opacities span (default: those of the array, without "
    "outliers). Values outside of it get the colors of its ends",
    "LO,HI", group);
  command
    ->add_option("--opacity", options.Opacity,
      "Factor for all opacities, 0 to 1000; the results are clamped to 1 (default: 1)")
    ->check(Between(0, 1000))
    ->option_text("F")
    ->group(group);
  command
    ->add_option("--unit-distance", options.UnitDistance,
      fmt::format("Length of a ray over which the opacity of the transfer function accumulates, "
                  "above 0, in units of the coordinates (default: 1/100 of the diagonal of the {})",
        what))
    ->check(Positive())
    ->option_text("D")
    ->group(group);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkVolumeProperty> MakeImageProperty(const ImageOptions& options,
  const ImageContent& content, vtkGatunDefaults* defaults, const gatun::Bounds& box,
  OpacityKind kind)
{
  const double unit = gatun::GetDefaultUnitDistance(box);
  vtkSmartPointer<vtkVolumeProperty> property = kind == OpacityKind::Structure
    ? MakeStructure(options, content, defaults, unit)
    : MakeRamp(options, content);
  property->SetScalarOpacityUnitDistance(options.UnitDistance.value_or(unit));
  ScaleOpacity(property->GetScalarOpacity(), options.Opacity);
  return property;
}

//------------------------------------------------------------------------------
std::vector<std::pair<std::string, std::string>> MakeRemarks(
  const ImageContent& content, const std::string& commandLine, vtkCamera* camera)
{
  return { { "Software", std::string("Gatun ") + gatun::PackageVersion() },
    { "Gatun:command", MakePrintableLine(commandLine) },
    { "Gatun:input", MakePrintableLine(content.File) },
    { "Gatun:camera", WriteJsonLine(DescribeCamera(camera)) } };
}
}
