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
/** A grid of nothing but tetrahedra as the core takes it; the owners keep its memory. */
struct VTKGATUNIO_EXPORT TetMesh
{
  MeshInput Mesh;
  bool PointsConverted = false; ///< to double, as they were neither float nor double
  vtkSmartPointer<vtkDataArray> Coordinates;
  vtkSmartPointer<vtkDataArray> Connectivity;

  /** Throws gatun::Error (InvalidInput) for coordinates that are integers beyond 2^53. */
  explicit TetMesh(vtkUnstructuredGrid* grid);
  ~TetMesh();

  /** A number that almost certainly differs for another mesh. */
  std::size_t Hash() const;
};
}

#endif
