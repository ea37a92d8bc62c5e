// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnStepChooser_h
#define gtnStepChooser_h

// Some of the time steps of a mesh: --steps.

#include "gtnCommandLine.h"
#include "gtnInputOptions.h"

#include "vtkPassInputTypeAlgorithm.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace gtn
{
/** --steps. */
CLI::Option* AddSteps(CLI::App* command, std::optional<StepRange>& steps);

/** The numbers of the steps that a range takes of so many. Throws Failure for the file. */
std::vector<std::size_t> ChooseSteps(
  const StepRange& range, std::size_t steps, const std::string& file);

/** Passes data on, and tells only some of the times of its input. */
class StepChooser : public vtkPassInputTypeAlgorithm
{
public:
  static StepChooser* New();
  vtkTypeMacro(StepChooser, vtkPassInputTypeAlgorithm);

  void SetTimes(const std::vector<double>& times);

protected:
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  std::vector<double> Times;
};
}

#endif
