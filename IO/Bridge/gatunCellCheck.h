// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunCellCheck_h
#define gatunCellCheck_h

#include "vtkGatunIOModule.h" // For export macro
#include "vtkType.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkCellArray;
class vtkUnstructuredGrid;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/**
 * Checks of cell arrays, which VTK itself does not validate. Each throws gatun::Error
 * (InvalidInput). Exported for the gtn program.
 */
///@{
/** Offsets must start at 0, be nondecreasing, and end within the connectivity. */
VTKGATUNIO_EXPORT void CheckOffsets(vtkCellArray* cells);

/** All ids must be in [0, points). */
VTKGATUNIO_EXPORT void CheckPointIds(vtkCellArray* cells, vtkIdType points);

/** There must be a type for each cell, the offsets must fit, and arrays must have a tuple for each
 * point or cell. */
void CheckGrid(vtkUnstructuredGrid* grid);

/** A cell must have as many points as its type needs, with ids that exist. */
void CheckCell(vtkIdType cell, int type, vtkIdType size, const vtkIdType* ids, vtkIdType points);

/** CheckCell for all cells. */
void CheckCells(vtkUnstructuredGrid* grid);
///@}
}

#endif
