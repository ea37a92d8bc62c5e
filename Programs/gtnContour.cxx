// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// gtn contour: surfaces of equal values.

#include "gtnCommands.h"
#include "gtnContourInput.h"
#include "gtnFailure.h"
#include "gtnMessages.h"
#include "gtnOptions.h"
#include "gtnOutput.h"
#include "gtnParse.h"
#include "gtnProgress.h"
#include "gtnSurfaceWriter.h"
#include "gtnText.h"

#include "gatunByteSource.h"

#include "vtkGatunContour.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gtn
{
namespace
{
constexpr std::size_t MostValues = 1000;

struct ContourOptions
{
  ContourInputOptions Input;
  std::string Out;
  bool Overwrite = false;
  std::vector<double> Values;
  int Number = 0; ///< of isovalues; 0: those given
  bool Normals = false;
  bool Strips = false;
  std::optional<bool> Double; ///< precision of the points; without: that of the input
  bool Statistics = false;
};

struct Size
{
  std::uint64_t Triangles = 0;
  std::uint64_t Points = 0;
  std::uint64_t Strips = 0;
  std::uint64_t Corners = 0; ///< of strips
};

double ParseValue(const std::string& text)
{
  const double value = Parse<double>(text).value_or(std::nan(""));
  if (!std::isfinite(value))
  {
    Refuse("--value", text, "a finite number");
  }
  return value;
}

/** Whether the options make sense together, and with the format. */
void Check(const ContourOptions& options)
{
  const SurfaceFormat format = GetSurfaceFormat(options.Out);
  const std::string extension = ExtensionOf(options.Out);
  if (options.Values.empty() && options.Number == 0)
  {
    throw UsageError("give isovalues by --value or their number by --number");
  }
  if (options.Values.size() > MostValues)
  {
    throw UsageError(fmt::format("--value: {} isovalues are too many; the maximum is {}",
      GroupDigits(options.Values.size()), GroupDigits(MostValues)));
  }
  if (options.Strips && !format.Strips)
  {
    throw UsageError(
      fmt::format("--strips: {} files hold no triangle strips; .gtn and .vtp files do", extension));
  }
  if (options.Normals && !format.Normals)
  {
    throw UsageError(fmt::format(
      "--normals: {} files hold no normals of points; .gtn, .vtp, .ply and .obj files do",
      extension));
  }
  if (options.Double.value_or(false) && !format.Double)
  {
    throw UsageError(fmt::format(
      "--precision: {} files are of single precision; .gtn, .vtp and .obj files may be of double",
      extension));
  }
}

/** Those given, or as many as wanted between the ends of the range: at these there is nothing. */
std::vector<double> MakeValues(const ContourOptions& options, const ContourInput& input)
{
  if (options.Number == 0)
  {
    return options.Values;
  }
  const gatun::Range& range = input.GetRange();
  if (!(range.Min <= range.Max) || !std::isfinite(range.Min) || !std::isfinite(range.Max))
  {
    throw Failure(options.Input.File,
      fmt::format("array '{}' has no finite range of values; give --value",
        MakePrintableLine(input.GetArray())));
  }
  std::vector<double> values;
  for (int i = 1; i <= options.Number; ++i)
  {
    const double share = i / (options.Number + 1.);
    values.push_back((1 - share) * range.Min + share * range.Max);
  }
  return values;
}

/** "0.5, 0.75"; of many the first and the last. */
std::string ListOf(const std::vector<double>& values)
{
  constexpr std::size_t few = 5;
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    if (values.size() <= few || i < few - 2 || i + 1 == values.size())
    {
      texts.push_back(DescribeNumber(values[i]));
    }
    else if (i == few - 2)
    {
      texts.emplace_back("...");
    }
  }
  return Join(texts);
}

/** Says which of the values are not among those of the mesh. Throws Failure if nothing has come of
 * any: an empty file helps nobody. */
void CheckSurface(const ContourOptions& options, const ContourInput& input,
  const std::vector<double>& values, bool isEmpty, bool quiet)
{
  const gatun::Range& range = input.GetRange();
  std::vector<double> outside;
  std::copy_if(values.begin(), values.end(), std::back_inserter(outside),
    [&range](double value) { return !(range.Min <= value && value <= range.Max); });
  if (outside.empty() && !isEmpty)
  {
    return;
  }
  const std::string has = range.Min <= range.Max
    ? fmt::format("has values from {:.7g} to {:.7g}", range.Min, range.Max)
    : "has no values";
  const Failure failure(options.Input.File,
    fmt::format("no surface at {}: array '{}' {}{}", ListOf(isEmpty ? values : outside),
      MakePrintableLine(input.GetArray()), has,
      isEmpty ? "; nothing is written, see --value, --array and gtn info" : ""));
  if (isEmpty)
  {
    throw failure;
  }
  if (!quiet)
  {
    Say(failure.what());
  }
}

Size Measure(vtkPolyData* surface)
{
  Size size;
  size.Points = static_cast<std::uint64_t>(surface->GetNumberOfPoints());
  vtkCellArray* const strips = surface->GetStrips();
  size.Strips = static_cast<std::uint64_t>(strips->GetNumberOfCells());
  size.Corners = static_cast<std::uint64_t>(strips->GetNumberOfConnectivityIds());
  size.Triangles =
    static_cast<std::uint64_t>(surface->GetNumberOfPolys()) + size.Corners - 2 * size.Strips;
  return size;
}

void PrintRow(const std::string& title, const std::string& value)
{
  fmt::print("  {:<28} {:>14}\n", title, value);
}

void PrintStatistics(const ContourOptions& options, const ContourInput& input,
  const std::vector<double>& values, const Size& size, vtkGatunContour* contour, double seconds)
{
  PrintRow("isovalues", GroupDigits(values.size()));
  PrintRow("triangles", GroupDigits(size.Triangles));
  PrintRow("points", GroupDigits(size.Points));
  if (size.Strips > 0)
  {
    PrintRow("strips", GroupDigits(size.Strips));
    const auto triangles = static_cast<double>(size.Triangles);
    PrintRow("  triangles in each, mean",
      fmt::format("{:.2f}", triangles / static_cast<double>(size.Strips)));
    PrintRow("  corners that they save",
      fmt::format("{:.1f} %", 100 * (1 - static_cast<double>(size.Corners) / (3 * triangles))));
  }
  if (input.IsFile())
  {
    vtkTable* const table = contour->GetStatistics();
    const auto get = [table](const char* name)
    { return static_cast<std::uint64_t>(table->GetValueByName(0, name).ToTypeUInt64()); };
    PrintRow("layers of the array", input.IsLayered() ? "yes" : "no");
    PrintRow("chunks passed through", GroupDigits(get("UsedChunks")));
    PrintRow("  of", GroupDigits(get("Chunks")));
    PrintRow("tetrahedra in these", GroupDigits(get("UsedTetrahedra")));
    PrintRow("read", DescribeByteSize(get("BytesRead")));
    PrintRow("  of", DescribeByteSize(gatun::OpenFile(options.Input.File)->GetSize()));
  }
  PrintRow("time", fmt::format("{:.3f} s", seconds));
}

void Contour(const ContourOptions& options, const Settings& settings)
{
  Check(options);
  CheckWritable(options.Out, options.Overwrite);
  const ContourInput input(options.Input, settings);
  const std::vector<double> values = MakeValues(options, input);
  if (settings.Verbose && input.IsFile() && !input.IsLayered())
  {
    fmt::print("{}: not organized by layers of '{}' (see gtn pack --layers); surfaces need more of "
               "the file\n",
      options.Input.File, MakePrintableLine(input.GetArray()));
  }
  vtkNew<vtkGatunContour> contour;
  input.Connect(contour);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    contour->SetValue(static_cast<int>(i), values[i]);
  }
  contour->SetComputeNormals(options.Normals);
  contour->SetOutputStrips(options.Strips);
  if (options.Double)
  {
    contour->SetOutputPointsPrecision(
      *options.Double ? vtkAlgorithm::DOUBLE_PRECISION : vtkAlgorithm::SINGLE_PRECISION);
  }
  const auto start = std::chrono::steady_clock::now();
  {
    Progress progress("extracting", settings.ShowProgress);
    progress.Watch(contour);
    input.Run(contour);
    CheckInterrupt();
    CheckMessages(options.Input.File, settings.Quiet);
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  vtkPolyData* const surface = contour->GetOutput();
  const Size size = Measure(surface);
  CheckSurface(options, input, values, size.Triangles == 0, settings.Quiet);
  {
    Progress progress("writing", settings.ShowProgress);
    WriteSurface(surface, options.Out, progress);
  }
  if (!settings.Quiet || options.Statistics)
  {
    fmt::print("{}: {} triangles, {} points, {}\n", options.Out, GroupDigits(size.Triangles),
      GroupDigits(size.Points), DescribeByteSize(std::filesystem::file_size(options.Out)));
  }
  if (options.Statistics)
  {
    PrintStatistics(options, input, values, size, contour, seconds.count());
  }
}
}

//------------------------------------------------------------------------------
void AddContour(CLI::App& app, Settings& settings)
{
  auto options = std::make_shared<ContourOptions>();
  CLI::App* command = AddCommand(app, settings, "contour",
    "Write isosurfaces of a mesh to a .gtn, .vtp, .vtk, .stl, .ply or .obj file. Only those chunks "
    "of a\n"
    ".gtn file are read that a surface passes through; other meshes are read as a whole. A .gtn,\n"
    ".vtp or .vtk file has the interpolated arrays of the mesh, other files have no arrays. An\n"
    "isovalue outside the range of the array gives a warning. If no isovalue gives a surface, "
    "nothing\n"
    "is written, and the exit code is 1.",
    "  gtn contour --value 0.5 mesh.gtn surface.vtp\n"
    "  gtn contour --value 0.5 mesh.gtn surface.gtn\n"
    "  gtn contour --array pressure --value 1e5,2e5 --normals --stats mesh.gtn surface.vtp\n"
    "  gtn contour --array velocity --component magnitude --number 5 mesh.vtu surface.stl\n"
    "  gtn contour --ratio 0.9 --value 0.5 any.gtn coarse.ply");
  AddForce(command, options->Overwrite);
  CLI::Option* const values = command
                                ->add_option_function<std::vector<std::string>>(
                                  "--value",
                                  [options](const std::vector<std::string>& texts) {
                                    std::transform(texts.begin(), texts.end(),
                                      std::back_inserter(options->Values), ParseValue);
                                  },
                                  "Isovalues, 1 to 1000 of them; may be repeated")
                                ->delimiter(',')
                                ->allow_extra_args(false)
                                ->option_text("V,...");
  command
    ->add_option("--number", options->Number,
      fmt::format("Number of isovalues, 1 to {}, evenly spaced within the range of the array; "
                  "replaces --value",
        MostValues))
    ->check(Between(1, MostValues))
    ->option_text("N")
    ->excludes(values);
  AddArray(command, options->Input.Array, "Point array to contour");
  AddStep(command, options->Input.Step);
  AddTarget(command, options->Input.Target, "0");
  AddArrays(command, options->Input.Carried,
    "Point and cell arrays to interpolate to a .gtn, .vtp or .vtk file (default: all)");
  command->add_flag(
    "--normals", options->Normals, "Compute point normals, toward lower values (not for .stl)");
  command->add_flag("--strips", options->Strips,
    "Write triangle strips instead of triangles, without cell arrays (.gtn, .vtp, .vtk)");
  command
    ->add_option_function<std::string>(
      "--precision", [options](const std::string& name) { options->Double = name == "double"; },
      "Precision of the points: single or double (default: that of the input; single for .stl and "
      ".ply)")
    ->check(CLI::IsMember({ "single", "double" }))
    ->option_text("NAME");
  command->add_flag("--stats", options->Statistics, "Print statistics");
  command->add_option("IN", options->Input.File, std::string("The mesh: ") + InputFormats)
    ->required();
  command->add_option("OUT", options->Out, std::string("The surface to write: ") + SurfaceFormats)
    ->required();
  command->callback(
    [options, &settings]
    {
      if (!GetSurfaceFormat(options->Out).Arrays)
      {
        options->Input.Carried = {};
        options->Input.Carried.AllArrays = false;
      }
      Contour(*options, settings);
    });
}
}
