// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyBox_h
#define gatunHartleyBox_h

#include "gatunHartleyLayout.h"
#include "gatunHartleyView.h"

#include <span>

namespace gatun
{
/** The sums of a box of voxels of the value 1 along the rays of all pixels, in samples, row by row.
 * Exact except for rounding. Parallel. */
void MeasureHartleyBox(
  const HartleyLayout::Triple& size, const HartleyView& view, std::span<float> samples);
}

#endif
