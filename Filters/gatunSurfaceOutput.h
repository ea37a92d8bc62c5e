// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunSurfaceOutput_h
#define gatunSurfaceOutput_h

#include "gatunSurface.h"
#include "gatunTypes.h"

#include "vtkType.h" // For VTK_ABI_NAMESPACE_BEGIN

#include <vector>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkPolyData;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/** What a surface carries: arrays in the order in which it has those of points, and of cells. */
struct SurfaceOutput
{
  ScalarType CoordinateType = ScalarType::Float32;
  std::vector<ArrayDescription> Arrays;
  bool Normals = false;
  bool Strips = false; ///< then without arrays of cells
};

/** Makes it VTK's. */
void FillPolyData(const Surface& surface, const SurfaceOutput& content, vtkPolyData* output);
}

#endif
