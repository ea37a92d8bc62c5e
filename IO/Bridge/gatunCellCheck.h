// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunCellCheck_h
#define gatunCellCheck_h

#include "vtkGatunIOModule.h" // For export macro
#include "vtkType.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkCellArray;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/**
 * Whether cells are what their arrays say: VTK does not look, neither when it reads a file nor when
 * it follows the ids. Each throws gatun::Error (InvalidInput). Exported for the gtn program.
 */
///@{
/** Offsets begin with 0, never fall, and end within the connectivity. */
VTKGATUNIO_EXPORT void CheckOffsets(vtkCellArray* cells);

/** All ids are those of points. */
VTKGATUNIO_EXPORT void CheckPointIds(vtkCellArray* cells, vtkIdType points);
///@}
}

#endif
