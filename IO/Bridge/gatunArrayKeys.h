// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunArrayKeys_h
#define gatunArrayKeys_h

// Information keys of arrays: units, quadrature schemes and others.

#include "gatunTypes.h"

#include "vtkGatunIOModule.h" // For export macro

#include <string>
#include <vector>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkAbstractArray;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/** The keys of an array with their values, in the order of location and name. */
struct FoundKeys
{
  std::vector<ArrayKey> Keys;
  std::vector<std::string> Refused; ///< keys of types that a file cannot hold, as Location::NAME
};

/** Keys that VTK computes from the values, and requests, are left out. Exported for gtn. */
VTKGATUNIO_EXPORT FoundKeys FindKeys(vtkAbstractArray* array);

/** Gives keys to an array. Those that VTK computes, and those that it has with another type, are
 * ignored. */
void SetKeys(vtkAbstractArray* array, const std::vector<ArrayKey>& keys);
}

#endif
