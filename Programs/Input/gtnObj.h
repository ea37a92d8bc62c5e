// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnObj_h
#define gtnObj_h

#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <vector>

class vtkPolyData;

namespace gtn
{
/** Reads the points and faces of a Wavefront .obj file, as a SurfaceFunction. Throws Failure, which
 * names the line, for any content of the file.
 *
 * Not by vtkOBJReader: it follows indices that do not exist, rounds coordinates to single
 * precision, and splits points where a texture has a seam, so that a closed surface is no longer
 * closed. */
vtkSmartPointer<vtkPolyData> ReadObj(const std::string& file,
  const std::function<bool(double)>& progress, std::vector<std::string>& leftOut);
}

#endif
