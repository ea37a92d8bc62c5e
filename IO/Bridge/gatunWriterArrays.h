// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunWriterArrays_h
#define gatunWriterArrays_h

// The arrays of a grid that a writer needs. Private to VTK::GatunIO.

#include "gatunArrayBridge.h"
#include "gatunLayers.h"

#include <string>
#include <vector>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkDataArraySelection;
class vtkUnstructuredGrid;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/** The point and cell arrays that selections enable. Arrays without a name are always included. */
std::vector<BridgedArray> BridgeSelected(
  vtkUnstructuredGrid* grid, vtkDataArraySelection* pointArrays, vtkDataArraySelection* cellArrays);

/**
 * The request for layers of a point array. component: -1 for the length of the tuple. Throws
 * Error(InvalidInput) if there is no such array or component.
 */
LayerRequest FindLayerArray(
  const std::vector<BridgedArray>& arrays, const std::string& name, int component);
}

#endif
