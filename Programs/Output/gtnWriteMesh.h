// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnWriteMesh_h
#define gtnWriteMesh_h

#include "gtnGridWriter.h"

#include <string>

class vtkUnstructuredGrid;

namespace gtn
{
struct Settings;

/** The formats that WriteMesh writes, for help texts. */
extern const char* const MeshFormats;

/** Throws UsageError unless the name ends in one of these. */
void CheckMeshName(const std::string& file);

/** Writes a .gtn, .vtu or .vtk file, with a progress bar, and says what it is. The compressor is
 * that of a .vtu file. Throws Failure. */
void WriteMesh(vtkUnstructuredGrid* grid, const std::string& file, const Settings& settings,
  Compressor compressor = Compressor::ZLib);
}

#endif
