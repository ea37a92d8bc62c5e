// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnSurfaceFileReader_h
#define gtnSurfaceFileReader_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <vector>

class vtkPolyData;

namespace gtn
{
/** Reads a surface from a file. progress: is told the part that is done, and returns false to
 * abort; the surface is empty then. leftOut: receives what of the file is not in the surface.
 * Throws. */
using SurfaceFunction = vtkSmartPointer<vtkPolyData> (*)(const std::string& file,
  const std::function<bool(double)>& progress, std::vector<std::string>& leftOut);

/** A source of the surface in a file, read by a function of gtn. Reports an error for any content
 * of the file that the function refuses; a warning names what is left out. */
class SurfaceFileReader : public vtkPolyDataAlgorithm
{
public:
  static SurfaceFileReader* New();
  vtkTypeMacro(SurfaceFileReader, vtkPolyDataAlgorithm);

  void SetFile(const std::string& file, SurfaceFunction read);

protected:
  SurfaceFileReader();

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  std::string File;
  SurfaceFunction ReadSurface = nullptr;
};
}

#endif
