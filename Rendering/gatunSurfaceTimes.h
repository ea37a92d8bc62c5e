// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunSurfaceTimes_h
#define gatunSurfaceTimes_h

#include "gatunFrameBudget.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <span>

namespace gatun
{
/**
 * Chooses the level of detail of a surface for a time budget, from the times of the last images.
 * The time of a level is the number of its visible cells times the recent time a cell, of this
 * level or else of the nearest one that was drawn. The present level stays while its time is
 * between the aim and the budget.
 */
class SurfaceTimes
{
public:
  /** The number of a level that is a cut for the view. */
  static constexpr std::size_t Cut = std::numeric_limits<std::size_t>::max();

  /** An image of a level took some seconds. */
  void Learn(std::size_t level, std::uint64_t cells, double seconds);

  /** The finest level that fits, or the last one. Cells: the visible ones of all levels, from fine
   * to coarse. Present: that of the last image; beyond the end if there was none. */
  std::size_t Choose(
    double budget, std::span<const std::uint64_t> cells, std::size_t present) const;

  /** The expected seconds for an image of a level. */
  double Predict(std::size_t level, std::uint64_t cells) const;

  /** The number of cells of a level for which the expected seconds are the aim. */
  std::uint64_t CountCells(std::size_t level, double budget) const;

  /** The same for the transfer of cells to the graphics. */
  void LearnTransfer(std::uint64_t cells, double seconds);
  double PredictTransfer(std::uint64_t cells) const;

private:
  double PredictWork(std::size_t level) const;

  std::map<std::size_t, RecentCost> PerCell; // for each level
  RecentCost PerTransfer{ 2e-7 };            // of a cell
};
}

#endif
