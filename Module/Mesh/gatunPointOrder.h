// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPointOrder_h
#define gatunPointOrder_h

#include "gatunMeshAccess.h"

#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** The points along a curve on which near points are near, but for those very near to each other.
 */
std::vector<std::uint32_t> SortAlongCurve(
  const MeshAccess& mesh, std::span<const std::uint32_t> points);
}

#endif
