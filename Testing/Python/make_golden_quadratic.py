# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Makes the golden files of version 1.9 with streams of the mode quadratic, and adds them to
expected.json:

    export PYTHONPATH=build/release/lib/python3/dist-packages:Testing/IO
    Testing/Python/make_golden_quadratic.py FOLDER

Values are those of the input; the decoder written from the specification agrees."""

import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

import gtn_arrays
from gatunCellMeshes import hexahedra
from gatunGolden import gm
from gatunGoldenFiles import make_all
from gatunGoldenMeshes import add, cubes, jitter, shuffle, single


def mesh(rng, n=7):
    points, tets = cubes((n, n, n))
    return shuffle(jitter(points, rng), tets, rng)


def smooth(points):
    """What a quadratic function predicts better than a linear one."""
    p = np.nan_to_num(points.astype(float), nan=1, posinf=2, neginf=-2) * 0.3
    return np.sin(p[:, 0]) + np.cos(p[:, 1] - p[:, 2]) + 0.2 * p[:, 0] * p[:, 2]


def quadratic(rng):
    points, tets = mesh(rng)
    grid = gm.make_grid(single(points), tets)
    values = smooth(points)
    data = grid.GetPointData()
    add(data, single(values), "floats")
    add(data, np.round(values * 1e7).astype(np.int32), "integers")
    add(data, np.stack([values * 1e30, np.cos(values)], -1), "doubles")
    odd = single(values)
    odd[::19] = np.resize([np.nan, np.inf, -np.inf, -0.0, 1e-45, 3e38], odd[::19].shape)
    add(data, odd, "odd")
    huge = values / np.abs(values).max() * 1e308
    huge[::17] *= -1
    add(data, huge, "huge")
    add(data, np.float64([float("%.5g" % v) for v in values]), "decimals")
    return grid, {"KeepOrder": 7, "ChunkTets": 1024}


def quadratic_tets(rng):
    points, tets = mesh(rng, 5)
    grid = gm.make_grid(single(points), tets)
    at_cells = smooth(points[tets].mean(1))
    add(grid.GetCellData(), single(at_cells), "cells")
    odd_cells = at_cells.copy()
    odd_cells[::23] = np.resize([np.nan, np.inf, -1e300, 0], odd_cells[::23].shape)
    add(grid.GetCellData(), odd_cells, "odd cells")
    return grid, {"KeepOrder": 7, "ChunkTets": 512}


def quadratic_singular(rng):
    """Neighbors in planes, on lines, at one point, and at none."""
    points, tets = mesh(rng)
    values = smooth(points)
    points[points[:, 2] > 5.5, 2] = 6
    points[(points[:, 0] < 1.5) & (points[:, 2] < 4), 0] = 0.5
    line = (points[:, 1] > 5.5) & (points[:, 2] < 4)
    points[line, 0] = 3
    points[line, 1] = 6
    points[(points[:, 0] > 5.5) & (points[:, 2] < 4)] = 6.5
    points[::41, 0] = np.resize([np.nan, np.inf, -np.inf, 1e300, 1e-310], points[::41, 0].shape)
    grid = gm.make_grid(points, tets)
    add(grid.GetPointData(), single(values), "values")
    add(grid.GetPointData(), values, "doubles")
    add(grid.GetCellData(), single(values[tets].mean(1)), "cells")
    return grid, {"KeepOrder": 7}


def quadratic_steps(rng):
    points, tets = mesh(rng, 5)
    grids = []
    for s in range(4):
        grid = gm.make_grid(single(points), tets)
        values = smooth(points + 0.5 * s)
        odd = single(values)
        odd[s::31] = np.resize([np.nan, np.inf, -0.0], odd[s::31].shape)
        add(grid.GetPointData(), single(values), "values")
        add(grid.GetPointData(), odd, "odd")
        # Noise that stays, so that changes are smoother than values.
        noise = np.random.default_rng(1).normal(size=len(points))
        add(grid.GetPointData(), single(noise + smooth(points) * s), "changes")
        add(grid.GetCellData(), single(smooth(points + s)[tets].mean(1)), "cells")
        grids.append(grid)
    return grids, [float(s) for s in range(4)], {"KeyStepInterval": 3, "KeepOrder": 7}


def quadratic_cells(rng):
    grid = hexahedra(rng, (7, 7, 7), 0.2)
    points = gm.coordinates(grid)
    add(grid.GetPointData(), single(smooth(points)), "floats")
    corners = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 8)
    add(grid.GetCellData(), smooth(points[corners].mean(1)), "cells")
    return grid, {"KeepOrder": 7, "ChunkTets": 512}


ALL = [quadratic, quadratic_tets, quadratic_singular, quadratic_steps, quadratic_cells]


class Counted(gtn_arrays.ArrayStream):
    """Counts streams by their modes."""

    modes = {}

    def __init__(self, *arguments):
        super().__init__(*arguments)
        mode = (self.spatial, self.temporal)
        self.modes[mode] = self.modes.get(mode, 0) + 1


if __name__ == "__main__":
    gtn_arrays.ArrayStream = Counted
    make_all(sys.argv[1], ALL, adds=True)
    print("streams by spatial and temporal mode:", Counted.modes)
    assert (3, 0) in Counted.modes and (3, 2) in Counted.modes
