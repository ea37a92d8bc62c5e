// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnSurfaceWriter_h
#define gtnSurfaceWriter_h

#include <string>

class vtkPolyData;

namespace gtn
{
class Progress;

/** The formats that WriteSurface writes, for help texts. */
extern const char* const SurfaceFormats;

/** What a format of surfaces holds besides points and triangles. */
struct SurfaceFormat
{
  bool Arrays = false;
  bool Strips = false;
  bool Normals = false; ///< of points
  bool Double = false;  ///< coordinates of double precision
};

/** Of a file, by its extension. Throws UsageError for those that there are none for. */
SurfaceFormat GetSurfaceFormat(const std::string& file);

/** Writes triangles, and what else the format holds; strips in formats that do not are left out. A
 * file of that name is replaced once the new one is complete. Throws Failure. */
void WriteSurface(vtkPolyData* surface, const std::string& file, Progress& progress);
}

#endif
