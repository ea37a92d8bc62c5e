# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Golden files of tetrahedra: connectivity, coordinates, frames and the original order.

Each function of ALL makes the file with its name. It takes a random number generator and returns a
grid and options of the writer; see make_golden.py."""

import itertools

import numpy as np

from gatunGolden import gm
from gatunGoldenMeshes import add, add_usual, cubes, delaunay, jitter, shuffle, single, wave


def one_tet(rng):
    grid = gm.make_grid(single([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]), [[0, 1, 2, 3]], False)
    add(grid.GetPointData(), single([20, 21, 22, 24]), "T")
    grid.GetPointData().SetActiveScalars("T")
    return grid, {}


def empty(rng):
    return gm.make_grid(np.zeros((0, 3), np.float32), []), {"KeepOrder": 7}


def only_points(rng):
    points = rng.random((20, 3))
    grid = gm.make_grid(points, [])
    add(grid.GetPointData(), wave(points), "wave")
    return grid, {"KeepOrder": 7}


def chunks(rng):
    points, tets = cubes((4, 4, 4))
    points, tets = shuffle(single(jitter(points, rng)), tets, rng)
    return add_usual(gm.make_grid(points, tets)), {"ChunkSize": 64}


def original_order(rng):
    points, tets = cubes((4, 4, 3))
    points, tets = shuffle(jitter(points, rng), tets, rng)
    return add_usual(gm.make_grid(points, tets)), {"ChunkSize": 100, "KeepOrder": 7}


def fast(rng):
    points, tets = cubes((4, 4, 3))
    points, tets = shuffle(single(jitter(points, rng)), tets, rng)
    return add_usual(gm.make_grid(points, tets)), {"ChunkSize": 100, "KeepOrder": 7, "Profile": 1}


def fast_flips(rng):
    """Some tetrahedra are mirrored, two have a point twice, and one has another's points."""
    points = rng.random((60, 3))
    tets = delaunay(points)
    tets = np.concatenate([tets, tets[:1], tets[:2, [0, 1, 2, 2]]])
    mirrored = rng.random(len(tets)) < 0.3
    tets[mirrored] = tets[mirrored][:, [0, 1, 3, 2]]
    return add_usual(gm.make_grid(points, tets)), {"KeepOrder": 7, "Profile": 1}


def point_order(rng):
    points, tets = cubes((3, 3, 3))
    return add_usual(gm.make_grid(single(jitter(points, rng)), tets)), {"KeepOrder": 1}


def cell_order(rng):
    points, tets = cubes((3, 3, 3))
    return add_usual(gm.make_grid(single(jitter(points, rng)), tets)), {"KeepOrder": 2}


def corner_order(rng):
    points, tets = cubes((3, 3, 2))
    points[:, 2] = 0
    return gm.make_grid(single(points), tets), {"KeepOrder": 4}


def unused_points(rng):
    points, tets = cubes((3, 3, 3))
    more = rng.random((30, 3))
    points = single(np.concatenate([more[:10], points, more[10:]]))
    return add_usual(gm.make_grid(points, tets + 10)), {"KeepOrder": 7, "ChunkSize": 64}


def odd_coordinates(rng):
    points, tets = cubes((4, 3, 3))
    points = jitter(points, rng) * 1e-3
    flat = points.reshape(-1)
    strewn = rng.choice(flat.size, 24, replace=False)
    flat[strewn] = [np.nan, np.inf, -np.inf, -0.0, 1e308, 5e-324] * 4
    flat.view(np.uint64)[strewn[::6]] = 0x7FF8000000000000 + np.arange(4, dtype=np.uint64)
    flat.view(np.uint64)[strewn[12]] = 0xFFF0000000000001
    return add_usual(gm.make_grid(points, tets)), {"KeepOrder": 7, "ChunkSize": 120}


def any_tets(rng):
    points = single(rng.random((40, 3)))
    tets = rng.integers(0, 40, (300, 4))
    tets = np.concatenate([tets, tets[:20], tets[20:40, ::-1], np.zeros((2, 4), int)])
    return add_usual(gm.make_grid(points, tets)), {"ChunkSize": 64, "KeepOrder": 7}


def holes(rng):
    points, tets = cubes((6, 6, 6))
    tets = tets[rng.random(len(tets)) < 0.5]
    points = single(np.round(jitter(points, rng), 2))
    return gm.make_grid(*shuffle(points, tets, rng)), {"ChunkSize": 200}


def many_neighbors(rng):
    """More than 64 chunks that meet in one point."""
    points, tets = cubes((2, 2, 220), 5)
    tets[::17, 3] = len(points)
    points = np.concatenate([points, [[9, 9, 30]]])
    return gm.make_grid(single(points), tets), {"ChunkSize": 64}


def around_a_point(sizes, rng):
    """Cones over rings of triangles, all with one apex: the walk meets itself behind each of them
    and turns around the apex for long."""
    points, tets = [[0, 0, 0]], []
    for n, m in sizes:
        first = len(points)
        for i, j in np.ndindex(n, m):
            a, b = 2 * np.pi * i / n, 2 * np.pi * j / m
            r = 20 + n * np.cos(a)
            points.append([r * np.cos(b), r * np.sin(b), n * np.sin(a) + 40])
            corners = [first + (i + k) % n * m + (j + l) % m for k in (0, 1) for l in (0, 1)]
            for triangle in ((0, 1, 3), (0, 3, 2)):
                if rng.random() < 0.985:
                    tets.append([0] + [corners[k] for k in triangle])
    points = np.round(jitter(np.array(points), rng))
    return gm.make_grid(*shuffle(single(points), np.array(tets), rng)), {}


def turns_32(_):
    return around_a_point([(15, 23)], np.random.default_rng(21))


def turns_33(_):
    return around_a_point([(15, 23)], np.random.default_rng(74))


def one_place(rng):
    """No extent, so no lattice; and points that are nowhere."""
    points = np.full((12, 3), 7.5)
    points[10:] = np.nan
    tets = rng.integers(0, 12, (30, 4))
    return gm.make_grid(single(points), tets), {"KeepOrder": 2}


def searches(n, fan, y, z, rng):
    """Two chunks that share n points, and long edges: searches that end early, some of which find
    something, near y and z."""
    points = np.round(rng.random((n, 3)), 2)
    hubs = np.array([[x, y + dy, z] for x in (-2, 3) for dy in (-0.5, 0.5)])
    tets = []
    for a in (n, n + 2):
        near = hubs[a - n : a - n + 2].mean(0) * 0.7 + 0.3 * np.array([0.5, y, z])
        order = ((points - near) ** 2).sum(1).argsort()
        order[:fan] = order[:fan].reshape(-1, 4)[:, rng.permutation(4)].ravel()
        tets += [[a, a + 1, order[i], order[i - 1]] for i in range(1, fan)]
        tets += [[a, *order[i : i + 3]] for i in range(fan - 1, n - 3, 3)]
    points = single(np.concatenate([points, hubs]))
    return gm.make_grid(points, tets), {"ChunkSize": len(tets) // 2}


def searches_that_end(_):
    """The next four points that a search would look at are among the best."""
    return searches(2100, 120, 0.45, 0.03, np.random.default_rng(3))


def equal_ranks(_):
    """Shared points on a regular grid, many at the same distance from a gate: the order of the
    search counts. The grid has 15 units along its longest side, as 65535 is a multiple of that."""
    steps = [np.arange(8), np.arange(0, 16, 3), np.arange(0, 16, 3)]
    points = np.stack(np.meshgrid(*steps, indexing="ij"), -1).reshape(-1, 3)
    hubs = np.array([[-5, 6, 6], [-5, 9, 9], [10, 6, 6], [10, 9, 9]])
    rng = np.random.default_rng(1)
    n = len(points)
    tets = []
    for a in (n, n + 2):
        middle = hubs[a - n : a - n + 2].mean(0)
        order = (((points - middle) ** 2).sum(1) + rng.random(n)).argsort()
        tets += [[a, a + 1, order[i], order[i - 1]] for i in range(n)]
    return gm.make_grid(single(np.concatenate([points, hubs])), tets), {"ChunkSize": n}


CORNERS = np.stack(np.meshgrid([0, 65535], [0, 65535], [0, 65535]), -1).reshape(-1, 3)


def needles(_):
    """A Delaunay mesh of which some faces are made nearly a line, or just that: large circles."""
    rng = np.random.default_rng(1)
    points = single(np.concatenate([rng.uniform(0, 65535, (120, 3)), CORNERS]))
    points = np.floor(points / 64) * 64
    tets = delaunay(points)
    for a, b, c in tets[rng.permutation(len(tets))[:25], :3]:
        points[c] = (points[a] + points[b]) / 2 + rng.choice([0, 16]) * rng.integers(-1, 2, 3)
    return gm.make_grid(*shuffle(points, tets, rng)), {}


TURN = np.array([[0.6, -0.8, 0], [0.224, 0.168, -0.96], [0.768, 0.576, 0.28]])


def equal_tets(rng, n, jitter):
    """Tetrahedra of equal shape: an edge of a cube, and the centers on both sides of a face at it."""
    corners = np.array(list(itertools.product(range(n + 1), repeat=3)), float)
    centers = np.array(list(itertools.product(range(n), repeat=3)), float) + 0.5
    points = np.concatenate([corners, centers])

    def corner(place):
        return (place[0] * (n + 1) + place[1]) * (n + 1) + place[2]

    def center(place):
        return len(corners) + (place[0] * n + place[1]) * n + place[2]

    tets = []
    units = np.eye(3, dtype=int)
    for cube in itertools.product(range(n), repeat=3):
        for axis in range(3):
            behind = cube + units[axis]
            if behind[axis] == n:
                continue
            u, v = units[(axis + 1) % 3], units[(axis + 2) % 3]
            around = [behind, behind + u, behind + u + v, behind + v]
            for k in range(4):
                tets.append([corner(around[k]), corner(around[(k + 1) % 4]), center(cube), center(behind)])
    points += rng.uniform(-jitter, jitter, points.shape)
    tets = np.array(tets)
    used, tets = np.unique(tets, return_inverse=True)
    return points[used] @ TURN.T, tets.reshape(-1, 4)


def frames(rng):
    """A mesh of which a part is a grid. Some points coincide, are on a line, far away or no numbers."""
    points, tets = equal_tets(rng, 8, 0.13)
    lattice, parts = gm.lattice(9)
    points[40:44] = points[40]
    points[80:90] = np.outer(np.arange(10), [1, 2, 3]) / 4
    points[120] = [np.nan, 1, -0.0]
    points[160] = [np.inf, -np.inf, 2]
    points[200] = [1e30, -1e30, 1e-40]
    places = np.concatenate([points, np.round(lattice * 9) + 20])
    return gm.make_grid(single(places), np.concatenate([tets, parts + len(points)])), {}


ALL = [
    one_tet, empty, only_points, chunks, original_order, fast, fast_flips, point_order, cell_order, corner_order,
    unused_points, odd_coordinates, any_tets, holes, many_neighbors, turns_32, turns_33, one_place,
    searches_that_end, equal_ranks, needles, frames]
