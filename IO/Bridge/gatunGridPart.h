// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunGridPart_h
#define gatunGridPart_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

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
/** Some of the points and cells of a grid. */
struct GridPart
{
  std::vector<vtkIdType> Cells;
  std::vector<vtkIdType> Points; ///< at least those that the cells use
};

/**
 * Copies points and cells of any types from a grid that CheckGrid and CheckCells accept; arrays are
 * not copied. Point ids have the size of the original. newIds: for each point of the original that
 * the cells use its position in part.Points.
 *
 * Throws Error(InvalidInput) for a polyhedron with faces that are not in the grid's lists, or that
 * have points for which newIds has no position (-1).
 */
vtkSmartPointer<vtkUnstructuredGrid> ExtractPart(
  vtkUnstructuredGrid* grid, const GridPart& part, const std::vector<vtkIdType>& newIds);
}

#endif
