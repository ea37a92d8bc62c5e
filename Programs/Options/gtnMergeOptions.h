// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnMergeOptions_h
#define gtnMergeOptions_h

#include "gtnCommandLine.h"

#include <map>
#include <string>
#include <vector>

class vtkGatunSimplify;

namespace gtn
{
/** What counts when points are merged, as vtkGatunSimplify takes it, and vtkGatunWriter the
 * weights. */
struct MergeOptions
{
  std::vector<std::string> Weights;
  std::string Metric = "mass";
  double BoundaryWeight = 0.5;
  double FeatureAngle = 30;

  /** Whether any of them was given. */
  bool AreGiven = false;

  /** Throws UsageError for a weight that is none. */
  template <typename Algorithm>
  void ApplyWeights(Algorithm* algorithm) const
  {
    for (const auto& [name, weight] : this->GetWeights())
    {
      algorithm->SetArrayWeight(name.c_str(), weight);
    }
  }

  void Apply(vtkGatunSimplify* filter) const;

private:
  std::map<std::string, double> GetWeights() const;
};

/** Adds --weight. */
CLI::Option* AddWeights(CLI::App* command, MergeOptions& options);

/** Adds --weight, --metric, --boundary-weight and --feature-angle. */
void AddMergeOptions(CLI::App* command, MergeOptions& options);
}

#endif
