// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnTarget.h"

#include "vtkGatunReader.h"
#include "vtkGatunSimplify.h"

#include <fmt/core.h>

namespace gtn
{
//------------------------------------------------------------------------------
void TargetOptions::Apply(vtkGatunSimplify* simplifier) const
{
  if (this->Points)
  {
    simplifier->SetTarget(vtkGatunSimplify::TARGET_NUMBER_OF_POINTS);
    simplifier->SetNumberOfPoints(static_cast<vtkIdType>(*this->Points));
  }
  else if (this->Error)
  {
    simplifier->SetTarget(vtkGatunSimplify::TARGET_ERROR);
    simplifier->SetMaximumError(*this->Error);
  }
  else
  {
    simplifier->SetRatio(this->Ratio.value_or(0.5));
  }
}

//------------------------------------------------------------------------------
void TargetOptions::Apply(vtkGatunReader* reader) const
{
  if (this->Points)
  {
    reader->SetSimplificationTarget(vtkGatunReader::TARGET_NUMBER_OF_POINTS);
    reader->SetSimplificationPoints(static_cast<vtkIdType>(*this->Points));
  }
  else if (this->Error)
  {
    reader->SetSimplificationTarget(vtkGatunReader::TARGET_ERROR);
    reader->SetSimplificationError(*this->Error);
  }
  else
  {
    reader->SetSimplificationRatio(this->Ratio.value_or(0.5));
  }
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
      ->add_option("--rms-error", options.Error,
        "Maximum root mean square error, 0 or more: an estimate for the values, relative to their "
        "range, and for the shape")
      ->check(CLI::NonNegativeNumber)
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
