// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef benchMeshes_h
#define benchMeshes_h

// Meshes to measure with, the same on every machine (but for the Delaunay mesh, which is as the
// TetGen at hand makes it).

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <array>
#include <string>
#include <vector>

class vtkUnstructuredGrid;

namespace bench
{
using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

/**
 * Hexahedra of a structured grid that bends around a nose and grows finer towards it, as flow
 * solvers have it, five tetrahedra each. Float points; Density, and with allArrays also Momentum
 * (3), Energy and Pressure: a bow shock, waves, and noise of the size of rounding errors of a
 * solver (1e-6 of the value).
 */
Grid MakeFlow(const std::array<int, 3>& cells, bool allArrays);

/**
 * A mesh at a time step, at which waves have moved on, and points, too, if moves. A mesh with all
 * arrays of MakeFlow has them with noise. Others have one array without: a warm place that wanders
 * and a wave.
 */
Grid MakeStep(vtkUnstructuredGrid* grid, int step, bool moves);

/** The hexahedra themselves; Density. */
Grid MakeHexahedra(const std::array<int, 3>& cells);

/** Hexahedra, wedges, pyramids, tetrahedra, and polyhedra of eight faces; Density. */
Grid MakeMixed(const std::array<int, 3>& cells);

/** A jittered body-centered lattice of cells^3 cubes, about twelve tetrahedra each; Density. */
Grid MakeLattice(int cells, bool doublePoints);

/** A ball of about so many tetrahedra by TetGen, of good quality; Density without noise. */
Grid MakeDelaunay(int tets);
bool HasDelaunay();

using Tet = std::array<vtkIdType, 4>;

void SetTets(vtkUnstructuredGrid* grid, const std::vector<Tet>& tets);

/** The same mesh with points and tetrahedra in random order, always the same one. */
Grid Permute(vtkUnstructuredGrid* grid);

/** The same mesh with its points along a Morton curve, and its tetrahedra by their first point
 * there: the order that suits a cache best. */
Grid SortAlongCurve(vtkUnstructuredGrid* grid);

/** Tetrahedra of whatever cells there are. */
Grid Triangulate(vtkUnstructuredGrid* grid);

/** The grid with one point array only. */
Grid KeepPointArray(vtkUnstructuredGrid* grid, const std::string& name);
}

#endif
