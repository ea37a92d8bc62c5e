// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunTetInput_h
#define gatunTetInput_h

#include "vtkGatunIOModule.h" // For export macro
#include "vtkSmartPointer.h"
#include "vtkType.h"

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
  std::vector<std::string> Warnings;         ///< the changes that users may not expect
  std::string Split;                         ///< the cells that were split, such as "12 vtkWedge"
  vtkIdType SplitTets = 0;                   ///< the tetrahedra made of them
  std::string LeftOut;                       ///< the cells of a lower dimension
};

/**
 * Converts the cells of a grid to tetrahedra, for whatever draws or computes volumes:
 *
 *  - Ghost cells (DUPLICATECELL) are removed, and so are points that only cells use that go.
 *  - Other 3D cells are split by the rule of gatunSimplices.h. Cell data are copied to the parts.
 *    Global ids of cells are no longer marked as such.
 *  - Nonlinear 3D cells are taken for linear ones, with a warning. Cells of a lower dimension are
 *    left out.
 *
 * withOriginalIds: whether to add the cell array OriginalCellIds (vtkIdType, unless there is one of
 * that name), with the cell of the input that each tetrahedron is a part of.
 *
 * Throws Error(InvalidInput) for cells of an unknown type or a wrong size, offsets that do not fit,
 * and arrays of a wrong length. Point ids are checked only if cells are removed, split or
 * converted. Exported for the gtn program.
 */
VTKGATUNIO_EXPORT TetInput MakeTetInput(vtkUnstructuredGrid* input, bool withOriginalIds = false);
}

#endif
