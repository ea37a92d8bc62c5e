# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Makes the golden files of version 1.12, with coordinates in the frames of gates:

    export PYTHONPATH=build/release/lib/python3/dist-packages:Testing/IO
    Testing/Python/make_golden_frames.py FOLDER

Contents are those of the input; the decoder written from the specification agrees."""

import itertools
import sys
from collections import Counter

import numpy as np

import gtn_frames
import gtn_walk
from gatunGolden import gm
from gatunGoldenFiles import make_all
from gatunGoldenMeshes import add, single, wave

TURN = np.array([[0.6, -0.8, 0], [0.224, 0.168, -0.96], [0.768, 0.576, 0.28]])


class Counted(gtn_frames.Frames):
    """Counts the vertices of all files, by the number of rules that their chunk has."""

    vertices = Counter()

    def vertex(self, record, keys):
        Counted.vertices[self.rules] += 1
        return super().vertex(record, keys)


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
    points, tets = equal_tets(rng, 6, 0.1)
    grid = gm.make_grid(single(points), tets)
    add(grid.GetPointData(), single(wave(points)), "wave")
    return grid, {"ChunkTets": 512, "KeepOrder": 7}


def frames_doubles(rng):
    points, tets = equal_tets(rng, 5, 0.1)
    return gm.make_grid(points, tets), {"KeepOrder": 7}


def frames_small(rng):
    points, tets = equal_tets(rng, 2, 0.05)
    return gm.make_grid(points, tets), {"KeepOrder": 7}


def frames_without_shape(rng):
    """Points that coincide, are on a line, far away or no numbers."""
    points, tets = equal_tets(rng, 6, 0.1)
    points[40:44] = points[40]
    points[80:90] = np.outer(np.arange(10), [1, 2, 3]) / 4
    points[120] = [np.nan, 1, -0.0]
    points[160] = [np.inf, -np.inf, 2]
    points[200] = [1e30, -1e30, 1e-40]
    return gm.make_grid(single(points), tets), {"KeepOrder": 7}


def frames_among_rules(rng):
    """A mesh of which a part is a grid."""
    points, tets = equal_tets(rng, 8, 0.13)
    cubes, parts = gm.lattice(9)
    places = np.concatenate([points, np.round(cubes * 9) + 20])
    grid = gm.make_grid(single(places), np.concatenate([tets, parts + len(points)]))
    return grid, {}


if __name__ == "__main__":
    gtn_walk.Frames = Counted
    make_all(sys.argv[1], [frames, frames_doubles, frames_small, frames_without_shape, frames_among_rules])
    print("vertices in frames by the number of rules:", Counted.vertices)
    assert len(Counted.vertices) == 2 and min(Counted.vertices.values()) > 100
