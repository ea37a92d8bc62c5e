// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnTarget_h
#define gtnTarget_h

// How far to simplify a mesh.

#include <CLI/CLI.hpp>

#include <array>
#include <cstdint>
#include <optional>

class vtkGatunReader;
class vtkGatunSimplify;

namespace gtn
{
/** At most one of them. */
struct TargetOptions
{
  std::optional<double> Ratio;
  std::optional<double> Percent;
  std::optional<std::int64_t> Points;
  std::optional<double> Error;

  bool IsGiven() const { return this->Ratio || this->Percent || this->Points || this->Error; }

  /** Without any of them, half of the points go. */
  void Apply(vtkGatunSimplify* simplifier) const;
  void Apply(vtkGatunReader* reader) const;
};

/** --ratio, --percent, --vertices and --error, which it returns. Without: what happens then, for
 * the help. */
std::array<CLI::Option*, 4> AddTarget(
  CLI::App* command, TargetOptions& options, const char* without);
}

#endif
