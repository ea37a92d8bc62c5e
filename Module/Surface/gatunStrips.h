// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunStrips_h
#define gatunStrips_h

#include "gatunExport.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/**
 * Joins triangles into strips. Each triangle, in the order of the input, is appended to a strip
 * that begins or ends at one of its edges, or else begins a strip. Neighbors that are close in the
 * input make long strips. Orientations are kept: triangle i of a strip consists of its points i, i
 * + 1, i + 2, with reversed orientation if i is odd.
 */
GATUN_EXPORT std::vector<std::vector<std::uint32_t>> MakeStrips(
  std::span<const std::array<std::uint32_t, 3>> triangles);
}

#endif
