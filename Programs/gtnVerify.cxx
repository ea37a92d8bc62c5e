// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// gtn verify: checks a file, and compares it with another one.

#include "gtnAlign.h"
#include "gtnBounds.h"
#include "gtnCommands.h"
#include "gtnCompare.h"
#include "gtnFailure.h"
#include "gtnFileSteps.h"
#include "gtnInput.h"
#include "gtnNames.h"
#include "gtnOptions.h"
#include "gtnProgress.h"
#include "gtnReadable.h"
#include "gtnStepChooser.h"
#include "gtnText.h"

#include "gatunFileReader.h"
#include "gatunSurfaceGrid.h"
#include "gatunVerifyFile.h"

#include "vtkDataObject.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace gtn
{
namespace
{

struct VerifyOptions
{
  std::string File;
  std::vector<std::string> Originals;
  InputOptions Input;
  bool FillMissing = false;
};

// Distinct names for messages.
std::pair<std::string, std::string> ShortNames(const std::string& first, const std::string& second)
{
  std::pair<std::string, std::string> names(FileOf(first), FileOf(second));
  return names.first == names.second ? std::pair(first, second) : names;
}

vtkSmartPointer<vtkUnstructuredGrid> GridOf(vtkDataObject* data)
{
  auto* const surface = vtkPolyData::SafeDownCast(data);
  return surface ? gatun::MakeSurfaceGrid(surface)
                 : vtkSmartPointer<vtkUnstructuredGrid>(vtkUnstructuredGrid::SafeDownCast(data));
}

// Compares two grids or surfaces. Returns a description of the first difference.
std::string CompareData(BoundedComparison& comparison, vtkDataObject* a, vtkDataObject* b,
  const FileSteps::Place& place, const SeriesPlace& series, bool& rolesDiffer)
{
  if (a->GetDataObjectType() != b->GetDataObjectType())
  {
    return fmt::format("it is a {}, not a {}", a->GetClassName(), b->GetClassName());
  }
  const auto first = GridOf(a);
  const auto second = AlignArrays(GridOf(b), first, series, rolesDiffer);
  return comparison.Compare(GridView(first), GridView(second), *place.Mesh, place.Step);
}

void CompareWithOriginals(const VerifyOptions& options, const Settings& settings, FileSteps& file)
{
  Input original(options.Originals, options.Input);
  InputOptions optionsOfPacked = options.Input;
  optionsOfPacked.Steps.reset();
  Input packed({ options.File }, optionsOfPacked);
  const auto [nameOfPacked, nameOfOriginal] = ShortNames(options.File, original.GetName());

  const std::vector<double>& times = original.GetTimes();
  // A lone step may have lost or gained its time: the values are what counts.
  const std::size_t steps = std::max<std::size_t>(times.size(), 1);
  const std::size_t packedSteps = std::max<std::size_t>(packed.GetTimes().size(), 1);
  if (packedSteps != steps)
  {
    throw Failure(options.File,
      fmt::format("differs: {} time steps, not {} as {}", packedSteps, steps, nameOfOriginal));
  }
  Comparison comparison(nameOfPacked, nameOfOriginal, file.GetFile().GetKeptOrder());
  BoundedComparison bounded(comparison);
  bool rolesDiffer = false;
  for (std::size_t step = 0; step < steps; ++step)
  {
    if (steps > 1 && times[step] != packed.GetTimes()[step])
    {
      throw Failure(options.File,
        fmt::format("differs: step {} is at time {}, not {} as in {}", step,
          DescribeNumber(packed.GetTimes()[step]), DescribeNumber(times[step]), nameOfOriginal));
    }
    Progress progress(steps > 1 ? fmt::format("comparing step {} of {}", step + 1, steps)
                                : std::string("comparing"),
      settings.ShowProgress);
    vtkDataObject* const a = packed.Read(step, progress);
    vtkDataObject* const b = original.Read(step, progress);
    const std::string difference = CompareData(
      bounded, a, b, file.Find(step), { steps > 1, step == 0, options.FillMissing }, rolesDiffer);
    CheckInterrupt();
    if (!difference.empty())
    {
      throw Failure(options.File,
        steps > 1 ? fmt::format("differs at step {} (time {}): {}", step,
                      DescribeNumber(times[step]), difference)
                  : "differs: " + difference);
    }
  }
  if (!settings.Quiet)
  {
    const std::size_t alike = comparison.GetIndistinguishablePoints();
    const std::string errors = bounded.HasBounds()
      ? fmt::format(" but for bounded errors, of which the largest is {:.6f} of its bound",
          bounded.GetWorst())
      : "";
    fmt::print("{}: identical to {}{}{}{}{}{}\n", options.File, original.GetName(),
      options.Originals.size() > 1 ? fmt::format(" and {} more", options.Originals.size() - 1) : "",
      steps > 1 ? fmt::format(", {} time steps", steps) : "",
      alike > 0 ? fmt::format(", up to {} indistinguishable points", GroupDigits(alike)) : "",
      errors,
      rolesDiffer ? " but for the active arrays, which are those of the first step at all steps"
                  : "");
  }
}

// "12 chunks, 3 arrays, 2 time steps, the order of points, cells".
std::string ListChecked(const gatun::FileReader& file)
{
  const auto count = [](std::size_t number, const std::string& what)
  { return fmt::format("{} {}{}", GroupDigits(number), what, number == 1 ? "" : "s"); };
  std::size_t chunks = file.GetChunks().size();
  for (std::size_t mesh = 1; mesh < file.GetNumberOfMeshes(); ++mesh)
  {
    chunks += file.OpenMesh(mesh)->GetChunks().size();
  }
  std::vector<std::string> parts{ count(chunks, "chunk"), count(file.GetArrays().size(), "array") };
  if (file.GetNumberOfMeshes() > 1)
  {
    parts.push_back(fmt::format("{} meshes", GroupDigits(file.GetNumberOfMeshes())));
  }
  if (file.HasTime())
  {
    parts.push_back(count(file.GetSeriesTimes().size(), "time step"));
  }
  if (file.GetKeptOrder() != gatun::KeepNone)
  {
    parts.push_back("the order of " + NameOfKeptOrder(file.GetKeptOrder()));
  }
  return Join(parts);
}

void Verify(const VerifyOptions& options, const Settings& settings)
{
  CheckReadable(options.File);
  FileSteps file(options.File);
  {
    Progress progress("checking", settings.ShowProgress);
    if (!VerifyFile(file.GetFile(), std::ref(progress)))
    {
      throw Interrupted();
    }
  }
  if (!options.Originals.empty())
  {
    CompareWithOriginals(options, settings, file);
  }
  else if (!settings.Quiet)
  {
    fmt::print("{}: intact: all checksums are right, and everything decodes ({})\n", options.File,
      ListChecked(file.GetFile()));
  }
}

} // anonymous namespace

//------------------------------------------------------------------------------
void AddVerify(CLI::App& app, Settings& settings)
{
  auto options = std::make_shared<VerifyOptions>();
  CLI::App* command = AddCommand(app, settings, "verify",
    "Check a .gtn file. All checksums are checked, and everything is decoded. With ORIGINAL, each\n"
    "time step is also compared with it, bit by bit, or by their bounds where values have\n"
    "errors. Points and cells are compared in order where the file keeps their order, and as\n"
    "sets elsewhere. As sets, points that coincide in their coordinates and all of their values\n"
    "are indistinguishable: a cell may use one in place of another. The number of such points is\n"
    "reported. The first difference is reported, and the exit code is 1.",
    "  gtn verify mesh.gtn\n"
    "  gtn verify mesh.gtn mesh.vtu\n"
    "  gtn verify run.gtn run_0.vtu run_1.vtu run_2.vtu");
  AddArrays(command, options->Input, "Compare only these point and cell arrays");
  AddSets(command, options->Input);
  AddSteps(command, options->Input.Steps)
    ->description("Compare with these time steps of ORIGINAL, as it was packed with --steps");
  command->add_flag("--fill-missing", options->FillMissing,
    "Fill in the arrays that steps of ORIGINAL lack, which was packed with --fill-missing");
  command->add_flag("--split-cells", options->Input.Split,
    "Split the cells of ORIGINAL, which was packed with --split-cells");
  command->add_flag("--triangles", options->Input.Triangles,
    "Divide the polygons and strips of ORIGINAL, which was packed with --triangles");
  command->add_option("IN", options->File, "The .gtn file")->required();
  command->add_option("ORIGINAL", options->Originals,
    "The source of the .gtn file: one file, or one for each time step");
  command->callback(
    [=, &settings]
    {
      options->Input.Quiet = settings.Quiet;
      Verify(*options, settings);
    });
}
}
