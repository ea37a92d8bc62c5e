// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunCellNodes_h
#define gatunCellNodes_h

#include "gatunCellNode.h"

#include "gatunExport.h" // For export macro

#include <cstddef>

namespace gatun
{
/** The highest order of cells whose nodes are known. */
constexpr unsigned MaxNodeOrder = 16;

/** Returns the nodes of a VTK cell type with a fixed number of points. Corners is 0 for linear
 * types and for all others. */
GATUN_EXPORT const CellNodes& GetCellNodes(int type);

/** Whether cells of a type have any order, the same in all directions: Lagrange and Bezier cells
 * except pyramids. */
GATUN_EXPORT bool HasNodeOrder(int type);

/** Returns the order of a cell of such a type with this number of points, or 0 if there is none up
 * to MaxNodeOrder. */
GATUN_EXPORT unsigned FindNodeOrder(int type, std::size_t points);

/** Returns the nodes of cells of such a type. order: 1 to MaxNodeOrder. Safe to call from several
 * threads. */
GATUN_EXPORT const CellNodes& GetNodesOfOrder(int type, unsigned order);

/** Whether the nodes of cells of a type are known, for some numbers of points. */
GATUN_EXPORT bool HasNodes(int type);

/** Returns the nodes of a cell with this number of points. Corners is 0 if they are not known. */
GATUN_EXPORT const CellNodes& FindCellNodes(int type, std::size_t points);

/** Whether FindCellNodes would find them. */
GATUN_EXPORT bool CanFindCellNodes(int type, std::size_t points);
}

#endif
