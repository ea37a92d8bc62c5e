// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunProgression_h
#define gatunProgression_h

#include "gatunDomain.h"
#include "gatunTypes.h"

#include <cstddef>
#include <optional>
#include <span>

namespace gatun
{
/** Floating-point values at even distances: Origin + i * Step, computed in binary64 and rounded to
 * the type of the values. */
struct Progression
{
  double Origin = 0;
  double Step = 0;
  std::size_t Count = 0;

  /** Whether the step is positive and no value is beyond the range of a type. */
  bool IsWithin(ScalarType type) const;

  /** The keys of the values, which must be within the type. They
   * ascend only if the step is large enough. */
  Palette MakeKeys(ScalarType type) const;
};

/** The progression from the first to the last of some keys, which ascend, that has all of them.
 * None if there is none of at most `most` values, or if no two keys are neighbors in it. */
std::optional<Progression> FitProgression(
  ScalarType type, std::span<const Key> keys, std::size_t most);
}

#endif
