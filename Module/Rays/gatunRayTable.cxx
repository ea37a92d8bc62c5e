// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunRayTable.h"

#include <algorithm>
#include <cmath>

namespace gatun
{
//------------------------------------------------------------------------------
RayTable::RayTable(RayMode mode, const RayColor& color, const Range& range, double sampleDistance,
  double unitDistance)
  : Mode(mode)
  , Cells(Size + 1)
  , VisibleCells(Size + 2)
{
  // Full opacity would be an infinite optical depth.
  constexpr double mostOpaque = 1 - 1e-7;
  const bool hasRange = range.Min < range.Max && std::isfinite(range.Max - range.Min);
  this->Low = range.Min <= range.Max ? range.Min : 0;
  this->Scale = hasRange ? Size / (range.Max - range.Min) : 0;
  const auto getEntry = [&](double place) -> std::array<double, 4>
  {
    auto [r, g, b, a] = color(hasRange ? this->Low + place / this->Scale : this->Low);
    const double depth =
      -std::log1p(-std::clamp(a, 0.0, mostOpaque)) * sampleDistance / unitDistance;
    switch (mode)
    {
      case RayMode::Sampled:
        a = -std::expm1(-depth);
        return { r * a, g * a, b * a, -a };
      case RayMode::Maximum:
        return { r * a, g * a, b * a, -a };
      case RayMode::Composite:
      case RayMode::XRay:
        break;
    }
    return { r * depth, g * depth, b * depth, depth };
  };
  for (std::size_t i = 0; i <= Size; ++i)
  {
    const auto entry = getEntry(static_cast<double>(i));
    for (std::size_t c = 0; c < 4; ++c)
    {
      this->Cells[i].Value[c] = static_cast<float>(entry[c]);
      if (i > 0)
      {
        this->Cells[i - 1].Change[c] = this->Cells[i].Value[c] - this->Cells[i - 1].Value[c];
      }
    }
  }
  this->Cells[Size].Change = {};
  for (std::size_t i = 0; i <= Size; ++i)
  {
    const bool visible = this->Cells[i].Value[3] != 0 || this->Cells[i].Change[3] != 0;
    this->VisibleCells[i + 1] = this->VisibleCells[i] + (visible ? 1 : 0);
  }
  if (mode == RayMode::Composite || mode == RayMode::XRay)
  {
    this->Pieces = MakeRayPieces(getEntry, Size);
  }
}

//------------------------------------------------------------------------------
bool RayTable::IsTransparent(const Range& values) const
{
  if (!(values.Min <= values.Max))
  {
    return true;
  }
  const auto toCell = [&](double value)
  {
    const double cell = (value - this->Low) * this->Scale;
    return static_cast<std::size_t>(std::clamp(cell, 0.0, static_cast<double>(Size)));
  };
  return this->VisibleCells[toCell(values.Max) + 1] == this->VisibleCells[toCell(values.Min)];
}
}
