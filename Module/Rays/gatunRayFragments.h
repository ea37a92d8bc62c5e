// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunRayFragments_h
#define gatunRayFragments_h

// Fragments as bytes, sent from a RayCaster to a RayMerger. For each tile:
//
//   uint32    number of the tile, times 2, plus 1 if there are depths
//   uint32    number of bytes that follow
//   varint    for each cell of the tile, how many fragments it has; 0 or 1 in modes Maximum and
//             XRay
//   modes Composite and Sampled:
//     float32   for each fragment, in the order of cells: where it begins
//     float32   for each fragment: its opacity
//     uint16    for each fragment: red, green and blue by opacity, 65535 for 1
//   mode Maximum:
//     float32   for each cell with a fragment: the largest place in the table
//   mode XRay:
//     float32   for each cell with a fragment: sums of red, green and blue; the optical depth
//   with depths:
//     float32   for each cell with a fragment: where its first visible part begins
//
// Where a fragment ends need not be known: fragments are in order by their beginnings. Fragments
// that touch are merged before.

#include "gatunBytes.h"
#include "gatunRayTable.h"
#include "gatunRayTile.h"

#include <cstddef>
#include <cstdint>

namespace gatun
{
/** Appends the fragments of a tile, if it has any. Consolidates the tile. */
void WriteFragments(
  RayMode mode, std::size_t index, RayTile& tile, bool withDepths, ByteWriter& bytes);
}

#endif
