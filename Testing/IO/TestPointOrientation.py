# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Rounded coordinates turn no cell over: orientations before and after, in exact arithmetic."""

from fractions import Fraction

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON, VTK_VOXEL, vtkCellArray

import gatunMeshes as gm
from gatun.vtk import vtkGatunWriter

path = gm.temporary("upright.gtn")
rng = np.random.default_rng(3)


def sign(points):
    a, b, c, d = ([Fraction(x) for x in p.tolist()] for p in points)
    m = [[x - y for x, y in zip(p, a)] for p in (b, c, d)]
    value = sum(
        m[0][i] * (m[1][(i + 1) % 3] * m[2][(i + 2) % 3] - m[1][(i + 2) % 3] * m[2][(i + 1) % 3])
        for i in range(3))
    return (value > 0) - (value < 0)


def signs(points, tets):
    return [sign(points[tet]) for tet in tets]


def layered(dtype, thickness, flat=()):
    """Cubes of six tetrahedra each, of which one layer is thin. flat: points put into its plane."""
    points, tets = gm.lattice(9, dtype=np.float64, permute=False)
    points = 9 * points
    level = np.round(points[:, 2])
    points[level == 3, 2] = 3
    points[level == 4, 2] = 3 + thickness * (1 + 0.3 * rng.random((level == 4).sum()))
    for i in flat:
        points[tets[i]] = points[tets[i][0]] + np.outer([0, 1, 2, 3], [0.25, 0.125, 0.5])
    return points.astype(dtype), tets


def refused(grid, **options):
    writer = vtkGatunWriter()
    errors = gm.Errors(writer)
    writer.SetInputDataObject(grid)
    writer.SetFileName(path)
    gm.set_options(writer, **options)
    assert writer.Write() == 0, options
    return str(errors)


def check(points, tets, error, **options):
    grid = gm.make_grid(points, tets)
    writer = gm.write(grid, path, KeepOrder=7, **options)
    back = gm.coordinates(gm.read(path))
    differences = np.abs(back.astype(float) - points.astype(float))
    assert differences.max() <= error, (differences.max(), error)
    assert gm.statistic(writer, "PointError") == differences.max() > 0
    assert signs(back, tets) == signs(points, tets)
    return back


# Some points of a mesh need finer steps. All others are multiples of the step.
for dtype in (np.float32, np.float64):
    points, tets = layered(dtype, 0.5)
    few = rng.choice(len(tets), 3, replace=False)
    thin = points.copy()
    for i in few:  # nearly flat: a step would turn them over
        a, b, c, d = tets[i]
        thin[d] = (thin[a] + thin[b] + thin[c]) / 3 + np.array([1e-5, 2e-5, -1e-5])
    step = 2.0 ** -10
    plain = np.round(thin.astype(float) / step) * step
    assert signs(plain, tets) != signs(thin, tets)  # the test is one
    back = check(thin, tets, step / 2, PointTolerance=(1, step / 2))
    fine = (np.mod(back.astype(float), step) != 0).any(1)
    assert 0 < fine.sum() <= 16

    # A flat tetrahedron stays flat, with its corners in one line, too.
    points, tets = layered(dtype, 0.5, flat=[5])
    assert sign(points[tets[5]]) == 0
    check(points, tets, 1e-3, PointTolerance=(1, 1e-3))

    # One that is the least bit from being flat keeps its orientation: rounding errors would hide it.
    points, tets = layered(dtype, 0.5)
    for i, toward in ((7, np.inf), (300, -np.inf)):
        a, b, c, d = tets[i]
        points[a] = np.round(points[a] * 64) / 64
        points[b] = points[a] + np.array([0.25, 0.125, 0.5], dtype)
        points[c] = points[a] + np.array([0.5, 0.375, 0.125], dtype)
        points[d] = points[b] + points[c] - points[a]
        assert sign(points[tets[i]]) == 0
        points[d, 2] = np.nextafter(points[d, 2], dtype(toward))
        assert sign(points[tets[i]]) != 0
    check(points, tets, 1e-3, PointTolerance=(1, 1e-3))

# The same by other ways to say it.
points, tets = layered(np.float64, 0.5)
side = np.ptp(points, 0).max()
check(points, tets, 1e-4 * side, PointTolerance=(2, 1e-4))
check(points, tets, side / (2**12 - 1), PointTolerance=(4, 12))

# A thin layer as a whole would turn over: an error that names one that would do.
points, tets = layered(np.float64, 1e-3)
grid = gm.make_grid(points, tets)
message = refused(grid, PointTolerance=(1, 0.01))
assert "turn over" in message and " works" in message, message
better = float(message.split("a tolerance of ")[1].split()[0])
assert 0 < better < 0.01
check(points, tets, better, PointTolerance=(1, better))

# Corners of other cells, too.
n = 6
points = gm.lattice(n, dtype=np.float64, permute=False)[0] * n
x, y, z = np.meshgrid(*[np.arange(n)] * 3, indexing="ij")
number = lambda i, j, k: (((x + i) * (n + 1) + (y + j)) * (n + 1) + z + k).ravel()
cells = np.stack([number(*at) for at in (
    (0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))], -1)
corners = [(0, 1, 3, 4), (1, 2, 0, 5), (2, 3, 1, 6), (3, 0, 2, 7),
           (4, 7, 5, 0), (5, 4, 6, 1), (6, 5, 7, 2), (7, 6, 4, 3)]
tets = cells[:, corners].reshape(-1, 4)
assert set(signs(points, tets)) == {1}
top, bottom = cells[60][4], cells[60][0]
points[top] = points[bottom] + np.array([1e-5, -2e-5, 1e-4])
before = signs(points, tets)
assert signs(np.round(points * 64) / 64, tets) != before
for kind, order in ((VTK_HEXAHEDRON, slice(None)), (VTK_VOXEL, [0, 1, 3, 2, 4, 5, 7, 6])):
    grid = gm.make_grid(points, np.zeros((0, 4), np.int64))
    array = vtkCellArray()
    array.SetData(numpy_to_vtkIdTypeArray(8 * np.arange(len(cells) + 1), deep=True),
                  numpy_to_vtkIdTypeArray(cells[:, order].ravel(), deep=True))
    grid.SetCells(kind, array)
    gm.write(grid, path, KeepOrder=7, PointTolerance=(1, 1 / 128))
    back = gm.coordinates(gm.read(path))
    assert signs(back, tets) == before and 0 < np.abs(back - points).max() <= 1 / 128

# Tolerances out of range, and of kinds that coordinates do not have.
nan, inf = float("nan"), float("inf")
for kind, values in {1: (0, -0.1, nan, inf), 2: (0, 1, -0.1, nan), 3: (0.1,), 4: (0, 32, 2.5, nan),
                     5: (1,), 257: (1e-9,), -1: (1e-9,), -255: (1e-9,)}.items():
    for value in values:
        refused(grid, PointTolerance=(kind, value))
