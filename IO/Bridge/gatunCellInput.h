// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunCellInput_h
#define gatunCellInput_h

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
/** A grid that can be written. */
struct CellInput
{
  vtkSmartPointer<vtkUnstructuredGrid> Grid; ///< the input itself if it needs no changes
  std::vector<std::string> Warnings;         ///< the changes that were made
};

/**
 * Prepares a grid to be written, or compared with one that was written. Ghost cells (DUPLICATECELL)
 * are removed, and so are points that only ghost cells use.
 *
 * split: whether to split 3D cells into tetrahedra, with a warning, as MakeTetInput does. Nonlinear
 * cells lose their other points, and cells of a lower dimension are left out.
 *
 * Throws Error(InvalidInput), with the number of the cell, for cells of a wrong size, for point ids
 * and offsets that do not fit, and for arrays of a wrong length. Exported for the gtn program.
 */
VTKGATUNIO_EXPORT CellInput MakeCellInput(vtkUnstructuredGrid* input, bool split);
}

#endif
