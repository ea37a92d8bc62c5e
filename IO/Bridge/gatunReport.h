// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunReport_h
#define gatunReport_h

#include "gatunErrorCodes.h"
#include "vtkGatunIOModule.h" // For export macro

class vtkDataObject;
class vtkObject;

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
