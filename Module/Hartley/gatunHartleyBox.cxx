// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunHartleyBox.h"

#include "gatunHartleyLanes.h"
#include "gatunParallel.h"

#include <algorithm>
#include <cmath>

namespace gatun
{
//------------------------------------------------------------------------------
void MeasureHartleyBox(
  const HartleyLayout::Triple& size, const HartleyView& view, std::span<float> samples)
{
  constexpr std::size_t rowsAtOnce = 8;
  // Rays that are nearly orthogonal to an axis stay at one place along it.
  constexpr double leastStep = 1e-7;
  HartleyBox box{};
  std::array<double, 3> steps{};
  std::size_t along = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double step = view.Step[axis];
    along = std::abs(step) > std::abs(view.Step[along]) ? axis : along;
    steps[axis] = std::copysign(std::max(std::abs(step), leastStep), step);
    box.HalfSize[axis] = static_cast<float>((size[axis] + 1.0) / 2);
    box.PerStep[axis] = static_cast<float>(std::abs(steps[axis]));
    box.PerVoxel[axis] = static_cast<float>(1 / steps[axis]);
  }
  // Along the ray, positions count from the middle of the box.
  const auto toMiddle = [&](HartleyView::Vector& point)
  {
    const double distance = point[along] / steps[along];
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      point[axis] -= distance * steps[axis];
    }
  };
  HartleyView::Vector column = view.ColumnStep;
  toMiddle(column);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    box.Column[axis] = static_cast<float>(column[axis]);
  }
  ParallelFor((view.Height + rowsAtOnce - 1) / rowsAtOnce,
    [&](std::size_t group)
    {
      const std::size_t end = std::min<std::size_t>((group + 1) * rowsAtOnce, view.Height);
      for (std::size_t y = group * rowsAtOnce; y < end; ++y)
      {
        HartleyView::Vector point{};
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          point[axis] = view.Origin[axis] + static_cast<double>(y) * view.RowStep[axis] -
            (size[axis] - 1.0) / 2;
        }
        toMiddle(point);
        const std::array<float, 3> origin{ static_cast<float>(point[0]),
          static_cast<float>(point[1]), static_cast<float>(point[2]) };
        GetBestHartleyLanes().Measure(
          box, origin.data(), view.Width, samples.data() + y * view.Width);
      }
    });
}
}
