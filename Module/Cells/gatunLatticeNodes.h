// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunLatticeNodes_h
#define gatunLatticeNodes_h

#include "gatunCellNode.h"

#include <cstddef>
#include <cstdint>

namespace gatun
{
/** The shapes of cells whose points are a lattice, as those of Lagrange and Bezier cells are. */
enum class LatticeShape : std::uint8_t
{
  Curve,
  Triangle,
  Quad,
  Tetra,
  Hexahedron,
  Wedge
};

/** Returns the number of points of a lattice with order + 1 points along each edge. */
std::size_t CountLatticePoints(LatticeShape shape, unsigned order);

/** Returns the nodes of a lattice, in VTK's numbers of points. */
CellNodes MakeLatticeNodes(LatticeShape shape, unsigned order);
}

#endif
