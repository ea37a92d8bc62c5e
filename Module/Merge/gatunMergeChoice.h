// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunMergeChoice_h
#define gatunMergeChoice_h

#include <cstdint>
#include <limits>

namespace gatun
{
/** The best merge of a point into a neighbor; Into is None if there is none. */
struct MergeChoice
{
  static constexpr std::uint32_t None = 0xffffffffu;

  /** The cost of a merge that must not be made. */
  static constexpr double Never = std::numeric_limits<double>::infinity();

  std::uint32_t Into = None;

  /** The cheapest merges come first. */
  double Cost = 0;

  /** The square of the change of the fields and of the shape, integrated over the mesh, relative to
   * the ranges of the fields and to the size of the mesh. */
  double Change = 0;
};
}

#endif
