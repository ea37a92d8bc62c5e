// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunGridContour_h
#define gatunGridContour_h

#include "gatunContourSettings.h"

#include <string>
#include <vector>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkPolyData;
class vtkUnstructuredGrid;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/** Makes the isosurfaces of a grid in memory. Returns warnings. Throws Error. */
std::vector<std::string> ContourGrid(vtkUnstructuredGrid* grid, const ContourSettings& settings,
  const ContourProgress& progress, vtkPolyData* output);
}

#endif
