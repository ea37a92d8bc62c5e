// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunFileSlice_h
#define gatunFileSlice_h

#include "gatunChunkCache.h"
#include "gatunExport.h"
#include "gatunPieceRequest.h"
#include "gatunRegion.h"
#include "gatunSurface.h"

#include <functional>
#include <memory>

namespace gatun
{
/**
 * The section of a piece with a plane, as triangles: the isosurface 0 of the distance from the
 * plane, with the arrays of the request, of points and of cells, in its order. Only chunks that
 * meet the plane are decoded, some at a time.
 *
 * Memory: the section, and chunks of about two million tetrahedra.
 */
GATUN_EXPORT Surface ExtractSlice(const std::shared_ptr<ChunkCache>& cache,
  const PieceRequest& request, const Region::Plane& plane, ScalarType coordinateType,
  const std::function<bool(double)>& progress = {});
}

#endif
