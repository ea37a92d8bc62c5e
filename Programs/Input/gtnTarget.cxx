// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnTarget.h"

#include "vtkGatunMeshReader.h"
#include "vtkGatunSimplify.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

namespace gtn
{
//------------------------------------------------------------------------------
template <class Algorithm>
void TargetOptions::ApplyTo(Algorithm* algorithm) const
{
  const bool isLeast = this->Points && *this->Points == 0; // as few points as possible
  algorithm->SetSimplificationRatio(isLeast ? 1 : this->Ratio.value_or(0.5));
  algorithm->SetSimplificationNumberOfPoints(static_cast<vtkIdType>(this->Points.value_or(0)));
  algorithm->SetSimplificationRMSError(this->RMSError.value_or(0));
}

//------------------------------------------------------------------------------
void TargetOptions::Apply(vtkGatunSimplify* simplifier) const
{
  this->ApplyTo(simplifier);
}

//------------------------------------------------------------------------------
void TargetOptions::Apply(vtkGatunMeshReader* reader) const
{
  this->ApplyTo(reader);
}

//------------------------------------------------------------------------------
std::array<CLI::Option*, 3> AddTarget(
  CLI::App* command, TargetOptions& options, const char* defaultRatio)
{
  const std::array targets{ command
                              ->add_option("--ratio", options.Ratio,
                                fmt::format(
                                  "Fraction of points removed, 0 to 1 (default: {})", defaultRatio))
                              ->check(CLI::Range(0., 1.))
                              ->option_text("R"),
    command->add_option("--points", options.Points, "Number of points to keep, at most")
      ->check(CLI::NonNegativeNumber)
      ->option_text("N"),
    command
      ->add_option("--rms-error", options.RMSError,
        "Maximum root mean square error, above 0: an estimate for the values, relative to their "
        "range, and for the shape")
      ->check(CLI::PositiveNumber)
      ->option_text("E") };
  for (std::size_t i = 0; i < targets.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      targets[i]->excludes(targets[j]);
    }
  }
  return targets;
}
}
