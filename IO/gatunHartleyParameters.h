// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunHartleyParameters_h
#define gatunHartleyParameters_h

#include "gatunImageEncoder.h"
#include "vtkGatunIOModule.h" // For export macro

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkGatunHartleyEncoding;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/** The properties of an encoding, for the core. */
VTKGATUNIO_EXPORT HartleyParameters GetParameters(vtkGatunHartleyEncoding* encoding);
}

#endif
