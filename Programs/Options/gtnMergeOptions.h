// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnMergeOptions_h
#define gtnMergeOptions_h

#include "gtnCommandLine.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace gtn
{
/** What counts when points are merged, as vtkGatunSimplify and vtkGatunWriter take it. */
struct MergeOptions
{
  std::vector<std::string> Weights;
  std::string Metric = "mass";
  double BoundaryWeight = 0.5;

  /** Whether any of them was given. */
  bool AreGiven = false;

  /** Throws UsageError for a weight that is none. */
  template <typename Algorithm>
  void Apply(Algorithm* algorithm) const
  {
    for (const auto& [name, weight] : this->GetWeights())
    {
      algorithm->SetArrayWeight(name.c_str(), weight);
    }
    algorithm->SetMetric(
      this->Metric == "mass" ? Algorithm::METRIC_MASS : Algorithm::METRIC_DENSITY);
    algorithm->SetBoundaryWeight(this->BoundaryWeight);
  }

private:
  std::map<std::string, double> GetWeights() const;
};

/** Adds --weight, --metric and --boundary-weight; returns them. */
std::vector<CLI::Option*> AddMergeOptions(CLI::App* command, MergeOptions& options);

/** Adds --feature-angle, which is for surfaces. */
void AddFeatureAngle(CLI::App* command, std::optional<double>& angle);
}

#endif
