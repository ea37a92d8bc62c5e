// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunMergeBuilder_h
#define gatunMergeBuilder_h

#include "gatunMergeInput.h"
#include "gatunMergeTree.h"
#include "vtkGatunCoreModule.h"

#include <functional>

namespace gatun
{
/**
 * Merges points until no more can be. Each merge is the cheapest that is known: of each point the
 * best neighbour to be merged into, by the square of what the fields and the shape of the boundary
 * change for each tetrahedron that vanishes. Points of the boundary are merged into such points
 * only; no tetrahedron and no face of the boundary is turned over or made flat; the topology stays.
 *
 * The error of a merge tells of all changes up to it: an estimate of the root mean square error of
 * the fields, as a part of their ranges, and of the shape. It never becomes less.
 *
 * What changes a little around a point is looked at when its turn comes, so that a merge which has
 * become cheaper may come late. Points whose coordinates or values are not numbers stay, and so do
 * their neighbours.
 *
 * Progress: called with the part that is done; returns false to stop, by Error(Aborted).
 *
 * Based on: Van Gelder, Verma, Wilhelms: Volume decimation of irregular tetrahedral grids. Computer
 * Graphics International 1999. The squares of what the fields change are in the spirit of: Garland,
 * Zhou: Quadric-based simplification in any dimension. ACM Transactions on Graphics 24(2), 2005.
 */
VTKGATUNCORE_EXPORT MergeTree BuildMergeTree(const MergeInput& input,
  const MergeSettings& settings = {}, const std::function<bool(double)>& progress = {});
}

#endif
