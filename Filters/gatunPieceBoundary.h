// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPieceBoundary_h
#define gatunPieceBoundary_h

#include "vtkType.h" // For VTK_ABI_NAMESPACE_BEGIN

#include <cstdint>
#include <vector>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkUnstructuredGrid;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
class ProcessExchange;

/**
 * Marks the points of a piece that other pieces have, too: those at the places of points on the
 * boundaries of the pieces of other processes. All processes must call it. Each sends the boundary
 * of its piece to those whose boxes overlap that of its own.
 *
 * tets: the piece without ghost cells; of tetrahedra.
 */
std::vector<std::uint8_t> FindCommonPoints(vtkUnstructuredGrid* tets, ProcessExchange& exchange);

/**
 * The same without communication: marks the points at the places of points of ghost cells or, if
 * there are none, all points of the boundary.
 *
 * input: the piece with its ghost cells.
 */
std::vector<std::uint8_t> FindCommonPoints(vtkUnstructuredGrid* tets, vtkUnstructuredGrid* input);
}

#endif
