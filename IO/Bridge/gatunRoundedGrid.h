// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunRoundedGrid_h
#define gatunRoundedGrid_h

#include "gatunErrorBound.h"

#include "vtkSmartPointer.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkUnstructuredGrid;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/** Returns the grid with rounded coordinates (RoundPoints), or the grid itself if nothing changes.
 * Integers stay. largest becomes the largest difference, if that is larger. */
vtkSmartPointer<vtkUnstructuredGrid> RoundGrid(
  vtkUnstructuredGrid* grid, const ErrorBound& bound, bool isWhole, double& largest);
}

#endif
