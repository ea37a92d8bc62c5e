// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnMergeOptions.h"

#include "gtnFailure.h"

#include "vtkGatunSimplify.h"

#include <CLI/CLI.hpp>

#include <cstdlib>

namespace gtn
{
//------------------------------------------------------------------------------
/** Each is NAME or NAME=WEIGHT. */
std::map<std::string, double> MergeOptions::GetWeights() const
{
  std::map<std::string, double> weights;
  for (const std::string& text : this->Weights)
  {
    const auto sign = text.rfind('=');
    if (sign == std::string::npos)
    {
      weights[text] = 1;
      continue;
    }
    char* end = nullptr;
    const char* const begin = text.c_str() + sign + 1;
    const double weight = std::strtod(begin, &end);
    if (end == begin || *end != '\0' || !(weight >= 0))
    {
      throw UsageError("--weight " + text + ": the weight must be a number, 0 or more");
    }
    weights[text.substr(0, sign)] = weight;
  }
  return weights;
}

//------------------------------------------------------------------------------
void MergeOptions::Apply(vtkGatunSimplify* filter) const
{
  this->ApplyWeights(filter);
  filter->SetMetric(
    this->Metric == "mass" ? vtkGatunSimplify::METRIC_MASS : vtkGatunSimplify::METRIC_DENSITY);
  filter->SetBoundaryWeight(this->BoundaryWeight);
  filter->SetFeatureAngle(this->FeatureAngle);
}

//------------------------------------------------------------------------------
CLI::Option* AddWeights(CLI::App* command, MergeOptions& options)
{
  return command
    ->add_option("--weight", options.Weights,
      "Point array whose error is minimized, and its weight relative to other arrays, 0 or more "
      "(default: the active scalars, or else all arrays, with weight 1); may be repeated")
    ->option_text("NAME[=WEIGHT]")
    ->allow_extra_args(false)
    ->each([&options](const std::string&) { options.AreGiven = true; });
}

//------------------------------------------------------------------------------
void AddMergeOptions(CLI::App* command, MergeOptions& options)
{
  const auto given = [&options](const std::string&) { options.AreGiven = true; };
  AddWeights(command, options);
  command
    ->add_option("--metric", options.Metric,
      "Weight of each tetrahedron: its volume (mass), or the same for all (density) (default: "
      "mass)")
    ->check(CLI::IsMember({ "mass", "density" }))
    ->option_text("NAME")
    ->each(given);
  command
    ->add_option("--boundary-weight", options.BoundaryWeight,
      "Weight of the boundary's shape relative to the data, 0 to 1 (default: 0.5)")
    ->check(CLI::Range(0., 1.))
    ->option_text("W")
    ->each(given);
  command
    ->add_option("--feature-angle", options.FeatureAngle,
      "Edges of a surface between triangles whose normals differ by more degrees stay, 0 to 180 "
      "(default: 30)")
    ->check(CLI::Range(0., 180.))
    ->option_text("A")
    ->each(given);
}
}
