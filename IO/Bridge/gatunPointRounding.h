// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPointRounding_h
#define gatunPointRounding_h

#include "vtkGatunIOModule.h" // For export macro
#include "vtkSmartPointer.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkUnstructuredGrid;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/** How coordinates are rounded before they are written. At most one of the first three members is
 * not 0. */
struct PointRounding
{
  /** The largest difference of a coordinate, 0 or more. Coordinates become multiples of the largest
   * power of two that keeps it, so that equal coordinates of several pieces stay equal. */
  double Error = 0;

  /** The same, relative to the longest side of the bounding box. */
  double RelativeError = 0;

  /** The bits of the lattice, 0 to 31: coordinates become multiples of the longest side of the
   * bounding box divided by 2^Bits - 1, from the least coordinates on. */
  int Bits = 0;

  /** Whether this is the whole mesh. Only then points can be on finer lattices than others: those
   * of other pieces would not know. */
  bool IsWhole = true;

  bool IsExact() const { return this->Error == 0 && this->RelativeError == 0 && this->Bits == 0; }
};

/** Throws Error(InvalidInput) unless the members are in their ranges. */
void CheckRounding(const PointRounding& rounding);

/**
 * Returns the grid with rounded coordinates, or the grid itself if nothing changes. Coordinates
 * that are not finite stay, and so do integers. largest becomes the largest difference, if that is
 * larger.
 *
 * No cell turns over: the tetrahedra at the corners of linear and nonlinear tetrahedra, hexahedra,
 * voxels, wedges and pyramids keep their orientation, in exact arithmetic; flat ones stay flat.
 * Where they would not, their corners are on lattices with 1/2, 1/4, ... of the step, or stay.
 * Throws Error(InvalidInput) if this holds for more than 1 % of the points, or for any point if the
 * grid is not whole. The message names an error that would do.
 */
vtkSmartPointer<vtkUnstructuredGrid> RoundPoints(
  vtkUnstructuredGrid* grid, const PointRounding& rounding, double& largest);
}

#endif
