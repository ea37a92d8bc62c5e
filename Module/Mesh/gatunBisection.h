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
 * Bisects runs of cells along the longest axis of the means of their points until no part of run i
 * has more than partCells[i] cells. All parts of a run end up with about the same number of cells.
 * Equal means are divided by the number of the cell.
 *
 * starts: the first position of each run in cells, and the end. The cells of a run ascend, and
 * those of each part do so afterwards. Returns the starts of the parts. Uses threads; the result
 * does not depend on their number.
 */
std::vector<std::size_t> Bisect(const MeshAccess& mesh, std::span<std::uint32_t> cells,
  std::span<const std::size_t> starts, std::span<const std::uint32_t> partCells,
  const std::function<bool(double)>& progress);
}

#endif
