// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunHartleyTransfer_h
#define gatunHartleyTransfer_h

#include "gatunHartleyShading.h"
#include "gatunTypes.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkVolumeProperty;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/**
 * Tabulates the transfer functions of a property over the range of a volume, for samples of a given
 * length. Null: ramps over the range, from black to white and from 0 to 1 for a ray of the default
 * unit length. Throws InvalidInput for a unit distance that is not above 0.
 */
void FillHartleyTable(vtkVolumeProperty* property, double defaultUnit, const Range& range,
  double sampleDistance, HartleyShading& shading);
}

#endif
