// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunStrips_h
#define gatunStrips_h

#include "vtkGatunCoreModule.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/**
 * Joins triangles to strips, each triangle to a strip that begins or ends at one of its edges, in
 * the order in which they come: neighbours that come soon after each other, as from a walk from
 * tetrahedron to tetrahedron, make long strips. Fronts stay where they are: triangle i of a strip
 * is its points i, i + 1, i + 2, turned over if i is odd. A triangle that fits nowhere begins a
 * strip.
 */
VTKGATUNCORE_EXPORT std::vector<std::vector<std::uint32_t>> MakeStrips(
  std::span<const std::array<std::uint32_t, 3>> triangles);
}

#endif
