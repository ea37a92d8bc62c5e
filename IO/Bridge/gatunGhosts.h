// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunGhosts_h
#define gatunGhosts_h

#include "vtkGatunIOModule.h" // For export macro
#include "vtkType.h"          // For VTK_ABI_NAMESPACE_BEGIN

#include <cstddef>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkDataSetAttributes;
class vtkUnsignedCharArray;
class vtkUnstructuredGrid;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/** Returns the array vtkGhostType if any of its values has the given bit, otherwise nullptr.
 * Exported for the filters. */
VTKGATUNIO_EXPORT vtkUnsignedCharArray* GhostsWith(
  vtkDataSetAttributes* attributes, unsigned char bit);

/** The number of cells of a grid that are marked as ghost cells (DUPLICATECELL). Exported for gtn.
 */
VTKGATUNIO_EXPORT std::size_t CountGhosts(vtkDataSetAttributes* cellData);

/** Clears a bit in all values of vtkGhostType in place; removes the array if no bit remains. */
void ClearGhosts(vtkDataSetAttributes* attributes, unsigned char bit);

/** Clears the marks of duplicate cells and points of a grid whose ghost cells were removed. Arrays
 * that other grids may have are copied first. */
void ClearGhosts(vtkUnstructuredGrid* grid);
}

#endif
