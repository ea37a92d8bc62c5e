// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// gtn simplify: a mesh with fewer points.

#include "gtnCommands.h"
#include "gtnFailure.h"
#include "gtnInput.h"
#include "gtnMessages.h"
#include "gtnOptions.h"
#include "gtnOutput.h"
#include "gtnProgress.h"
#include "gtnStep.h"
#include "gtnText.h"
#include "gtnWriteMesh.h"

#include "vtkGatunSimplify.h"

#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include <fmt/core.h>

#include <cstdint>
#include <cstdlib>
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
  std::vector<std::string> Weights;
  std::string Metric = "mass";
  double BoundaryWeight = 0.5;
};

/** NAME or NAME=WEIGHT. */
void SetWeight(vtkGatunSimplify* simplifier, const std::string& text)
{
  const auto sign = text.rfind('=');
  if (sign == std::string::npos)
  {
    simplifier->SetArrayWeight(text.c_str(), 1);
    return;
  }
  char* end = nullptr;
  const double weight = std::strtod(text.c_str() + sign + 1, &end);
  if (end == text.c_str() + sign + 1 || *end != '\0' || !(weight >= 0))
  {
    throw UsageError("--array " + text + ": the weight must be a number, 0 or more");
  }
  simplifier->SetArrayWeight(text.substr(0, sign).c_str(), weight);
}

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

void SimplifyMesh(const Options& options, const Settings& settings)
{
  CheckMeshName(options.Out);
  vtkNew<vtkGatunSimplify> simplifier;
  SetTarget(simplifier, options);
  for (const std::string& weight : options.Weights)
  {
    SetWeight(simplifier, weight);
  }
  simplifier->SetMetric(
    options.Metric == "mass" ? vtkGatunSimplify::METRIC_MASS : vtkGatunSimplify::METRIC_DENSITY);
  simplifier->SetBoundaryWeight(options.BoundaryWeight);

  Input input({ options.In }, options.Input);
  CheckWritable(options.Out, options.Overwrite);
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
    "Merge points of a mesh into others, so that data and boundary change as little as possible.",
    "  gtn simplify --ratio 0.9 mesh.gtn coarse.gtn\n"
    "  gtn simplify --vertices 10000 --array pressure=2 --array velocity mesh.vtu coarse.vtu\n"
    "  gtn simplify --error 1e-7 mesh.gtn coarse.gtn");
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
        "Largest change that one merge may cause, as a part of what the whole mesh has: of the "
        "values' range times its volume, or of its volume")
      ->check(CLI::NonNegativeNumber)
      ->option_text("E") };
  for (std::size_t i = 0; i < std::size(targets); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      targets[i]->excludes(targets[j]);
    }
  }
  command
    ->add_option("--array", options->Weights,
      "A point array that counts, and how much relative to others (default: the active scalars, or "
      "else all alike); may be given several times")
    ->option_text("NAME[=WEIGHT]");
  command
    ->add_option("--metric", options->Metric,
      "What of the data is to stay: mass, values times volumes, or density, values (default: mass)")
    ->check(CLI::IsMember({ "mass", "density" }))
    ->option_text("NAME");
  command
    ->add_option("--boundary-weight", options->BoundaryWeight,
      "How much the shape of the boundary counts there, 0 to 1; the rest is the data")
    ->check(CLI::Range(0., 1.))
    ->option_text("W [0.5]");
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
