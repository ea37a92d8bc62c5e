// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnMeshio_h
#define gtnMeshio_h

// Formats that Python's meshio reads, in a process of its own.

#include "vtkSmartPointer.h"

#include <string>

class vtkAlgorithm;

namespace gtn
{
/** Whether a file has an extension of such a format. */
bool IsMeshioFile(const std::string& file);

/** Has meshio read a file, and makes a reader of the result: points, cells, arrays, sets as arrays
 * of 0 and 1 with their names, and the groups of field data as arrays of field data. Throws Failure
 * with a hint if there is no python3 or no meshio, and Interrupted. */
vtkSmartPointer<vtkAlgorithm> MakeMeshioReader(const std::string& file);
}

#endif
