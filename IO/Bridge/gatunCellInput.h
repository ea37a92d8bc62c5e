// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunCellInput_h
#define gatunCellInput_h

#include "vtkGatunIOModule.h" // For export macro
#include "vtkSmartPointer.h"

#include <cstddef>
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
  std::size_t GhostCells = 0;                ///< the number of ghost cells that were removed
};

/** What happens to ghost cells (DUPLICATECELL in vtkGhostType). */
enum class GhostCells
{
  Keep,
  Remove ///< and points that only they use
};

/**
 * Prepares a grid to be written, or compared with one that was written.
 *
 * split: whether to split 3D cells into tetrahedra, with a warning, as MakeTetInput does. Nonlinear
 * cells lose their other points, and cells of a lower dimension and ghost cells are left out.
 *
 * Throws Error(InvalidInput), with the number of the cell, for cells of a wrong size, for point ids
 * and offsets that do not fit, and for arrays of a wrong length. Exported for the gtn program.
 */
VTKGATUNIO_EXPORT CellInput MakeCellInput(
  vtkUnstructuredGrid* input, bool split, GhostCells ghosts);

/** "1 ghost cell is" or "8 ghost cells are" and "left out". */
VTKGATUNIO_EXPORT std::string DescribeLostGhosts(std::size_t cells);
}

#endif
