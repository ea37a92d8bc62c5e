// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunTetInput_h
#define gatunTetInput_h

#include "vtkGatunIOModule.h" // For export macro
#include "vtkSmartPointer.h"

#include <string>
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
/** A grid of nothing but tetrahedra. */
struct TetInput
{
  vtkSmartPointer<vtkUnstructuredGrid> Grid; ///< the input itself where nothing had to be done
  std::vector<std::string> Warnings;         ///< what was done to it
};

/**
 * Makes tetrahedra of what a grid has:
 *
 *  - ghost cells (DUPLICATECELL) go, and points that only they use;
 *  - other linear 3D cells are split by vtkDataSetTriangleFilter, tetrahedra stay as they are; cell
 *    data are carried, and the new cell array OriginalCellIds (vtkIdType, unless there is one of
 *    that name) tells the cell of the input; global ids of cells are no longer marked as such;
 *  - quadratic tetrahedra become linear if asked for, and points that only they used go.
 *
 * Throws gatun::Error (InvalidInput) for all other cells, for cells of a wrong size, for offsets
 * that do not fit, for arrays of a wrong length, and, as far as cells had to be looked at, for
 * point ids out of range. Exported for the gtn program.
 */
VTKGATUNIO_EXPORT TetInput MakeTetInput(vtkUnstructuredGrid* input, bool linearizeQuadratic);
}

#endif
