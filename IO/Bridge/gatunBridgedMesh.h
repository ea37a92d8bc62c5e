// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunBridgedMesh_h
#define gatunBridgedMesh_h

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
/** A grid as input of the core. The smart pointers keep its memory alive. */
struct VTKGATUNIO_EXPORT BridgedMesh
{
  MeshInput Mesh;
  bool PointsConverted = false; ///< to double, from a type other than float and double
  vtkSmartPointer<vtkDataArray> Coordinates;
  vtkSmartPointer<vtkDataArray> Connectivity;

  // If not all cells are tetrahedra.
  vtkSmartPointer<vtkDataArray> Offsets;
  vtkSmartPointer<vtkDataArray> Types;
  vtkSmartPointer<vtkDataArray> FaceLocations;
  vtkSmartPointer<vtkDataArray> Faces;

  /** Throws gatun::Error (InvalidInput) if integer coordinates exceed 2^53. Cells must have been
   * checked by MakeCellInput or MakeTetInput. */
  explicit BridgedMesh(vtkUnstructuredGrid* grid);
  ~BridgedMesh();

  /** Hashes of cells, of coordinates, and of both. */
  std::size_t HashCells() const;
  std::size_t HashPoints() const;
  std::size_t Hash() const { return 31 * this->HashCells() + this->HashPoints(); }

private:
  void SetOthers(vtkUnstructuredGrid* grid);
};
}

#endif
