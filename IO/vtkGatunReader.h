// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGatunReader
 * @brief Reads a compressed unstructured mesh (`.gtn`), whole or in pieces.
 *
 * The output is a vtkUnstructuredGrid that equals the input of vtkGatunWriter, as
 * vtkGatunMeshReader describes. All properties but SplitCells are those of vtkGatunMeshReader.
 * Corners of tetrahedra and triangles may be rotated unless the file keeps their order, but keep
 * their orientation. A file of a surface (vtkPolyData) is an error: vtkGatunSurfaceReader reads it.
 *
 * @sa vtkGatunMeshReader vtkGatunSurfaceReader vtkGatunWriter vtkGatunFileHandle
 */

#ifndef vtkGatunReader_h
#define vtkGatunReader_h

#include "vtkGatunIOModule.h" // For export macro
#include "vtkGatunMeshReader.h"
#include "vtkUnstructuredGrid.h" // For callers of GetOutput

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class VTKGATUNIO_EXPORT vtkGatunReader : public vtkGatunMeshReader
{
public:
  static vtkGatunReader* New();
  vtkTypeMacro(vtkGatunReader, vtkGatunMeshReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The output of the reader.
   */
  vtkUnstructuredGrid* GetOutput();
  vtkUnstructuredGrid* GetOutput(int port);
  ///@}

  /**
   * Whether the file begins as a `.gtn` file of any version and is not known to hold a surface: 1
   * or 0. Reads no more than the directory of the file.
   */
  int CanReadFile(VTK_FILEPATH const char* name) override;

  const char* GetDescriptiveName() override { return "Gatun unstructured mesh"; }

  ///@{
  /**
   * Whether to read the tetrahedra that 3D cells consist of (Documentation/cells.md) in place of
   * the original cells. They have the values of their cells, and their order is not restored.
   * Simplified meshes always consist of tetrahedra. Default: off.
   */
  vtkSetMacro(SplitCells, bool);
  vtkGetMacro(SplitCells, bool);
  vtkBooleanMacro(SplitCells, bool);
  ///@}

protected:
  vtkGatunReader();
  ~vtkGatunReader() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  bool ReadsSurfaces() const override { return false; }
  bool GetSplitsCells() const override { return this->SplitCells; }

  bool SplitCells = false;

private:
  vtkGatunReader(const vtkGatunReader&) = delete;
  void operator=(const vtkGatunReader&) = delete;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
