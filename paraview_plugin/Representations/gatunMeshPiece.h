// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunMeshPiece_h
#define gatunMeshPiece_h

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
/** Whether there are cells with an inside. */
bool HasVolume(vtkUnstructuredGrid* grid);

/**
 * The tetrahedra of the cells of a grid, without those of ghost levels, surfaces and lines. Other
 * ranks may get them: ParaView's filters do not move every polyhedron. What need not be changed is
 * not copied. Surfaces and lines stay where there is nothing else. Returns the grid itself if it
 * has errors, which the mapper reports.
 */
vtkSmartPointer<vtkUnstructuredGrid> MakeMeshPiece(vtkUnstructuredGrid* grid);
}

#endif
