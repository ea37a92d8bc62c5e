// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPointRounding_h
#define gatunPointRounding_h

#include "gatunErrorBound.h"
#include "gatunExport.h" // For export macro
#include "gatunMeshInput.h"

namespace gatun
{
/** Throws Error(InvalidInput) unless coordinates can have the bound: none; absolute, above 0;
 * relative, above 0 and below 1; or 1 to 31 bits. */
GATUN_EXPORT void CheckPointBound(const ErrorBound& bound);

/**
 * Rounds the coordinates of a mesh whose cells CheckCells and CheckCellSizes have found to be
 * right. Coordinates that are not finite stay. Returns the largest difference; if it is 0, no bit
 * changes.
 *
 * Coordinates become multiples of the largest power of two that keeps an absolute bound, or a bound
 * relative to the longest side of the bounding box, so that equal coordinates of several pieces
 * stay equal. With bits, they become multiples of that side divided by 2^bits - 1, from the least
 * coordinates on.
 *
 * No cell turns over: the tetrahedra at the corners of linear and nonlinear tetrahedra, hexahedra,
 * voxels, wedges and pyramids keep their orientation, in exact arithmetic; flat ones stay flat.
 * Where they would not, their corners are on lattices with 1/2, 1/4, ... of the step, or stay.
 * Throws Error(InvalidInput) if this holds for more than 1 % of the points, or for any point if the
 * mesh is not whole, since other pieces would not know. The message suggests a tolerance that
 * works.
 *
 * @param to  as many values as mesh.Coordinates has, of the same type
 */
GATUN_EXPORT double RoundPoints(
  const MeshInput& mesh, const ErrorBound& bound, bool isWhole, void* to);
}

#endif
