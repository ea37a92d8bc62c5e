// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunTetSeparation_h
#define gatunTetSeparation_h

#include "gatunLayerPartition.h"
#include "gatunMeshAccess.h"

namespace gatun
{
/**
 * Divides buckets of cells into tetrahedra and other cells where that makes the file smaller.
 * Chunks of tetrahedra alone take fewer bits a cell and less time than mixed chunks, but the points
 * between the tetrahedra and the other cells become shared points of chunks, which are expensive.
 * The tetrahedra of a bucket come first. The point ids of the mesh must be right.
 */
void SeparateTets(const MeshAccess& mesh, LayerBuckets& buckets);
}

#endif
