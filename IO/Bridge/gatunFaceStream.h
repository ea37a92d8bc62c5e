// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunFaceStream_h
#define gatunFaceStream_h

// The faces of polyhedra. VTK 9.4 stores them in cell arrays. Its deprecated functions for face
// streams leave out polyhedra after a cell of another type.

#include "vtkGatunIOModule.h" // For export macro
#include "vtkSmartPointer.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkCellArray;
class vtkIdTypeArray;
class vtkUnsignedCharArray;
class vtkUnstructuredGrid;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/** The faces of the polyhedra of a grid. */
struct FaceStream
{
  /** For each polyhedron the number of its faces, and for each face the number of its points and
   * their ids. Null if there are no polyhedra. */
  vtkSmartPointer<vtkIdTypeArray> Values;

  /** For each cell where it begins in Values, or -1. Null if there are no polyhedra. */
  vtkSmartPointer<vtkIdTypeArray> Locations;
};

/**
 * Returns the faces of a grid, in its own arrays before VTK 9.4. They are not checked, except that
 * Error(InvalidInput) is thrown if a polyhedron of VTK 9.4 names a face that does not exist.
 */
VTKGATUNIO_EXPORT FaceStream GetFaceStream(vtkUnstructuredGrid* grid);

/** Sets the cells of a grid, which may have valid faces. */
VTKGATUNIO_EXPORT void SetCells(vtkUnstructuredGrid* grid, vtkUnsignedCharArray* types,
  vtkCellArray* cells, const FaceStream& faces);
}

#endif
