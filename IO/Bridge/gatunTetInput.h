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
/** A grid that consists of tetrahedra. */
struct TetInput
{
  vtkSmartPointer<vtkUnstructuredGrid> Grid; ///< the input itself if it needs no changes
  std::vector<std::string> Warnings;         ///< the changes that were made
  std::string LeftOut; ///< the cells of a lower dimension, such as "12 vtkTriangle"
};

/** What becomes of cells that are not linear 3D cells. */
struct TetInputOptions
{
  bool Linearize = false;      ///< nonlinear 3D cells lose their other points, or they are refused
  bool LeaveOutOthers = false; ///< cells of a lower dimension are left out, or they are refused
};

/** For whatever draws or computes volumes. */
inline constexpr TetInputOptions VolumesOnly{ true, true };

/**
 * Converts the cells of a grid to tetrahedra:
 *
 *  - Ghost cells (DUPLICATECELL) are removed, and so are points that only cells use that go.
 *  - Other linear 3D cells and polyhedra are split by the rule of gatunSimplices.h. Cell data are
 *    copied to the parts. The new cell array OriginalCellIds (vtkIdType, unless there is one of
 *    that name) contains the cell of the input. Global ids of cells are no longer marked as such.
 *  - Nonlinear 3D cells and cells of a lower dimension are treated as the options say.
 *
 * Throws Error(InvalidInput) for all other cells, cells of a wrong size, offsets that do not fit,
 * and arrays of a wrong length. Point ids are checked only if cells are removed, split or
 * converted. Exported for the gtn program.
 */
VTKGATUNIO_EXPORT TetInput MakeTetInput(vtkUnstructuredGrid* input, const TetInputOptions& options);
}

#endif
