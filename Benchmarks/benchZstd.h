// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef benchZstd_h
#define benchZstd_h

// A peer like the .pv files of pyvista-zstd: the raw arrays of a grid, compressed by zstd at level
// 3, in blocks so that threads can share them.

#include "benchMeshes.h"

#include <string>

namespace bench
{
/** shuffle: the first bytes of all values of a block come first, then the second ones, and so on.
 */
void WriteZstd(vtkUnstructuredGrid* grid, const std::string& file, bool shuffle);

/** Decompresses the arrays straight to where VTK has them. Throws Failure. */
Grid LoadZstd(const std::string& file);
}

#endif
