// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunMorton_h
#define gatunMorton_h

#include "gatunTypes.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace gatun
{
/** Interleaves the bits of a position in a box, 21 for each axis. NaN counts as 0. */
inline std::uint64_t GetMortonCode(const Bounds& box, const std::array<double, 3>& point)
{
  constexpr unsigned bits = 21;
  constexpr double most = (1u << bits) - 1;
  std::uint64_t code = 0;
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    const double place = (point[axis] - box[axis].Min) / (box[axis].Max - box[axis].Min) * most;
    const auto cell = place > 0 ? static_cast<std::uint64_t>(std::min(place, most)) : 0;
    for (unsigned bit = 0; bit < bits; ++bit)
    {
      code |= ((cell >> bit) & 1) << (3 * bit + axis);
    }
  }
  return code;
}
}

#endif
