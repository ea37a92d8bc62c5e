# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Makes the golden files of version 1.10 with several meshes, and adds them to expected.json:

    export PYTHONPATH=build/release/lib/python3/dist-packages:Testing/IO
    Testing/Python/make_golden_series.py FOLDER

What is expected are the grids that were written, in their order, and in the file's order what the
decoder written from the specification reads. Gatun must read the same."""

import json
import os
import sys

import numpy as np

import gatunGolden as golden
from describe_decoded import describe_decoded
from gatun import vtkGatunWriter
from gatunCellMeshes import hexahedra
from gatunGolden import gm
from gatunGoldenMeshes import add, cubes, jitter, shuffle, single, wave
from gatunTimeSource import TimeSource, connect


def lattice(rng, n):
    points, tets = cubes((n, n, n))
    return shuffle(jitter(points, rng), tets, rng)


def fill(grid, points, step):
    add(grid.GetPointData(), single(wave(points + 0.1 * step)), "wave")
    add(grid.GetCellData(), np.arange(grid.GetNumberOfCells()) * (step + 1), "number")
    add(grid.GetFieldData(), np.array([step]), "step")
    return grid


def series(rng):
    """The first mesh returns; another one has cells of other types."""
    meshes = [lattice(rng, n) for n in (3, 4)]
    grids = []
    for step, which in enumerate((0, 0, 1, 1, 0, 2, 1)):
        if which == 2:
            grid = hexahedra(rng, (3, 3, 3))
            for data in grid.GetPointData(), grid.GetCellData():
                while data.GetNumberOfArrays():
                    data.RemoveArray(0)
            points = gm.coordinates(grid).astype(float)
        elif step == 6:  # a mesh that has ended is another one when it returns
            points, tets = meshes[1]
            grid = gm.make_grid(single(points), tets[:-1])
        else:
            points, tets = meshes[which]
            grid = gm.make_grid(single(points), tets)
        grids.append(fill(grid, points, step))
    return grids, {"KeepOrder": 7, "ChunkTets": 128}


def series_small(_):
    """One tetrahedron, and then two."""
    points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]], np.float32)
    grids = [gm.make_grid(points[:4], np.array([[0, 1, 2, 3]])),
             gm.make_grid(points, np.array([[0, 1, 2, 3], [1, 2, 3, 4]]))]
    return grids, {"KeepOrder": 7}


def series_levels(rng):
    """Meshes with hierarchies and boundaries of their own."""
    grids = []
    for step, n in enumerate((3, 4, 2)):
        points, tets = lattice(rng, n)
        grids.append(fill(gm.make_grid(points, tets), points, step))
    return grids, {"Hierarchy": True, "WriteBoundary": True}


def main(folder):
    with open(os.path.join(folder, "expected.json"), encoding="utf-8") as file:
        expected = json.load(file)
    for function in series_small, series, series_levels:
        grids, options = function(np.random.default_rng(7))
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
