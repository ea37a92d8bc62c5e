// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnPly_h
#define gtnPly_h

#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <vector>

class vtkPolyData;

namespace gtn
{
/**
 * Reads a .ply file, in text or in binary, as a SurfaceFunction, and checks it, which VTK's reader
 * does not: points in their own type, polygons and triangle strips, and the properties of vertices
 * and faces as arrays of their own types. Normals, colors and texture coordinates become one array
 * each. Other elements and other lists are left out. Throws Failure for any content of the file.
 */
vtkSmartPointer<vtkPolyData> ReadPly(const std::string& file,
  const std::function<bool(double)>& progress, std::vector<std::string>& leftOut);
}

#endif
