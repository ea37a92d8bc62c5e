// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnTarget_h
#define gtnTarget_h

// The simplification target of a mesh.

#include "gtnCommandLine.h"

#include <array>
#include <cstdint>
#include <optional>

class vtkGatunMeshReader;
class vtkGatunSimplify;

namespace gtn
{
/** At most one of them is given. */
struct TargetOptions
{
  std::optional<double> Ratio;
  std::optional<std::int64_t> Points;
  std::optional<double> RMSError;

  bool IsGiven() const { return this->Ratio || this->Points || this->RMSError; }

  /** Without any of them, half of the points are removed. */
  void Apply(vtkGatunSimplify* simplifier) const;
  void Apply(vtkGatunMeshReader* reader) const;

private:
  template <class Algorithm>
  void ApplyTo(Algorithm* algorithm) const;
};

/** Adds and returns --ratio, --points and --rms-error. The default is for the help text. */
std::array<CLI::Option*, 3> AddTarget(
  CLI::App* command, TargetOptions& options, const char* defaultRatio);
}

#endif
