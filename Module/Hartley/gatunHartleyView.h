// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyView_h
#define gatunHartleyView_h

#include "vtkGatunCoreModule.h"

#include <array>

namespace gatun
{
/**
 * Which ray each pixel of a picture sees: parallel rays, in index coordinates, in which voxel
 * (i, j, k) is at (i, j, k). Spacing and orientation of a volume, and the pixels' aspect, are all
 * in these vectors, which need not be at right angles. The ray of a pixel goes through Origin +
 * column ColumnStep + row RowStep.
 */
struct HartleyView
{
  using Vector = std::array<double, 3>;

  unsigned Width = 0;
  unsigned Height = 0;
  Vector Origin{}; ///< seen by pixel (0, 0)
  Vector ColumnStep{ 1, 0, 0 };
  Vector RowStep{ 0, 1, 0 };
  Vector Step{ 0, 0, 1 }; ///< one sample further along a ray, away from the eye

  bool operator==(const HartleyView&) const = default;
};
}

#endif
