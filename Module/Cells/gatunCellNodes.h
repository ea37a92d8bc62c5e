// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunCellNodes_h
#define gatunCellNodes_h

#include "vtkGatunCoreModule.h" // For export macro

#include <cstdint>
#include <span>

namespace gatun
{
/** The points of a nonlinear cell that are no corners: on edges, on faces and inside. */
struct CellNodes
{
  std::uint8_t Corners = 0;
  std::uint8_t Points = 0; // corners and nodes

  /** For each node the number of the corners that it lies between, 2 to 4, then these corners. Of a
   * cell they are four corners whose mean is the center. */
  std::span<const std::uint8_t> Hosts;
};

/** Returns the nodes of a VTK cell type with a fixed number of points. Corners is 0 for linear
 * types and for all others. */
VTKGATUNCORE_EXPORT CellNodes GetCellNodes(int type);
}

#endif
