// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnObj_h
#define gtnObj_h

#include "vtkSmartPointer.h"

#include <string>

class vtkPolyData;

namespace gtn
{
class Progress;

/** The points and faces of a Wavefront .obj file; nothing else is read. Throws Failure, which names
 * the line, for any content of the file, and Interrupted.
 *
 * Not by vtkOBJReader: it follows indices that do not exist, and splits points where a texture has
 * a seam, so that a closed surface is no longer closed. */
vtkSmartPointer<vtkPolyData> ReadObj(const std::string& file, Progress& progress);
}

#endif
