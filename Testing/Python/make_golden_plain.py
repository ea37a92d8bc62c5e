# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Makes the golden files of version 1.10 with streams of the mode plain quadratic, and adds them to
expected.json:

    export PYTHONPATH=build/release/lib/python3/dist-packages:Testing/IO
    Testing/Python/make_golden_plain.py FOLDER

Values are those of the input; the decoder written from the specification agrees."""

import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

import gtn_arrays
import make_golden_bounded
from gatunCellMeshes import hexahedra
from gatunGolden import gm
from gatunGoldenFiles import make_all
from gatunGoldenMeshes import add, single
from make_golden_quadratic import Counted, mesh


def quadric(points):
    """What a quadratic function predicts but for rounding."""
    x, y, z = points.T.astype(float)
    return 0.3 * x * x - 0.2 * x * y + 0.1 * y * z + 0.4 * z * z - x + 2 * y + 5


def changing(rng):
    """At some steps: the number of the step, a grid, its points and tetrahedra, and values on points. They
    have noise that stays, so that changes are smoother than values."""
    points, tets = mesh(rng, 4)
    noise = np.random.default_rng(1).normal(size=len(points))
    for s in range(4):
        yield s, gm.make_grid(single(points), tets), points, tets, noise + quadric(points) * s / 8


def with_odd(values, s, odd):
    values = values.copy()
    values[s::31] = np.resize(odd, values[s::31].shape)
    return values


def plain_steps(rng):
    grids = []
    for s, grid, points, tets, values in changing(rng):
        data = grid.GetPointData()
        add(data, single(values), "floats")
        add(data, with_odd(single(values), s, [np.nan, np.inf, -0.0]), "odd")
        add(data, np.round(1e6 * values).astype(np.int32), "integers")
        add(data, values * (1e307 if s == 2 else 1e300), "huge")
        at_cells = np.random.default_rng(2).normal(size=len(tets)) + quadric(points[tets].mean(1)) * s / 8
        add(grid.GetCellData(), single(at_cells), "cells")
        grids.append(grid)
    return grids, [float(s) for s in range(4)], {"KeyStepInterval": 3, "KeepOrder": 7, "ChunkTets": 256}


def plain_hexahedra(rng):
    grids = []
    grid = hexahedra(rng, (6, 6, 6), 0.2)
    points = gm.coordinates(grid)
    corners = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 8)
    noise, noise_of_cells = (np.random.default_rng(k).normal(size=n) for k, n in enumerate((len(points), len(corners))))
    for s in range(3):
        step = type(grid)()
        step.CopyStructure(grid)
        add(step.GetPointData(), single(noise + s * quadric(points)), "floats")
        add(step.GetCellData(), single(noise_of_cells + s * quadric(points[corners].mean(1))), "cells")
        grids.append(step)
    return grids, [0.0, 1.0, 2.0], {"KeepOrder": 7, "ChunkTets": 256}


def bounded_plain_steps(rng):
    grids = []
    for s, grid, _, _, values in changing(rng):
        add(grid.GetPointData(), values, "doubles")
        add(grid.GetPointData(), with_odd(values, s, [np.nan, np.inf, 1e300]), "odd")
        add(grid.GetPointData(), single(values), "pointwise")
        grids.append(grid)
    return grids, [0.0, 1.0, 2.0, 3.0], ["*=abs:1e-9", "pointwise=pw:1e-6"], {"KeyStepInterval": 3}


if __name__ == "__main__":
    gtn_arrays.ArrayStream = Counted
    make_all(sys.argv[1], [plain_steps, plain_hexahedra], adds=True)
    make_golden_bounded.main(sys.argv[1], [bounded_plain_steps])
    print("streams by spatial and temporal mode:", Counted.modes)
    assert (4, 2) in Counted.modes
