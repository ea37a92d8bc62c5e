// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnObj_h
#define gtnObj_h

#include "vtkPolyDataAlgorithm.h"

#include <string>

namespace gtn
{
/** Reads the points and faces of a Wavefront .obj file; a warning names what else the file has.
 * Reports an error, which names the line, for any content of the file.
 *
 * Not by vtkOBJReader: it follows indices that do not exist, rounds coordinates to single
 * precision, and splits points where a texture has a seam, so that a closed surface is no longer
 * closed. */
class ObjReader : public vtkPolyDataAlgorithm
{
public:
  static ObjReader* New();
  vtkTypeMacro(ObjReader, vtkPolyDataAlgorithm);

  void SetFileName(const char* file);

protected:
  ObjReader();

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  std::string File;
};
}

#endif
