// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunSurfaceMergeBuilder_h
#define gatunSurfaceMergeBuilder_h

#include "gatunExport.h"
#include "gatunMergeInput.h"
#include "gatunMergeTree.h"

#include <functional>

namespace gatun
{
/**
 * Merges the points of a triangle mesh (half-edge collapses) until no more merges are possible.
 * Each merge is the cheapest one that is known, by the quadric error of the shape and of the
 * fields. No triangle turns over or becomes flat, the topology does not change, and the border
 * stays where it is as far as possible, and so do edges between triangles with different normals.
 *
 * Points with the same coordinates, such as those of a seam, are merged one after the other, or not
 * at all. The tree marks merges that belong together; see MergeTree::CountWholeMerges.
 *
 * Kept are: points of IsKept; points where the triangles around are not one fan, as at an edge of
 * three triangles; points of triangles with a point or a place twice; points without triangles;
 * points whose coordinates or values are not finite. Others may be merged into them if they stay
 * such points.
 *
 * The error of a merge is the root of the mean square error of the shape, relative to the diagonal
 * of the mesh, and of the fields, relative to their ranges, by the quadrics of all merges up to it.
 * Errors never decrease.
 *
 * All threads evaluate; the result does not depend on their number. Progress: called with the
 * fraction done; returns false to stop, and Error(Aborted) is thrown.
 *
 * Based on: see SurfaceQuadrics.
 */
GATUN_EXPORT MergeTree BuildMergeTree(const SurfaceMergeInput& input,
  const SurfaceMergeSettings& settings = {}, const std::function<bool(double)>& progress = {});
}

#endif
