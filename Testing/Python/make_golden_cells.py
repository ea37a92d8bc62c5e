#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Makes the golden files of version 1.3, with cells of all types, and expected.json next to them:

    export PYTHONPATH=build/release/lib/python3/dist-packages:Testing/IO
    Testing/Python/make_golden_cells.py FOLDER

As for other golden files, what is expected is computed from the input where a file keeps the order
of its input, else by gtn_decoder, which shares no code with Gatun. That Gatun reads what was
written is checked, too.
"""

import json
import os
import sys

import numpy as np
from vtkmodules.util import vtkConstants as c
from vtkmodules.vtkCommonDataModel import VTK_POLYHEDRON

import gatunCellMeshes as meshes
import gatunGolden as golden
import gatunOrderMeshes as orders
import gatunShellMeshes as shells
from describe_decoded import describe_decoded
from gatunCells import described
from gatunGolden import gm
from gatunGoldenFiles import write

MAX_BYTES, MAX_BYTES_IN_TOTAL = 30000, 350000
ALL = {"KeepOrder": 7}
CHUNKS = {"ChunkTets": 100}


def two_cells(rng):
    """A hexahedron and, on it, a wedge; one point array."""
    points, (box, other) = meshes.cubes((1, 1, 2))
    cells = [(c.VTK_HEXAHEDRON, box), (c.VTK_WEDGE, [other[i] for i in (0, 1, 3, 4, 5, 7)])]
    grid = gm.make_grid(points.astype(np.float32), [])
    grid.Allocate(1)
    for kind, ids in cells:
        grid.InsertNextCell(kind, len(ids), ids)
    gm.add_array(grid.GetPointData(), np.arange(12, dtype=np.float32), "T")
    return grid


def steps(rng):
    """Steps of moving arrays on cells and points of several types of cells."""
    first = meshes.transition(rng, (3, 2, 2))
    grids = []
    for step in range(4):
        grid = first.NewInstance()
        grid.ShallowCopy(first)
        places = gm.coordinates(first).astype(float)
        gm.add_array(grid.GetPointData(), np.sin(places + 0.1 * step).astype(np.float32), "moving")
        number = np.arange(first.GetNumberOfCells(), dtype=np.int32)
        gm.add_array(grid.GetCellData(), number * 3 + step, "rising")
        grids.append(grid)
    return grids, [0.0, 0.5, 1.0, 4.0]


NONLINEAR_SOLIDS = (24, 25, 26, 27, 29, 31, 32, 33, 37)
NONLINEAR_SURFACES = (22, 23, 28, 30, 34)

# Functions and options by names of files.
FILES = {
    "two_cells": (two_cells, {}),
    "hexahedra": (lambda rng: meshes.hexahedra(rng, (3, 3, 3)), {}),
    "hexahedra_at_random": (
        lambda rng: meshes.hexahedra_at_random(rng, (4, 3, 3)), {**ALL, **CHUNKS}),
    "fitted": (lambda rng: meshes.hexahedra(rng, (9, 9, 9), 0.02), {"arrays": False}),
    "voxels": (lambda rng: meshes.voxels(rng, (3, 3, 3)), ALL),
    "transition": (meshes.transition, CHUNKS),
    "prisms": (lambda rng: meshes.prisms(rng, 3, 2), ALL),
    "hanging": (lambda rng: meshes.hanging(rng, (3, 2, 2)), ALL),
    "polygons": (lambda rng: meshes.polygons_in_layers(rng, 3, 2), CHUNKS),
    "large_polygons": (lambda rng: meshes.polygons_in_layers(rng, 2, 2, most=9), ALL),
    "polyhedra": (meshes.polyhedra_and_others, {**ALL, **CHUNKS}),
    "other_corners": (meshes.other_corners, ALL),
    "middles": (lambda rng: meshes.middles(rng, (2, 2, 1)), {}),
    "few_middles": (lambda rng: meshes.middles(rng, (2, 2, 1), 0.15), ALL),
    "boundary": (lambda rng: meshes.with_boundary(rng, (3, 3, 2)), CHUNKS),
    "shells": (lambda rng: meshes.shells(rng, 8), ALL),
    "degenerate": (meshes.degenerate, ALL),
    "odd_places": (meshes.odd_places, ALL),
    "one_place": (meshes.one_place, {}),
    "comb": (lambda rng: meshes.comb(rng, 28, 14), {"arrays": False}),
    "cone": (lambda rng: meshes.cone(rng, 40), {}),
    "holes": (lambda rng: meshes.holes(rng, (4, 4, 4)), CHUNKS),
    "torn": (lambda rng: meshes.torn(rng, (3, 3, 2)), {}),
    "among_many": (lambda rng: meshes.holes_among_many(
        np.random.default_rng(2261), [c.VTK_TETRA] * 3 + [c.VTK_WEDGE], (4, 3, 3), 0.95), {}),
    "linear_soup": (lambda rng: meshes.soup(rng, [*range(17), VTK_POLYHEDRON], 3, 60), ALL),
    "nonlinear_soup": (lambda rng: meshes.soup(rng, [*range(21, 38)], 3, 60), ALL),
    "other_soup": (
        lambda rng: meshes.soup(rng, [41, 52, 61, *range(68, 82), 99, 200], 2, 100), ALL),
    "two_blocks": (lambda rng: meshes.two_blocks(rng, 3), {**ALL, "ChunkTets": 64}),
    **{"solid_%d" % kind: (lambda rng, kind=kind: meshes.nonlinear(rng, kind, (2, 2, 1)), {})
       for kind in NONLINEAR_SOLIDS},
    **{"shell_%d" % kind: (lambda rng, kind=kind: meshes.quadratic_shell(rng, kind, 4), {})
       for kind in NONLINEAR_SURFACES},
    "surface_triangles": (lambda rng: shells.triangles_irregular(rng, 6), {**ALL, **CHUNKS}),
    "surface_closed": (lambda rng: shells.triangles_closed(rng, 8, 5), {}),
    "surface_quads": (lambda rng: shells.quads_irregular(rng, 2), ALL),
    "surface_polygons": (lambda rng: shells.polygons(rng, 6), ALL),
    "surface_large_polygons": (shells.large_polygons, {"arrays": False}),
    "surface_mixed": (lambda rng: shells.mixed(rng, 6, True), {**ALL, **CHUNKS}),
    "surface_pixels": (lambda rng: shells.pixels(rng, (3, 2, 2)), {}),
    "surface_nonlinear": (lambda rng: shells.nonlinear_mixed(rng, 3), ALL),
    "surface_junctions": (lambda rng: shells.junctions(rng, 4, 4), CHUNKS),
    "surface_moebius": (lambda rng: shells.moebius(rng, 10, 2), {}),
    "surface_turned": (lambda rng: shells.turned(rng, 6), ALL),
    "surface_holes": (lambda rng: shells.holes(rng, 8), CHUNKS),
    "surface_walls": (lambda rng: shells.cube_walls(rng, (2, 2, 2)), {}),
    "surface_fan": (shells.fan, {"arrays": False}),
    "surface_colliding": (shells.colliding, {"arrays": False}),
    "surface_degenerate": (lambda rng: shells.degenerate(rng, 6), ALL),
    "surface_beside_solids": (
        lambda rng: shells.beside_solids(rng, (2, 2, 2), 3), {**ALL, **CHUNKS}),
    **{"order_3_of_%d" % kind: (lambda rng, kind=kind: orders.solids(rng, kind, [3], (2, 1, 1)), {})
       for kind in (71, 72, 73)},
    "orders": (lambda rng: orders.solids(rng, 79, (4, 2, 1), (2, 2, 1)), ALL),
    **{"order_4_of_%d" % kind: (lambda rng, kind=kind: orders.shell(rng, kind, 4, 3), {})
       for kind in (76, 70)},
    "steps": (steps, {**ALL, "KeyStepInterval": 3}),
}


def make(folder, name):
    """Writes a golden file, checks it and gives its description and size."""
    path = os.path.join(folder, name + ".gtn")
    function, options = FILES[name]
    made = function(np.random.default_rng(list(name.encode())))
    grids, times = made if isinstance(made, tuple) else ([made], [])
    options = dict(options)
    if not options.pop("arrays", True):
        for grid in grids:
            grid.GetPointData().Initialize()
            grid.GetCellData().Initialize()
    write(path, grids, times, options)

    with open(path, "rb") as file:
        description = describe_decoded(file.read())
    of_input = golden.describe_grids(grids, times, grids)
    expected = dict(of_input, file_order=description["file_order"])
    if "KeepOrder" not in options:
        expected["input_order"] = description["input_order"]
        assert described(grids[0]) == described(golden.read_steps(path, True)[0][0]), path
    golden.assert_same(expected, description, path + ", decoder")
    golden.assert_same(expected, golden.describe_read(path), path + ", reader")
    return expected, os.path.getsize(path)


def main(folder):
    os.makedirs(folder, exist_ok=True)
    expected, total = {}, 0
    for name in FILES:
        expected[name + ".gtn"], size = make(folder, name)
        print("%7d %s" % (size, name), flush=True)
        assert size < MAX_BYTES, name
        total += size
    assert total < MAX_BYTES_IN_TOTAL, total
    with open(os.path.join(folder, "expected.json"), "w", encoding="utf-8") as file:
        json.dump(expected, file, indent=1, sort_keys=False)
        file.write("\n")
    print(total, "bytes")


if __name__ == "__main__":
    main(sys.argv[1])
