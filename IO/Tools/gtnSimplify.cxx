// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// gtn simplify: a mesh with fewer points.

#include "gtnCommands.h"
#include "gtnFailure.h"
#include "gtnInput.h"
#include "gtnMergeOptions.h"
#include "gtnMessages.h"
#include "gtnOptions.h"
#include "gtnOutput.h"
#include "gtnProgress.h"
#include "gtnStep.h"
#include "gtnText.h"
#include "gtnWriteMesh.h"

#include "vtkGatunReader.h"
#include "vtkGatunSimplify.h"

#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include <fmt/core.h>

#include <cstdint>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gtn
{
namespace
{
struct Options
{
  std::string In;
  std::string Out;
  bool Overwrite = false;
  StepOptions Step;
  InputOptions Input;
  std::optional<double> Ratio;
  std::optional<double> Percent;
  std::optional<std::int64_t> Points;
  std::optional<double> Error;
  MergeOptions Merges;
};

void SetTarget(vtkGatunSimplify* simplifier, const Options& options)
{
  if (options.Percent)
  {
    simplifier->SetTarget(vtkGatunSimplify::TARGET_PERCENT);
    simplifier->SetPercent(*options.Percent);
  }
  else if (options.Points)
  {
    simplifier->SetTarget(vtkGatunSimplify::TARGET_NUMBER_OF_POINTS);
    simplifier->SetNumberOfPoints(static_cast<vtkIdType>(*options.Points));
  }
  else if (options.Error)
  {
    simplifier->SetTarget(vtkGatunSimplify::TARGET_ERROR);
    simplifier->SetMaximumError(*options.Error);
  }
  else
  {
    simplifier->SetRatio(options.Ratio.value_or(0.5));
  }
}

void SetTarget(vtkGatunReader* reader, const Options& options)
{
  if (options.Percent)
  {
    reader->SetSimplificationTarget(vtkGatunReader::TARGET_PERCENT);
    reader->SetSimplificationPercent(*options.Percent);
  }
  else if (options.Points)
  {
    reader->SetSimplificationTarget(vtkGatunReader::TARGET_NUMBER_OF_POINTS);
    reader->SetSimplificationPoints(static_cast<vtkIdType>(*options.Points));
  }
  else if (options.Error)
  {
    reader->SetSimplificationTarget(vtkGatunReader::TARGET_ERROR);
    reader->SetSimplificationError(*options.Error);
  }
  else
  {
    reader->SetSimplificationRatio(options.Ratio.value_or(0.5));
  }
}

/** The reader, if the file tells how its mesh becomes simpler and nothing else is wanted. */
vtkGatunReader* FindHierarchy(const Input& input, const Options& options)
{
  auto* const reader = vtkGatunReader::SafeDownCast(input.GetSource());
  return reader && reader->GetHasHierarchy() && !options.Merges.AreGiven ? reader : nullptr;
}

void SimplifyMesh(const Options& options, const Settings& settings)
{
  CheckMeshName(options.Out);
  vtkNew<vtkGatunSimplify> simplifier;
  SetTarget(simplifier, options);
  options.Merges.Apply(simplifier.Get());

  Input input({ options.In }, options.Input);
  CheckWritable(options.Out, options.Overwrite);
  if (vtkGatunReader* const reader = FindHierarchy(input, options))
  {
    SetTarget(reader, options);
    WriteMesh(ReadStep(input, options.Step, settings), options.Out, settings);
    return;
  }
  const auto grid = ReadStep(input, options.Step, settings);
  {
    Progress progress("simplifying", settings.ShowProgress);
    simplifier->SetInputData(grid);
    progress.Watch(simplifier);
    simplifier->Update();
    CheckInterrupt();
    CheckMessages(options.In, settings.Quiet);
  }
  vtkUnstructuredGrid* const output = simplifier->GetOutput();
  WriteMesh(output, options.Out, settings);
  if (!settings.Quiet)
  {
    fmt::print("  of {} points, error {:.3g}\n", Grouped(grid->GetNumberOfPoints()),
      simplifier->GetOutputError());
  }
}
} // anonymous namespace

//------------------------------------------------------------------------------
void AddSimplify(CLI::App& app, Settings& settings)
{
  auto options = std::make_shared<Options>();
  CLI::App* command = AddCommand(app, settings, "simplify",
    "Merge points of a mesh into others, so that data and boundary change as little as possible.\n"
    "Files that gtn pack wrote with --hierarchy or --levels know how, and are simplified at once,\n"
    "unless weights or metric are given here.",
    "  gtn simplify --ratio 0.9 mesh.gtn coarse.gtn\n"
    "  gtn simplify --vertices 10000 --weight pressure=2 --weight velocity mesh.vtu coarse.vtu\n"
    "  gtn simplify --error 1e-3 mesh.gtn coarse.gtn");
  AddForce(command, options->Overwrite);
  CLI::Option* const targets[] = { command
                                     ->add_option("--ratio", options->Ratio,
                                       "Part of the points to merge away, 0 to 1 (default: 0.5)")
                                     ->check(CLI::Range(0., 1.))
                                     ->option_text("R"),
    command->add_option("--percent", options->Percent, "Points left of a hundred, 0 to 100")
      ->check(CLI::Range(0., 100.))
      ->option_text("P"),
    command->add_option("--vertices", options->Points, "Points left")
      ->check(CLI::NonNegativeNumber)
      ->option_text("N"),
    command
      ->add_option("--error", options->Error,
        "Largest error: an estimate of the root mean square error of the values, as a part of "
        "their "
        "range, and of the shape")
      ->check(CLI::NonNegativeNumber)
      ->option_text("E") };
  for (std::size_t i = 0; i < std::size(targets); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      targets[i]->excludes(targets[j]);
    }
  }
  AddMergeOptions(command, options->Merges);
  AddStep(command, options->Step);
  command->add_option("IN", options->In, std::string("A mesh: ") + InputFormats)->required();
  command->add_option("OUT", options->Out, std::string("The mesh: ") + MeshFormats)->required();
  command->callback(
    [=, &settings]
    {
      options->Input.Quiet = settings.Quiet;
      SimplifyMesh(*options, settings);
    });
}
}
