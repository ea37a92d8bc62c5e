// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnStep.h"

#include "gtnFailure.h"
#include "gtnInput.h"
#include "gtnMessages.h"
#include "gtnProgress.h"
#include "gtnSettings.h"
#include "gtnText.h"

#include "vtkDataObject.h"
#include "vtkUnstructuredGrid.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <algorithm>

namespace gtn
{
//------------------------------------------------------------------------------
std::array<CLI::Option*, 2> AddStep(CLI::App* command, StepOptions& options)
{
  CLI::Option* const time =
    command->add_option("--time", options.Time, "Time of the step; must match exactly")
      ->option_text("T");
  CLI::Option* const step =
    command->add_option("--step", options.Step, "Index of the step, from 0 (default: 0)")
      ->option_text("N")
      ->excludes(time);
  return { time, step };
}

//------------------------------------------------------------------------------
std::size_t ChooseStep(
  const StepOptions& options, const std::string& file, const std::vector<double>& times, bool quiet)
{
  if (times.empty())
  {
    if (options.Time || options.Step.value_or(0) > 0)
    {
      throw Failure(file, "has no time steps");
    }
    return 0;
  }
  if (options.Time)
  {
    const auto found = std::find(times.begin(), times.end(), *options.Time);
    if (found == times.end())
    {
      throw Failure(file,
        fmt::format("has no step at time {}; there are {} from {} to {}, see gtn info -v",
          DescribeNumber(*options.Time), times.size(), DescribeNumber(times.front()),
          DescribeNumber(times.back())));
    }
    return static_cast<std::size_t>(found - times.begin());
  }
  const std::size_t step = options.Step.value_or(0);
  if (step >= times.size())
  {
    throw Failure(
      file, fmt::format("has no step {}; they are numbered 0 to {}", step, times.size() - 1));
  }
  if (!options.Step && times.size() > 1 && !quiet)
  {
    Say(fmt::format("{}: has {} time steps; using the first one", file, times.size()));
  }
  return step;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> ReadStep(
  Input& input, const StepOptions& options, const Settings& settings)
{
  const std::size_t step = ChooseStep(options, input.GetName(), input.GetTimes(), settings.Quiet);
  Progress progress("reading", settings.ShowProgress);
  return input.Read(step, progress);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkUnstructuredGrid> ReadGridStep(
  Input& input, const StepOptions& options, const Settings& settings)
{
  const std::size_t step = ChooseStep(options, input.GetName(), input.GetTimes(), settings.Quiet);
  Progress progress("reading", settings.ShowProgress);
  return input.ReadGrid(step, progress);
}
}
