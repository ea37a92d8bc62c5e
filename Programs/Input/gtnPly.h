// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnPly_h
#define gtnPly_h

#include "vtkPolyDataAlgorithm.h"

#include <string>

namespace gtn
{
/**
 * Reads .ply files, in text and in binary, and checks them, which VTK's reader does not: points in
 * their own type, polygons and triangle strips, and the properties of vertices and faces as arrays
 * of their own types. Normals, colors and texture coordinates become one array each. Other elements
 * and other lists are left out with a warning that names them.
 */
class PlyReader : public vtkPolyDataAlgorithm
{
public:
  static PlyReader* New();
  vtkTypeMacro(PlyReader, vtkPolyDataAlgorithm);

  void SetFileName(const char* file);

protected:
  PlyReader();

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  std::string File;
};
}

#endif
