// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunMergeBuilder_h
#define gatunMergeBuilder_h

#include "gatunExport.h"
#include "gatunMergeInput.h"
#include "gatunMergeTree.h"

#include <functional>

namespace gatun
{
/**
 * Merges points (half-edge collapses) until no more merges are possible. Each merge is the cheapest
 * one that is known. The cost of merging a point into a neighbor is the square of the change of the
 * fields and of the shape of the boundary, divided by the number of tetrahedra that vanish. Points
 * of the boundary are merged only into points of the boundary. No tetrahedron and no face of the
 * boundary is turned over or made flat. The topology does not change.
 *
 * The error of a merge covers all changes up to it: it is an estimate of the root mean square error
 * of the fields, relative to their ranges, and of the shape. Errors never decrease.
 *
 * Small changes around a point are evaluated late, so that a merge that has become cheaper may come
 * late. Points of IsKept are never merged. All threads evaluate; the result does not depend on
 * their number. Points whose coordinates or values are not finite are kept, and so are their
 * neighbors.
 *
 * Progress: called with the fraction done; returns false to stop, and Error(Aborted) is thrown.
 *
 * Based on: Van Gelder, Verma, Wilhelms: Volume decimation of irregular tetrahedral grids. Computer
 * Graphics International 1999. The quadratic error of the fields is in the spirit of: Garland,
 * Zhou: Quadric-based simplification in any dimension. ACM Transactions on Graphics 24(2), 2005.
 */
GATUN_EXPORT MergeTree BuildMergeTree(const MergeInput& input, const MergeSettings& settings = {},
  const std::function<bool(double)>& progress = {});
}

#endif
