// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunHartleyTransfer_h
#define gatunHartleyTransfer_h

#include "gatunHartleyShading.h"
#include "gatunTypes.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkPiecewiseFunction;
class vtkScalarsToColors;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/** VTK's transfer functions. Null: a linear ramp over the range, from black to white or from 0
 * to 1. */
struct TransferFunctions
{
  vtkScalarsToColors* Colors = nullptr;
  vtkPiecewiseFunction* Opacity = nullptr;
  double UnitDistance = 1; ///< the length of a ray that has the opacity of Opacity, above 0
};

/** Tabulates transfer functions over the range of a volume, for samples of a given length. */
void FillHartleyTable(const TransferFunctions& functions, const Range& range, double sampleDistance,
  HartleyShading& shading);
}

#endif
