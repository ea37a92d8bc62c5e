// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunCellSplit_h
#define gatunCellSplit_h

#include "vtkType.h"

#include <span>
#include <vector>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkUnstructuredGrid;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/** Tetrahedra, four corners each, and the input cell of each. */
struct SplitCells
{
  std::vector<vtkIdType> Corners;
  std::vector<vtkIdType> Cells;
};

/**
 * Splits 3D cells of a grid into tetrahedra, in the order of the cells: see SplitCell in
 * gatunSimplices.h. Nonlinear cells are taken for linear ones, convex point sets for their hulls,
 * and tetrahedra stay as they are. Parallel.
 *
 * cells: their types, sizes and point ids must be right. Throws Error(InvalidInput) for the faces
 * of polyhedra, which are checked here.
 */
SplitCells SplitIntoTets(vtkUnstructuredGrid* grid, std::span<const vtkIdType> cells);
}

#endif
