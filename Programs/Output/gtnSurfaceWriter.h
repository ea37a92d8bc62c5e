// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnSurfaceWriter_h
#define gtnSurfaceWriter_h

#include "gtnGridWriter.h"

#include "vtkType.h"

#include <string>

class vtkCellArray;
class vtkPolyData;

namespace gtn
{
class Progress;

/** The formats that WriteSurface writes, for help texts. */
extern const char* const SurfaceFormats;

/** What a format of surfaces holds besides points and triangles. */
struct SurfaceFormat
{
  bool Polygons = false; ///< of any size
  bool Arrays = false;   ///< and lines, and vertices
  bool Strips = false;
  bool Normals = false;    ///< of points
  bool Double = false;     ///< coordinates of double precision
  bool Degenerate = false; ///< polygons of less than 3 corners
};

/** Of a file, by its extension. Throws UsageError for those that there are none for. */
SurfaceFormat GetSurfaceFormat(const std::string& file);

/** The number of polygons or strips of less than 3 corners, which VTK's lists may have. */
vtkIdType CountDegenerate(vtkCellArray* cells);

/** "2 lines, 3 arrays": what the format of a file cannot hold of a surface. Empty if it holds all.
 */
std::string ListLost(vtkPolyData* surface, const std::string& file);

/** Writes polygons, and what else the format holds. In formats without them, strips and polygons
 * are divided into triangles, and what ListLost lists is left out. The compressor is that of a .vtp
 * file. A file of that name is replaced once the new one is complete. Throws Failure. */
void WriteSurface(vtkPolyData* surface, const std::string& file, Progress& progress,
  Compressor compressor = Compressor::ZLib);
}

#endif
