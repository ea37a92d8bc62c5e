// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunGhosts_h
#define gatunGhosts_h

#include "vtkType.h" // For VTK_ABI_NAMESPACE_BEGIN

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkDataSetAttributes;
class vtkUnsignedCharArray;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/** The array vtkGhostType, if any of its flags has this bit, else nullptr. */
vtkUnsignedCharArray* GhostsWith(vtkDataSetAttributes* attributes, unsigned char bit);

/** Takes a bit out of all flags of vtkGhostType, in place, and the array away if none is left. */
void ClearGhosts(vtkDataSetAttributes* attributes, unsigned char bit);
}

#endif
