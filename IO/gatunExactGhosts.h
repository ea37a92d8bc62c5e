// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunExactGhosts_h
#define gatunExactGhosts_h

#include "vtkGatunIOModule.h" // For export macro

class vtkInformationIntegerKey;

namespace gatun
{
/**
 * Key for output information, set to 1 in RequestInformation: what the port holds is only good
 * enough if it has exactly as many ghost levels as are asked for.
 *
 * By itself the executive also takes more for good enough, so that a consumer would get ghost cells
 * that another one had asked for. The key is in the port's information, not in an executive of
 * ours, so that it holds under every executive and where another reader drives this one, as
 * ParaView's reader of file series does. Exported for the filters.
 */
VTKGATUNIO_EXPORT vtkInformationIntegerKey* ExactGhostLevels();
}

#endif
