// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunTetMesh_h
#define gatunTetMesh_h

#include "gatunFileWriter.h"

#include "vtkGatunIOModule.h" // For export macro
#include "vtkSmartPointer.h"

#include <cstddef>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkDataArray;
class vtkUnstructuredGrid;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/** A grid of tetrahedra as input of the core. The smart pointers keep its memory alive. */
struct VTKGATUNIO_EXPORT TetMesh
{
  MeshInput Mesh;
  bool PointsConverted = false; ///< to double, from a type other than float and double
  vtkSmartPointer<vtkDataArray> Coordinates;
  vtkSmartPointer<vtkDataArray> Connectivity;

  /** Throws gatun::Error (InvalidInput) if integer coordinates exceed 2^53. */
  explicit TetMesh(vtkUnstructuredGrid* grid);
  ~TetMesh();

  /** A hash of coordinates and connectivity. */
  std::size_t Hash() const;
};
}

#endif
