# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Golden files of cells of other types than tetrahedra, of surfaces, boundaries and layers.

Each function of ALL makes the file with its name; see make_golden.py."""

import numpy as np
from vtkmodules.util import vtkConstants as c
from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkCommonDataModel import VTK_POLYHEDRON, vtkUnstructuredGrid

import gatunCellMeshes as meshes
import gatunCells as gc
import gatunOrderMeshes as orders
import gatunPolyData as pd
import gatunShellMeshes as shells
from gatunGolden import gm
from gatunGoldenMeshes import add, cubes, jitter, single, wave

ALL_KEPT = {"KeepOrder": 7}
LINEAR = [1, 2, 3, 4, 5, 7, 9, 10, 12, 13, 14, 42]


def together(grids):
    """One grid of several without arrays, which are side by side; with arrays of its own."""
    result = vtkUnstructuredGrid()
    result.Allocate()
    places, first = [], 0
    for i, grid in enumerate(grids):
        points = gm.coordinates(grid).astype(np.float32)
        places.append(points + np.float32([20 * i, 0, 0]))
        for cell in range(grid.GetNumberOfCells()):
            kind = grid.GetCellType(cell)
            if kind == VTK_POLYHEDRON:
                numbers = gm.faces_of(grid, cell)
                faces, at = [numbers[0]], 1
                while at < len(numbers):
                    faces += [numbers[at], *(first + x for x in numbers[at + 1 : at + 1 + numbers[at]])]
                    at += 1 + numbers[at]
                stream = vtkIdList()
                for number in faces:
                    stream.InsertNextId(int(number))
                result.InsertNextCell(kind, stream)
            else:
                ids = vtkIdList()
                grid.GetCellPoints(cell, ids)
                numbers = [first + ids.GetId(k) for k in range(ids.GetNumberOfIds())]
                result.InsertNextCell(kind, len(numbers), numbers)
        first += len(points)
    points = np.concatenate(places)
    result.SetPoints(gm.make_grid(points, []).GetPoints())
    add(result.GetPointData(), single(wave(points)), "wave")
    add(result.GetCellData(), np.arange(result.GetNumberOfCells()), "number")
    return result


def two_cells(_):
    """A hexahedron and, on it, a wedge; one point array."""
    points, (box, other) = meshes.cubes((1, 1, 2))
    cells = [(c.VTK_HEXAHEDRON, box), (c.VTK_WEDGE, [other[i] for i in (0, 1, 3, 4, 5, 7)])]
    grid = gm.make_grid(points.astype(np.float32), [])
    grid.Allocate(1)
    for kind, ids in cells:
        grid.InsertNextCell(kind, len(ids), ids)
    add(grid.GetPointData(), np.arange(12, dtype=np.float32), "T")
    return grid, {}


def hexahedra(rng):
    return meshes.hexahedra_at_random(rng, (4, 3, 3)), {**ALL_KEPT, "ChunkSize": 100}


def fitted_hexahedra(rng):
    """Coordinates are predicted by rules that are fitted to the mesh."""
    grid = meshes.hexahedra(rng, (9, 9, 9), 0.02)
    grid.GetPointData().Initialize()
    grid.GetCellData().Initialize()
    return grid, {}


def mixed_cells(rng):
    """Hexahedra, pyramids, wedges, tetrahedra and voxels, with holes."""
    return together([
        meshes.transition(rng, (3, 2, 2)), meshes.prisms(rng, 3, 2), meshes.voxels(rng, (2, 2, 2)),
        meshes.holes(rng, (3, 3, 3)), meshes.torn(rng, (2, 2, 2))]), {
            **ALL_KEPT, "ChunkSize": 150}


def fast_cells(rng):
    """Cells of all kinds in the fast profile: rows, holes, hanging nodes, polyhedra, nonlinear and
    degenerate ones."""
    return together([
        meshes.transition(rng, (3, 2, 2)), meshes.holes(rng, (3, 3, 3)), meshes.torn(rng, (2, 2, 2)),
        meshes.polygons_in_layers(rng, 2, 2, most=9), meshes.hanging(rng, (3, 2, 2)),
        meshes.nonlinear(rng, c.VTK_QUADRATIC_HEXAHEDRON, (2, 2, 2)), meshes.degenerate(rng),
        shells.polygons(rng, 4)]), {**ALL_KEPT, "ChunkSize": 64, "Profile": 1}


def fast_cells_in_any_order(rng):
    """Cells of all types that have nothing to do with each other, in the fast profile."""
    grid, options = cells_in_any_order(rng)
    return grid, {**options, "ChunkSize": 64, "Profile": 1}


def fast_hexahedra(rng):
    """In the order of the file, whose corners are all copied or new."""
    return meshes.hexahedra(rng, (6, 5, 4), 0.02), {"Profile": 1}


def tets_and_hexahedra(rng):
    """Chunks of tetrahedra beside others."""
    return meshes.two_blocks(rng, 3), {**ALL_KEPT, "ChunkSize": 64}


def cells_around_holes(_):
    return meshes.holes_among_many(
        np.random.default_rng(2261), [c.VTK_TETRA] * 3 + [c.VTK_WEDGE], (4, 3, 3), 0.95), {}


def corners_of_polyhedra(rng):
    """Lists of points that are not those of the faces."""
    return meshes.other_corners(rng), ALL_KEPT


def polyhedra(rng):
    return meshes.polyhedra_and_others(rng), {**ALL_KEPT, "ChunkSize": 100}


def polygons_and_hanging_nodes(rng):
    return together([
        meshes.polygons_in_layers(rng, 3, 2), meshes.polygons_in_layers(rng, 2, 2, most=9),
        meshes.hanging(rng, (3, 2, 2))]), ALL_KEPT


def cells_in_any_order(rng):
    """Cells of all types that have nothing to do with each other."""
    kinds = [*range(17), *range(21, 38), 41, 42, 52, 61, *range(68, 82), 99, 200]
    return meshes.soup(rng, kinds, 3, 90), {**ALL_KEPT, "ChunkSize": 200}


def degenerate_cells(rng):
    return together([meshes.degenerate(rng), meshes.cone(rng, 30)]), ALL_KEPT


def odd_places_of_cells(rng):
    """Coordinates that are no numbers, not finite, or all the same."""
    return meshes.odd_places(rng), ALL_KEPT


def nonlinear_cells(rng):
    """Quadratic cells of dimension 3 and 2, and Lagrange and Bezier cells."""
    solids = (24, 25, 26, 27, 29, 31, 32, 33, 37)
    return together(
        [meshes.nonlinear(rng, kind, (1, 1, 2)) for kind in solids] +
        [meshes.middles(rng, (2, 1, 1)), meshes.middles(rng, (2, 1, 1), 0.15)] +
        [meshes.quadratic_shell(rng, kind, 3) for kind in (22, 23, 28, 30, 34)] +
        [shells.nonlinear_mixed(rng, 3)] +
        [orders.solids(rng, kind, [3], (1, 1, 1)) for kind in (71, 72, 73)] +
        [orders.solids(rng, 79, (4, 2, 1), (2, 1, 1))] +
        [orders.shell(rng, kind, 4, 2) for kind in (76, 70)]), {"KeepOrder": 7, "ChunkSize": 2000}


def shells_of_cells(rng):
    """Cells of dimension 2 in a grid: linear ones on a closed surface and beside solids."""
    return together([
        shells.triangles_closed(rng, 8, 5), shells.quads_irregular(rng, 2), shells.polygons(rng, 4),
        shells.mixed(rng, 5, True), shells.pixels(rng, (3, 2, 1)), shells.junctions(rng, 4, 3),
        shells.moebius(rng, 10, 2), shells.turned(rng, 5), shells.holes(rng, 6),
        shells.cube_walls(rng, (2, 2, 1)), shells.degenerate(rng, 5),
        shells.beside_solids(rng, (2, 2, 1), 3)]), {"ChunkSize": 400}


def closed_shell(rng):
    return shells.triangles_closed(rng, 8, 5), {}


def large_polygons(rng):
    grid = shells.large_polygons(rng)
    grid.GetPointData().Initialize()
    grid.GetCellData().Initialize()
    return grid, {}


def colliding_places(rng):
    """Surfaces in the same buckets of the grid of vertices."""
    grid = shells.colliding(rng)
    grid.GetPointData().Initialize()
    grid.GetCellData().Initialize()
    return grid, {}


def two_faces(_):
    surface = pd.make(np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [2, 0, 0]], np.float32),
                      Polys=[[0, 1, 2, 3], [1, 4, 2]])
    add(surface.GetPointData(), np.arange(5, dtype=np.float32), "T")
    return surface, {}


def surface(_):
    """All lists of cells, at several steps."""
    first = pd.add_arrays(pd.odd())
    made = []
    for step in range(3):
        one = first.NewInstance()
        one.ShallowCopy(first)
        add(one.GetCellData(), np.arange(one.GetNumberOfCells(), dtype=np.int32) * 3 + step, "rising")
        made.append(one)
    return made, {**ALL_KEPT, "ChunkSize": 64, "times": [0.0, 1.0, 2.5]}


def fast_surface(rng):
    made, options = surface(rng)
    return made, {**options, "Profile": 1}


def surface_in_any_order(_):
    return pd.add_arrays(pd.mixed(8)), {}


def boundary(_):
    """Of one tetrahedron."""
    grid = gm.make_grid(np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], np.float32),
                        [[0, 1, 2, 3]])
    add(grid.GetPointData(), np.arange(4, dtype=np.float32), "T")
    return grid, {"WriteBoundary": True}


def boundary_of_cells(_):
    """Of cells of all dimensions, at two steps."""
    first = gc.zoo(LINEAR, 1)
    made = []
    for step in range(2):
        grid = first.NewInstance()
        grid.ShallowCopy(first)
        add(grid.GetCellData(), np.arange(grid.GetNumberOfCells(), dtype=np.int32) + step, "number")
        made.append(grid)
    return made, {**ALL_KEPT, "WriteBoundary": True}


def two_layers(_):
    points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1],
                       [2, 0, 0], [3, 0, 0], [2, 1, 0], [2, 0, 1]], np.float32)
    grid = gm.make_grid(points, [[0, 1, 2, 3], [4, 5, 6, 7]])
    add(grid.GetPointData(), np.float32([20, 21, 24, 29, 36, 45, 56, 69]), "T")
    return grid, {"Layers": ("T", -1, 2, 1)}


def layers_of_odd_values(rng):
    """Layers of equal numbers of values, some of which are no numbers or not finite."""
    points, tets = cubes((5, 5, 5))
    grid = gm.make_grid(jitter(points, rng), tets)
    values = 0.1 * np.arange(len(points)) ** 2
    values[:40], values[::97], values[::89] = np.nan, np.inf, -np.inf
    add(grid.GetPointData(), values, "odd")
    return grid, {"Layers": ("odd", -1, 5, 3), "ChunkSize": 128}


def layers_of_lengths(rng):
    """Layers of the length of a vector, at several steps."""
    points, tets = cubes((4, 4, 4))
    points = jitter(points, rng)
    grids = []
    for s in range(3):
        grid = gm.make_grid(points, tets)
        add(grid.GetPointData(), single(np.cos(points + 0.1 * s)), "vector")
        add(grid.GetCellData(), np.arange(len(tets)) + s, "number")
        grids.append(grid)
    return grids, {**ALL_KEPT, "Layers": ("vector", -1, 6, 2), "ChunkSize": 100, "KeyStepInterval": 2}


ALL = [
    two_cells, hexahedra, fitted_hexahedra, mixed_cells, fast_cells,
    fast_cells_in_any_order, fast_hexahedra, tets_and_hexahedra, cells_around_holes,
    corners_of_polyhedra, polyhedra, polygons_and_hanging_nodes,
    cells_in_any_order, degenerate_cells, odd_places_of_cells, nonlinear_cells, shells_of_cells,
    closed_shell, large_polygons, colliding_places, two_faces, surface, fast_surface,
    surface_in_any_order, boundary,
    boundary_of_cells, two_layers, layers_of_odd_values, layers_of_lengths]
