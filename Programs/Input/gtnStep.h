// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnStep_h
#define gtnStep_h

// Which time step of a mesh a subcommand takes.

#include "gtnCommandLine.h"

#include "vtkSmartPointer.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

class vtkDataObject;
class vtkUnstructuredGrid;

namespace gtn
{
class Input;
struct Settings;

struct StepOptions
{
  std::optional<double> Time;
  std::optional<std::size_t> Step;
};

/** --time and --step, which it returns. */
std::array<CLI::Option*, 2> AddStep(CLI::App* command, StepOptions& options);

/** Number of the step asked for, 0 of a mesh without time. Says that the first one is taken if none
 * was asked for and there are several, unless quiet. Throws Failure for the file. */
std::size_t ChooseStep(const StepOptions& options, const std::string& file,
  const std::vector<double>& times, bool quiet);

/** Reads that step, with a progress bar: a grid or a surface. Throws Failure. */
vtkSmartPointer<vtkDataObject> ReadStep(
  Input& input, const StepOptions& options, const Settings& settings);

/** The same, but throws Failure for a surface. */
vtkSmartPointer<vtkUnstructuredGrid> ReadGridStep(
  Input& input, const StepOptions& options, const Settings& settings);
}

#endif
