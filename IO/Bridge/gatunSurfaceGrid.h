// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunSurfaceGrid_h
#define gatunSurfaceGrid_h

// Surfaces (vtkPolyData) as grids, which the core writes and reads, and back.

#include "gatunSurfaceCells.h"

#include "vtkGatunIOModule.h" // For export macro
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <array>
#include <vector>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkCellArray;
class vtkPolyData;
class vtkUnstructuredGrid;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/**
 * Returns the grid with the points, cells and arrays of a surface. Cells are in the order of the
 * surface's cell arrays: vertices, lines, polygons, strips. Point ids have 64 bits if one of these
 * lists has such. A single list is shared, several are copied. Arrays are shared, and may have a
 * wrong length: MakeCellInput checks them.
 *
 * Throws Error(InvalidInput) for point ids and offsets that do not fit.
 */
VTKGATUNIO_EXPORT vtkSmartPointer<vtkUnstructuredGrid> MakeSurfaceGrid(vtkPolyData* surface);

/** The cells of a grid as the lists of a surface. */
struct SurfaceCells
{
  vtkSmartPointer<vtkCellArray> Source;                          ///< the cells of the grid
  std::array<vtkSmartPointer<vtkCellArray>, SurfaceLists> Lists; ///< null if they are empty
  std::vector<vtkIdType> Order; ///< for each cell of the surface that of the grid; empty: the same
};

/** Throws Error(Corrupt) for cells that cannot be part of a surface. */
VTKGATUNIO_EXPORT SurfaceCells FindSurfaceCells(vtkUnstructuredGrid* grid);

/** Makes the surface of a grid with these cells. Points and arrays are shared, but cell arrays in
 * another order. */
VTKGATUNIO_EXPORT void MakeSurface(
  vtkUnstructuredGrid* grid, const SurfaceCells& cells, vtkPolyData* surface);
}

#endif
