// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunHartleyLattice.h"

namespace gatun
{
//------------------------------------------------------------------------------
HartleyLattice HartleyLattice::Make(
  const HartleyLayout::Triple& block, const HartleyView::Vector& step)
{
  HartleyLattice made;
  int along = 2;
  for (const int axis : { 0, 1 })
  {
    along = std::abs(step[axis]) > std::abs(step[along]) ? axis : along;
  }
  made.Axes = { (along + 1) % 3, (along + 2) % 3, along };
  made.Backwards = step[along] < 0;
  made.SamplesPerVoxel = 1 / std::abs(step[along]);
  for (int i = 0; i < 3; ++i)
  {
    made.Block[i] = block[made.Axes[i]];
  }
  for (int i = 0; i < 2; ++i)
  {
    made.Shear[i] = step[made.Axes[i]] / step[along];
    // Trilinear basis functions reach one voxel beyond the position of their voxel.
    const double reach =
      (made.Block[i] + 1) / 2 + std::abs(made.Shear[i]) * (made.Block[2] + 1) / 2;
    made.Points[i] = 2 * static_cast<std::size_t>(std::ceil(reach / Spacing)) + 1;
  }
  return made;
}
}
