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
 * The cells of a grid that can be drawn as a volume: not those of ghost levels, nor surfaces and
 * lines if there are cells with an inside. What need not be changed is not copied.
 */
vtkSmartPointer<vtkUnstructuredGrid> MakeMeshPiece(vtkUnstructuredGrid* grid);
}

#endif
