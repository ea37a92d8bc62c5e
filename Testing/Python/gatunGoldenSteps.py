# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Golden files of several time steps: values, points that move, meshes that change, cells that die.

Each function of ALL makes the file with its name; see make_golden.py."""

import numpy as np
from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON, VTK_WEDGE

from gatunCellMeshes import hexahedra
from gatunGolden import gm
from gatunGoldenMeshes import add, add_texts, cubes, jitter, shuffle, single, wave


def steps_mesh(rng):
    points, tets = cubes((3, 3, 3))
    return shuffle(single(jitter(points, rng)), tets, rng)


def time_steps(rng):
    """All that can change from step to step: little, much, nothing; with palettes and without."""
    points, tets = steps_mesh(rng)
    points = np.concatenate([points, single(rng.random((8, 3)))])
    noise = rng.standard_normal(len(points))
    center = points[tets].mean(1)
    cell_noise = rng.integers(-9, 9, len(tets))
    grids = []
    for s in range(7):
        grid = gm.make_grid(points, tets)
        data, cells = grid.GetPointData(), grid.GetCellData()
        add(data, single(wave(points + 0.3 * s)), "moving")
        add(data, noise + 1e-3 * s * wave(points), "drifting noise")
        add(data, noise, "constant")
        add(data, single(rng.standard_normal(len(points))), "new noise")
        add(data, single(np.round(noise * 2) if s in (2, 3) else noise + s), "sometimes few")
        add(data, (points * 100 + s * np.arange(3)).astype(np.int32), "counts")
        add(cells, (center[:, 0] * 1000 + s * s + cell_noise).astype(np.int16), "cell counts")
        add(cells, np.arange(len(tets)), "cell ids")
        add(cells, single(wave(center) * (1 + 0.01 * s)), "growing")
        add(grid.GetFieldData(), np.array([s // 2]), "index")
        add_texts(grid, "name", ["the same"])
        grids.append(grid)
    return grids, {
        "times": [-1.5, 0.0, 0.1, 0.30000000000000004, 2.0, 1e3, 1e4], "KeyStepInterval": 5, "ChunkSize": 64, "KeepOrder": 7}


def move(points, s):
    """Turns and bends; the points of step 3 are those of step 2."""
    s -= s == 3
    t = 0.1 * s
    x, y, z = points.T
    moved = np.stack((x * np.cos(t) - y * np.sin(t), x * np.sin(t) + y * np.cos(t),
                      z + 0.2 * t * np.sin(x + t)), 1)
    if s == 0:
        return points
    moved[s] = (np.nan, -0.0, np.inf)
    return moved


def moving_grids(n, kind, digits, unused=5):
    """digits: for each step, to how many digits coordinates are rounded, or None; less than 0: to
    multiples of this power of two."""
    rng = np.random.default_rng(3)
    points, tets = cubes((n, n, n))
    points, tets = shuffle(jitter(points, rng), tets, rng)
    points = np.concatenate([points, rng.random((unused, 3))])
    grids = []
    for s, count in enumerate(digits):
        places = move(points, s)
        if count is not None:
            unit = 2.0**count if count < 0 else 1
            places = np.round(places / unit, max(count, 0)) * unit
        grid = gm.make_grid(places.astype(kind), tets)
        add(grid.GetPointData(), single(wave(points + 0.05 * s)), "values")
        grids.append(grid)
    return grids


def fast_steps(rng):
    grids, options = time_steps(rng)
    return grids[:4], {**options, "times": options["times"][:4], "Profile": 1}


def fast_motion(_):
    grids = moving_grids(3, np.float32, [None, 3, None, None])
    return grids, {"ChunkSize": 64, "KeepOrder": 7, "Profile": 1}


def moving_points(_):
    """With scales at some steps, and a step at which points stay."""
    return moving_grids(3, np.float64, (-10, -10, -12, -12, -10, 3, None)), {
        "KeyStepInterval": 3, "ChunkSize": 64, "KeepOrder": 7}


def hierarchy_of_moving_points(_):
    """With a boundary."""
    return moving_grids(3, np.float32, (None,) * 4, unused=0), {
        "Hierarchy": 2, "WriteBoundary": True, "KeyStepInterval": 2, "ChunkSize": 64, "KeepOrder": 7}


def lattice(rng, n):
    points, tets = cubes((n, n, n))
    return shuffle(jitter(points, rng), tets, rng)


def fill(grid, points, step):
    add(grid.GetPointData(), single(wave(points + 0.1 * step)), "wave")
    add(grid.GetCellData(), np.arange(grid.GetNumberOfCells()) * (step + 1), "number")
    add(grid.GetFieldData(), np.array([step]), "step")
    return grid


def series_of_meshes(rng):
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
    return grids, {"KeepOrder": 7, "ChunkSize": 128}


def series_of_hierarchies(rng):
    """With hierarchies and boundaries."""
    grids = []
    for step, n in enumerate((2, 3, 2, 3)):
        points, tets = lattice(np.random.default_rng(n), n)
        if n == 2:
            points = points + 0.5 * (step > 0)
        grids.append(fill(gm.make_grid(single(points), tets), points, step))
    return grids, {"Hierarchy": 2, "WriteBoundary": True}


FRONTS = (0, 0.2, 0.4, 0.3, 0, 0.4, 0.4)


def left(points, tets, front, drops, step, scale=0.0):
    alive = tets[points[tets].mean(axis=1)[:, 0] >= front * points[:, 0].max()]
    kept = np.unique(alive) if drops else np.arange(len(points))
    number = np.zeros(len(points), int)
    number[kept] = np.arange(len(kept))
    places = points[kept] * (1 + scale * step)
    return fill(gm.make_grid(single(places), number[alive]), points[kept], step)


def deleted_cells(rng):
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
    return grids, {"KeepOrder": 7, "ChunkSize": 70}


def moving_deleted_cells(rng):
    """Points move while cells die."""
    points, tets = lattice(rng, 3)
    return [left(points, tets, front, False, step, 0.1) for step, front in enumerate(FRONTS)], {
        "KeyStepInterval": 3, "ChunkSize": 60}


def two_tets_and_one(_):
    """The smallest files of their kind: one tetrahedron, then two, of which one dies."""
    points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]], np.float32)
    one = gm.make_grid(points + np.float32(1), np.array([[0, 1, 2, 3]]))
    two = gm.make_grid(points, np.array([[0, 1, 2, 3], [1, 2, 3, 4]]))
    left_over = gm.make_grid(points[:4], np.array([[0, 1, 2, 3]]))
    return [one, two, left_over], {"KeepOrder": 7}


ALL = [
    time_steps, fast_steps, fast_motion, moving_points, hierarchy_of_moving_points, series_of_meshes,
    series_of_hierarchies, deleted_cells, moving_deleted_cells, two_tets_and_one]
