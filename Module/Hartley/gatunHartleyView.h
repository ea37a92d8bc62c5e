// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyView_h
#define gatunHartleyView_h

#include "gatunExport.h"

#include <array>

namespace gatun
{
/**
 * The parallel rays of an image, in index coordinates: voxel (i, j, k) is at (i, j, k). The ray of
 * a pixel passes through Origin + column * ColumnStep + row * RowStep. The vectors include the
 * spacing and orientation of the volume and the aspect ratio of the pixels. They need not be
 * orthogonal.
 */
struct HartleyView
{
  using Vector = std::array<double, 3>;

  unsigned Width = 0;
  unsigned Height = 0;
  Vector Origin{}; ///< a point on the ray of pixel (0, 0)
  Vector ColumnStep{ 1, 0, 0 };
  Vector RowStep{ 0, 1, 0 };
  Vector Step{ 0, 0, 1 }; ///< from one sample to the next, away from the viewer

  bool operator==(const HartleyView&) const = default;
};
}

#endif
