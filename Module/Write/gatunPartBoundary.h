// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPartBoundary_h
#define gatunPartBoundary_h

#include "gatunMeshAccess.h"
#include "gatunPartition.h"

#include <cstdint>
#include <vector>

namespace gatun
{
/**
 * Marks the points of a part that other parts of the mesh may have, too: those of faces that only
 * one 3D cell has, of edges that only one 2D cell has, and of ends that only one 1D cell has;
 * points of cells of different dimensions; all points of vertices, of cells whose faces or edges
 * are not known, and unused points. Faces and edges of more than two cells count as those of one.
 *
 * A point inside a part that another part has is not found: that of a line or a polygon that ends
 * within the solid of another part, for instance.
 */
std::vector<std::uint8_t> FindPartBoundary(const MeshAccess& mesh, const Partition& layout);
}

#endif
