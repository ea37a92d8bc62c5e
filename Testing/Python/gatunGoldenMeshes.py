# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Tetrahedra and arrays of which golden files are made."""

import numpy as np
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkFiltersCore import vtkDelaunay3D

from gatunGolden import gm


def cubes(n, split=6):
    """Points of n^3 cubes and tetrahedra, five or six a cube, in the order of the cubes."""
    nx, ny, nz = n
    axes = [np.arange(m + 1) for m in n]
    points = np.stack(np.meshgrid(*axes, indexing="ij"), -1).reshape(-1, 3).astype(float)
    tets = []
    for x, y, z in np.ndindex(nx, ny, nz):
        corner = [
            ((x + i) * (ny + 1) + y + j) * (nz + 1) + z + k
            for i in (0, 1) for j in (0, 1) for k in (0, 1)]
        if split == 6:
            for a, b in ((1, 3), (3, 2), (2, 6), (6, 4), (4, 5), (5, 1)):
                tets.append([corner[0], corner[a], corner[b], corner[7]])
        else:
            # Of two kinds, so that they fit together.
            five = [(0, 3, 5, 6), (0, 1, 3, 5), (0, 3, 2, 6), (0, 6, 4, 5), (3, 6, 5, 7)]
            if (x + y + z) % 2:
                five = [[i ^ 1 for i in (b, a, c, d)] for a, b, c, d in five]
            tets += [[corner[i] for i in tet] for tet in five]
    return points, np.array(tets)


def jitter(points, rng, amount=0.2):
    return points + rng.uniform(-amount, amount, points.shape)


def shuffle(points, tets, rng):
    """In random order, with corners turned at random."""
    order = rng.permutation(len(points))
    place = np.argsort(order)
    points, tets = points[order], place[tets[rng.permutation(len(tets))]]
    turns = np.array([[0, 1, 2, 3], [1, 2, 0, 3], [1, 0, 3, 2], [3, 2, 1, 0]])
    return points, np.take_along_axis(tets, turns[rng.integers(0, 4, len(tets))], 1)


def fan(n):
    """n tetrahedra around one edge."""
    angle = np.arange(n) * 2 * np.pi / n
    ring = np.stack([np.cos(angle), np.sin(angle), 0.1 * np.sin(3 * angle)], -1)
    points = np.concatenate([[[0, 0, -1], [0, 0, 1]], ring])
    return points, np.array([[0, 1, 2 + i, 2 + (i + 1) % n] for i in range(n)])


def delaunay(points):
    result = vtkDelaunay3D()
    result.SetTolerance(0)
    result.SetInputData(gm.make_grid(points, [[0, 1, 2, 3]]))
    result.Update()
    return gm.connectivity(result.GetOutput())


def single(points):
    return np.asarray(points, np.float32)


def wave(points):
    with np.errstate(all="ignore"):
        return np.sin(3 * points.astype(float)).sum(1)


def add(attributes, values, name, *rest, **more):
    return gm.add_array(attributes, values, name, *rest, **more)


def add_texts(grid, name, texts):
    array = vtkStringArray()
    array.SetName(name)
    for text in texts:
        array.InsertNextValue(text)
    grid.GetFieldData().AddArray(array)


def add_usual(grid):
    """Ids, something smooth, a vector, something of few values."""
    points = gm.coordinates(grid)
    tets = gm.connectivity(grid)
    add(grid.GetPointData(), np.arange(len(points), dtype=np.int32), "id")
    add(grid.GetPointData(), single(wave(points)), "wave")
    with np.errstate(all="ignore"):
        vector = np.cos(points.astype(float) * [1, 2, 3])
    add(grid.GetPointData(), single(np.round(vector, 3)), "vector")
    add(grid.GetCellData(), np.arange(len(tets), dtype=np.int64), "cell")
    add(grid.GetCellData(), (np.arange(len(tets)) // 40).astype(np.uint8), "material")
    return grid
