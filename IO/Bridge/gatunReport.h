// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunReport_h
#define gatunReport_h

#include "gatunErrorCodes.h"
#include "vtkGatunIOModule.h" // For export macro

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkDataObject;
class vtkObject;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/**
 * Reports a failure by vtkErrorMacro, unless it is an abort, and empties an output (may be null).
 * Never throws, even if memory is exhausted; the error code, which the caller sets before, then
 * stands alone.
 */
VTKGATUNIO_EXPORT void ReportFailure(
  vtkObject* self, const VTKFailure& failure, vtkDataObject* output) noexcept;
}

#endif
