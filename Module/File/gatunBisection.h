// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunBisection_h
#define gatunBisection_h

#include "gatunMeshAccess.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace gatun
{
/**
 * Bisects runs of tetrahedra along the longest axis of their centroids until no part has more than
 * partTets. All parts of a run end up with about the same number of tetrahedra. Equal centroids are
 * divided by the number of the tetrahedron.
 *
 * starts: the first position of each run in tets, and the end. The tetrahedra of a run ascend, and
 * those of each part do so afterwards. Returns the starts of the parts. Uses threads; the result
 * does not depend on their number.
 */
std::vector<std::size_t> Bisect(const MeshAccess& mesh, std::span<std::uint32_t> tets,
  std::span<const std::size_t> starts, std::uint32_t partTets,
  const std::function<bool(double)>& progress);
}

#endif
