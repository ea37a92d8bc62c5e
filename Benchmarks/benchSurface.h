// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef benchSurface_h
#define benchSurface_h

// Ways to make an isosurface, Gatun's and VTK's.

#include "benchMeshes.h"

#include "vtkSmartPointer.h"

#include <memory>
#include <string>
#include <vector>

class vtkGatunContour;
class vtkGatunReader;
class vtkPolyData;

namespace bench
{
/** Makes isosurfaces of one mesh. */
class SurfaceMaker
{
public:
  virtual ~SurfaceMaker() = default;

  /** Triangles with merged points and the array interpolated, as far as the way can. */
  virtual vtkSmartPointer<vtkPolyData> Make(const std::vector<double>& values) = 0;

  /** Gatun's filter; null for other ways. */
  virtual vtkGatunContour* GetGatun() { return nullptr; }

  /** The reader of the file that surfaces are made from; null for other ways. */
  virtual vtkGatunReader* GetReader() { return nullptr; }
};

/**
 * Ways:
 *
 *  - file: vtkGatunContour, straight from a .gtn file;
 *  - memory: vtkGatunContour, of the mesh in memory;
 *  - linear: vtkContour3DLinearGrid with merged points;
 *  - span: vtkContourGrid with vtkSpanSpace.
 *
 * All but the first load the file, a .gtn or .vtu, when they are made. Throws Failure.
 */
std::unique_ptr<SurfaceMaker> MakeSurfaceMaker(
  const std::string& way, const std::string& file, const std::string& array);

/** The same, of a grid; way must not be file. */
std::unique_ptr<SurfaceMaker> MakeSurfaceMaker(
  const std::string& way, vtkUnstructuredGrid* grid, const std::string& array);
}

#endif
