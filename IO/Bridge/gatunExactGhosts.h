// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunExactGhosts_h
#define gatunExactGhosts_h

#include "vtkGatunIOModule.h" // For export macro

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkInformationIntegerKey;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/**
 * Key of the output information, set to 1 in RequestInformation. The executive then executes the
 * algorithm again unless the output has exactly the requested number of ghost levels.
 *
 * By default the executive accepts an output with more ghost levels, so that one consumer would get
 * the ghost cells that another one requested. This is a key rather than a custom executive so that
 * it works under any executive, and where another reader drives this one, such as ParaView's reader
 * of file series. Exported for the filters.
 */
VTKGATUNIO_EXPORT vtkInformationIntegerKey* ExactGhostLevels();
}

#endif
