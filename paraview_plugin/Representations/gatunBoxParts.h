// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunBoxParts_h
#define gatunBoxParts_h

#include "vtkType.h" // For VTK_ABI_NAMESPACE_BEGIN

#include <vector>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkBoundingBox;
class vtkMatrix4x4;
class vtkPlaneCollection;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/** The bounds of a box that was moved; not valid if the box is not. */
vtkBoundingBox MoveBox(const vtkBoundingBox& box, vtkMatrix4x4* matrix);

/**
 * A box cut across its longest edge, and its parts again, into as many parts as there are. Seen
 * from anywhere there is an order in which no part hides one that comes before it.
 */
std::vector<vtkBoundingBox> SplitBox(const vtkBoundingBox& box, int parts);

/** The planes that part one box from the rest of another: what is on a plane is on one side of it,
 * exactly. */
void AddCuts(const vtkBoundingBox& part, const vtkBoundingBox& whole, vtkPlaneCollection* planes);
}

#endif
