// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunMeshCheck_h
#define gatunMeshCheck_h

#include "gatunMeshAccess.h"

#include "gatunExport.h" // For export macro

namespace gatun
{
/**
 * Throws Error(InvalidInput), with the number of the cell, unless all cells refer to points that
 * exist, their positions ascend, and the lists of faces of polyhedra are complete. Also throws if
 * there are more points or cells than 32 bits can number, or a cell is larger than a chunk can be.
 */
GATUN_EXPORT void CheckCells(const MeshAccess& mesh);

/** Throws Error(InvalidInput) unless a cell has as many points as its type needs. */
GATUN_EXPORT void CheckCellSize(std::uint64_t cell, int type, std::uint64_t size);

/** The same for all cells. */
GATUN_EXPORT void CheckCellSizes(const MeshAccess& mesh);
}

#endif
