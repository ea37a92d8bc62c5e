// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunBridgedMesh_h
#define gatunBridgedMesh_h

#include "gatunFaceStream.h"
#include "gatunFileWriter.h"
#include "gatunFingerprint.h"

#include "vtkGatunIOModule.h" // For export macro
#include "vtkSmartPointer.h"

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
  FaceStream Faces;

  /** Throws gatun::Error (InvalidInput) if integer coordinates exceed 2^53. Cells must have been
   * checked by MakeCellInput or MakeTetInput. */
  explicit BridgedMesh(vtkUnstructuredGrid* grid);
  ~BridgedMesh();

  /** Fingerprints of the cells, of the coordinates, and of both. */
  Fingerprint HashCells() const;
  Fingerprint HashPoints() const;
  Fingerprint Hash() const;

private:
  void SetOthers(vtkUnstructuredGrid* grid);
};
}

#endif
