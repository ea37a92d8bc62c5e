// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGatunSurfaceReader
 * @brief Reads a compressed surface (`.gtn`), whole or in pieces.
 *
 * The output is a vtkPolyData that equals the input of vtkGatunWriter, as vtkGatunMeshReader
 * describes: polygons of any size, vertices, lines and triangle strips with their points in order,
 * and all point, cell and field arrays. All properties are those of vtkGatunMeshReader.
 *
 * *Order.* The cells of a file are in any order. In the output, as in every vtkPolyData, vertices
 * come first, then lines, polygons and strips, each in the order of the file, and cell arrays
 * follow. With the order of cells kept (vtkGatunWriter::KeepOrder), that is the order of the input.
 *
 * *Ids.* The cell arrays have 64-bit ids if one of the input's had them, and 32-bit ids otherwise.
 *
 * *Cost.* As of vtkGatunMeshReader. A surface of polygons alone shares its cell array with what is
 * decoded. If cells of several lists are mixed in the file, cells and cell arrays are copied once
 * more.
 *
 * A file that holds a grid (vtkUnstructuredGrid) is an error: vtkGatunReader reads it.
 *
 * @sa vtkGatunMeshReader vtkGatunReader vtkGatunWriter
 */

#ifndef vtkGatunSurfaceReader_h
#define vtkGatunSurfaceReader_h

#include "vtkGatunIOModule.h" // For export macro
#include "vtkGatunMeshReader.h"
#include "vtkPolyData.h" // For callers of GetOutput

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class VTKGATUNIO_EXPORT vtkGatunSurfaceReader : public vtkGatunMeshReader
{
public:
  static vtkGatunSurfaceReader* New();
  vtkTypeMacro(vtkGatunSurfaceReader, vtkGatunMeshReader);

  ///@{
  /**
   * The output of the reader.
   */
  vtkPolyData* GetOutput();
  vtkPolyData* GetOutput(int port);
  ///@}

  /**
   * Whether the file is a readable `.gtn` file that holds a surface: 1 or 0. Reads no more than the
   * directory of the file.
   */
  int CanReadFile(VTK_FILEPATH const char* name) override;

  const char* GetDescriptiveName() override { return "Gatun surface"; }

protected:
  vtkGatunSurfaceReader();
  ~vtkGatunSurfaceReader() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  bool ReadsSurfaces() const override { return true; }

private:
  vtkGatunSurfaceReader(const vtkGatunSurfaceReader&) = delete;
  void operator=(const vtkGatunSurfaceReader&) = delete;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
