// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunSurfaceTimes.h"

#include <algorithm>
#include <cmath>

namespace gatun
{
namespace
{
constexpr double FirstCell = 2e-7; // seconds, before anything was drawn

// Each image takes some time for its pixels, as for so many cells.
constexpr double WorkOfPixels = 5000;

/** The number of cells a time is divided by. */
double GetWork(std::uint64_t cells)
{
  return static_cast<double>(cells) + WorkOfPixels;
}
}

//------------------------------------------------------------------------------
void SurfaceTimes::Learn(std::size_t level, std::uint64_t cells, double seconds)
{
  this->PerCell.try_emplace(level, FirstCell).first->second.Add(seconds / GetWork(cells));
}

//------------------------------------------------------------------------------
/** The seconds a cell. */
double SurfaceTimes::PredictWork(std::size_t level) const
{
  const RecentCost* nearest = nullptr;
  std::size_t least = 0;
  for (const auto& [other, recent] : this->PerCell)
  {
    const std::size_t distance = other > level ? other - level : level - other;
    // Of two, the coarser one, whose time a cell is the larger one.
    if (!nearest || distance <= least)
    {
      nearest = &recent;
      least = distance;
    }
  }
  return nearest ? nearest->Get() : FirstCell;
}

//------------------------------------------------------------------------------
double SurfaceTimes::Predict(std::size_t level, std::uint64_t cells) const
{
  return GetWork(cells) * this->PredictWork(level);
}

//------------------------------------------------------------------------------
std::uint64_t SurfaceTimes::CountCells(std::size_t level, double budget) const
{
  constexpr double most = 1e15;
  const double work = FrameAim * budget / std::max(this->PredictWork(level), 1e-12);
  return static_cast<std::uint64_t>(std::clamp(work - WorkOfPixels, 0.0, most));
}

//------------------------------------------------------------------------------
std::size_t SurfaceTimes::Choose(
  double budget, std::span<const std::uint64_t> cells, std::size_t present) const
{
  std::size_t best = 0;
  while (best + 1 < cells.size() && this->Predict(best, cells[best]) > FrameAim * budget)
  {
    ++best;
  }
  const bool isGood =
    present < cells.size() && present < best && this->Predict(present, cells[present]) <= budget;
  return isGood ? present : best;
}

//------------------------------------------------------------------------------
void SurfaceTimes::LearnTransfer(std::uint64_t cells, double seconds)
{
  if (cells > 0)
  {
    this->PerTransfer.Add(seconds / static_cast<double>(cells));
  }
}

//------------------------------------------------------------------------------
double SurfaceTimes::PredictTransfer(std::uint64_t cells) const
{
  return static_cast<double>(cells) * this->PerTransfer.Get();
}
}
