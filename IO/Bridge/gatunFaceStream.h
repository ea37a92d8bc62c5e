// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunFaceStream_h
#define gatunFaceStream_h

// The faces of polyhedra. VTK 9.4 has them as cell arrays; its functions for the streams of before
// leave out polyhedra after a cell of another type.

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
 * The faces of a grid, which may be its own arrays. They are not checked, except that VTK 9.4 keeps
 * lists of faces: Error(InvalidInput) if one names a face that does not exist.
 */
VTKGATUNIO_EXPORT FaceStream GetFaceStream(vtkUnstructuredGrid* grid);

/** Sets the cells of a grid, which may have valid faces. */
VTKGATUNIO_EXPORT void SetCells(vtkUnstructuredGrid* grid, vtkUnsignedCharArray* types,
  vtkCellArray* cells, const FaceStream& faces);
}

#endif
