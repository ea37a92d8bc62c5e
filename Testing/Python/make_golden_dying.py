# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Makes the golden files of version 1.11 with cells that die and with meshes that return, and adds them to
expected.json:

    export PYTHONPATH=build/release/lib/python3/dist-packages:Testing/IO
    Testing/Python/make_golden_dying.py FOLDER

What is expected is what the decoder written from the specification reads, and what was written. Gatun must
read the same."""

import json
import os
import sys

import numpy as np

import gatunGolden as golden
from describe_decoded import describe_decoded
from gatun import vtkGatunWriter
from gatunGolden import gm
from gatunGoldenMeshes import add, single, wave
from gatunTimeSource import TimeSource, connect
from make_golden_series import fill, lattice
from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON, VTK_WEDGE

FRONTS = (0, 0.2, 0.4, 0.3, 0, 0.4, 0.4)


def left(points, tets, front, drops, step, scale=0.0):
    alive = tets[points[tets].mean(axis=1)[:, 0] >= front * points[:, 0].max()]
    kept = np.unique(alive) if drops else np.arange(len(points))
    number = np.zeros(len(points), int)
    number[kept] = np.arange(len(kept))
    places = points[kept] * (1 + scale * step)
    return fill(gm.make_grid(single(places), number[alive]), points[kept], step)


def dying(rng):
    """Points of dead cells are dropped, but not at step 2."""
    points, tets = lattice(rng, 4)
    return [left(points, tets, front, step != 2, step) for step, front in enumerate(FRONTS)], {
        "KeepOrder": 7, "ChunkTets": 100}


def dying_small(_):
    """Of two tetrahedra one dies."""
    points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]], np.float32)
    return [gm.make_grid(points, np.array([[0, 1, 2, 3], [1, 2, 3, 4]])),
            gm.make_grid(points[:4], np.array([[0, 1, 2, 3]]))], {"KeepOrder": 7}


def dying_moving(rng):
    """Points move while cells die."""
    points, tets = lattice(rng, 3)
    return [left(points, tets, front, False, step, 0.1) for step, front in enumerate(FRONTS)], {
        "KeyStepInterval": 3, "ChunkTets": 60}


def dying_cells(rng):
    """Hexahedra and wedges, and cells that die in a mesh that is not the first."""
    points, tets = lattice(rng, 2)
    grids = [fill(gm.make_grid(single(points), tets), points, 0)]
    n = 4
    at = np.arange((n + 1) ** 3).reshape([n + 1] * 3)
    places = np.stack(np.meshgrid(*[np.arange(n + 1.0)] * 3, indexing="ij"), -1).reshape(-1, 3)
    for step, front in enumerate(FRONTS[:4], 1):
        cells = []
        for i, j, k in np.ndindex(n, n, n):
            corners = [at[i, j, k], at[i + 1, j, k], at[i + 1, j + 1, k], at[i, j + 1, k]]
            corners += [c + 1 for c in corners]
            is_wedge = j == 1
            if i >= front * n:
                cells.append((VTK_WEDGE if is_wedge else VTK_HEXAHEDRON,
                              [corners[c] for c in (0, 1, 2, 4, 5, 6)] if is_wedge else corners))
        kept = np.unique([c for cell in cells for c in cell[1]])
        number = {c: i for i, c in enumerate(kept)}
        grid = gm.make_grid(single(places[kept]), np.zeros((0, 4), int))
        grid.Allocate()
        for kind, corners in cells:
            grid.InsertNextCell(kind, len(corners), [number[c] for c in corners])
        grids.append(fill(grid, places[kept], step))
    return grids, {"KeepOrder": 7, "ChunkTets": 70}


def returning(rng):
    """The second and the third mesh return; a fourth one has much in common with the first."""
    meshes = [lattice(rng, n) for n in (3, 4, 2)]
    meshes.append((meshes[0][0], meshes[0][1][::-1].copy()))
    grids = []
    for step, which in enumerate((0, 1, 2, 1, 3, 2, 0)):
        points, tets = meshes[which]
        grid = gm.make_grid(single(points), tets)
        add(grid.GetPointData(), single(wave(points + 0.1 * step)), "wave")
        add(grid.GetCellData(), np.arange(len(tets)), "number")
        grids.append(grid)
    return grids, {"KeepOrder": 7, "ChunkTets": 100}


def returning_levels(rng):
    """With hierarchies and boundaries."""
    grids = []
    for step, n in enumerate((2, 3, 2, 3)):
        points, tets = lattice(np.random.default_rng(n), n)
        if n == 2:
            points = points + 0.5 * (step > 0)
        grids.append(fill(gm.make_grid(single(points), tets), points, step))
    return grids, {"Hierarchy": True, "WriteBoundary": True}


def main(folder):
    expected = {}
    for function in dying_small, dying, dying_moving, dying_cells, returning, returning_levels:
        grids, options = function(np.random.default_rng(8))
        times = [0.25 * i - 1 for i in range(len(grids))]
        path = os.path.join(folder, function.__name__ + ".gtn")
        writer = vtkGatunWriter()
        connect(writer, TimeSource(lambda index: grids[index], times))
        writer.SetFileName(path)
        writer.WriteAllTimeStepsOn()
        for name, value in options.items():
            getattr(writer, "Set" + name)(value)
        assert writer.Write() == 1
        with open(path, "rb") as file:
            described = describe_decoded(file.read())
        golden.assert_same(golden.describe_read(path), described, path)
        if options.get("KeepOrder") == 7:
            of_input = golden.describe_grids(grids, times, grids)
            for one, other in zip(of_input["meshes"], described["meshes"]):
                golden.assert_same(one["input_order"], other["input_order"], path)
        expected[function.__name__ + ".gtn"] = described
        print("%7d %s" % (os.path.getsize(path), path), flush=True)
    with open(os.path.join(folder, "expected.json"), "w", encoding="utf-8") as file:
        json.dump(expected, file, indent=1, sort_keys=False)
        file.write("\n")


if __name__ == "__main__":
    main(sys.argv[1])
