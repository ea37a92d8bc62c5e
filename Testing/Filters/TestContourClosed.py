# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Isosurfaces that do not leave the mesh are closed, also where they go through its points: each side
of a triangle is that of just one other, the other way round. Genus, area and volume are those of the
sphere or the torus that the field describes."""

import numpy as np

import gatunContours as gc
import gatunMeshes as gm


def sphere(points, radius, scale=1):
    """Below 0 inside."""
    return (np.linalg.norm(points - 0.5, axis=1) - radius) * scale


def torus(points):
    x, y, z = (points - 0.5).T
    return np.hypot(np.hypot(x, y) - 0.27, z) - 0.12


def box(n, field, dtype, jitter=True):
    """With tetrahedra of both orientations, which have their fronts on the same side."""
    points, tets = gm.lattice(n, seed=4)
    tets = tets.copy()
    tets[::7] = tets[::7][:, [1, 0, 2, 3]]
    if jitter:
        points = points.astype(dtype)
    else:
        points = (np.round(points * n) / n).astype(dtype)
    grid = gm.make_grid(points, tets)
    gm.add_array(grid.GetPointData(), field(points.astype(float)).astype(dtype), "field")
    gm.add_array(grid.GetCellData(), np.arange(len(tets)), "cell")
    return grid


def sides_of(output):
    """The sides of all triangles, in the direction that they have there; each as often as the other
    way round, or there would be a crack."""
    gc.assert_whole(output)
    triangles = gc.triangles_of(output)
    assert len(triangles) > 50
    sides = np.concatenate([triangles[:, [i, (i + 1) % 3]] for i in range(3)])
    there, counts = np.unique(sides, axis=0, return_counts=True)
    back, back_counts = np.unique(sides[:, ::-1], axis=0, return_counts=True)
    np.testing.assert_array_equal(there, back)
    np.testing.assert_array_equal(counts, back_counts)
    return sides, counts


def measure(output):
    """Checks that the surface is closed; returns its Euler characteristic, area and volume."""
    sides, counts = sides_of(output)
    assert (counts == 1).all(), "two triangles have the same side"
    points, triangles = gc.points_of(output).astype(float), gc.triangles_of(output)
    corners = points[triangles]
    fronts = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    area = np.linalg.norm(fronts, axis=1).sum() / 2
    volume = (corners[:, 0] * fronts).sum() / 6
    return len(points) - len(sides) // 2 + len(triangles), area, volume


SPHERE = 2, 4 * np.pi * 0.35 ** 2, 4 / 3 * np.pi * 0.35 ** 3
TORUS = 0, 4 * np.pi ** 2 * 0.27 * 0.12, 2 * np.pi ** 2 * 0.27 * 0.12 ** 2


def check(source, expected, isovalue=0.0):
    """Within two percent of what is expected; fronts look where values are lower, which is inside,
    whatever the orientation of the tetrahedra."""
    euler, area, volume = measure(gc.contour_of(source, isovalue, "field"))
    assert euler == expected[0], euler
    assert abs(area / expected[1] - 1) < 0.02, area / expected[1]
    assert abs(-volume / expected[2] - 1) < 0.02, volume / expected[2]


def write(grid, kind, chunk):
    path = gm.temporary("closed-%s.gtn" % kind)
    gm.write(grid, path, ChunkSize=chunk, **gc.kinds_of_files("field")[kind])
    return path


for dtype in (np.float32, np.float64):
    for field, expected in ((lambda p: sphere(p, 0.35), SPHERE), (torus, TORUS)):
        grid = box(28, field, dtype)
        check(grid, expected)
        for kind in gc.kinds_of_files("field"):
            for chunk in (500, 20000):
                path = write(grid, kind, chunk)
                check(gc.open_file(path), expected)

# Through points of the mesh: whole squares of distances, each met by many points. Topology only: the
# surface may touch itself in a point, where it is still closed.
for dtype in (np.float32, np.float64):
    grid = box(16, lambda p: np.round(256 * ((p - 0.5) ** 2).sum(1)), dtype, jitter=False)
    met = 0
    path = write(grid, "spatial", 500)
    for isovalue in (9.0, 16.0, 25.0, 26.0, 36.0):
        values = gm.values_of(grid.GetPointData().GetArray("field")).view(dtype)
        met += (values == isovalue).sum()
        for source in (grid, gc.open_file(path)):
            euler, area, volume = measure(gc.contour_of(source, isovalue, "field"))
            assert euler == 2, (isovalue, euler)
            radius = np.sqrt(isovalue) / 16
            assert abs(area / (4 * np.pi * radius ** 2) - 1) < 0.1
            assert abs(abs(volume) / (4 / 3 * np.pi * radius ** 3) - 1) < 0.15
    assert met > 100

# The same with points that the way along an edge misses by a little, as the lower end is the one that
# is farther from the origin: there must be no cracks. Such a surface may touch itself along an edge.
points, tets = gm.lattice(16, seed=4, dtype=np.float64)
rng = np.random.default_rng(2)
points = (points - 0.5) * np.pi * (1 + 1e-3 * rng.random(points.shape))
steps = np.floor(20 - np.linalg.norm(points, axis=1) * 8)
low = points[tets]
missed = low[:, 0] + (low[:, 1] - low[:, 0]) != low[:, 1]
assert missed.any(1).sum() > 100
for dtype in (np.float32, np.float64):
    grid = gm.make_grid(points.astype(dtype), tets)
    gm.add_array(grid.GetPointData(), steps.astype(dtype), "field")
    path = write(grid, "spatial", 500)
    for source in (grid, gc.open_file(path)):
        for isovalue in (10.0, 12.0, 15.0):
            assert (steps == isovalue).sum() > 20
            sides_of(gc.contour_of(source, isovalue, "field"))
