# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Meshes of every kind, odd ones included, come back bit for bit."""

import itertools

import numpy as np

import gatunMeshes as gm


def with_ids(points, tets, wide=True):
    """A grid that tells apart all points and cells by data, so that none can be mixed up."""
    grid = gm.make_grid(points, tets, wide)
    gm.add_array(grid.GetPointData(), np.arange(len(points), dtype=np.int32), "point")
    gm.add_array(grid.GetCellData(), np.arange(len(tets), dtype=np.int32), "cell")
    return grid


def check(points, tets, wide=True):
    points, tets = np.asarray(points), np.asarray(tets, np.int64).reshape(-1, 4)
    for chunk in (0, 64):
        for dtype in (np.float32, np.float64):
            with np.errstate(over="ignore"):
                bits = points if points.dtype == dtype else points.astype(dtype)
            grid = with_ids(bits, tets, wide)
            gm.assert_equal(grid, gm.round_trip(grid, "mesh.gtn", KeepOrder=7, ChunkSize=chunk))
            back = gm.round_trip(grid, "mesh.gtn", ChunkSize=chunk)
            gm.assert_same_mesh(grid, back)
            for keep in (1, 2, 3, 4, 5, 6):
                back = gm.round_trip(grid, "mesh.gtn", KeepOrder=keep, ChunkSize=chunk)
                gm.assert_same_mesh(grid, back)
                if keep & 1:
                    ids = back.GetPointData().GetArray("point")
                    assert np.array_equal(gm.values_of(ids).ravel(), np.arange(len(points)))
                if keep & 2:
                    ids = back.GetCellData().GetArray("cell")
                    assert np.array_equal(gm.values_of(ids).ravel(), np.arange(len(tets)))


rng = np.random.default_rng(3)
points, tets = gm.lattice(5)
check(points, tets)
check(points, tets, wide=False)

# Far from the origin, hence few distinct values; huge and tiny.
check(points + np.float32(1e6), tets)
check(points.astype(np.float64) * 1e300, tets)
check(points.astype(np.float64) * 1e-310, tets)

# Coordinates that are no numbers, with payloads, infinite, or minus zero.
odd = points.copy()
flat = odd.reshape(-1)
strewn = rng.choice(flat.size, 60, replace=False)
flat[strewn[:20]] = [np.nan, np.inf, -np.inf, -0.0] * 5
flat.view(np.uint32)[strewn[20:40]] = 0x7FC00000 + np.arange(20, dtype=np.uint32)
flat.view(np.uint32)[strewn[40:]] = 0xFF800001 + np.arange(20, dtype=np.uint32)
grid = with_ids(odd, tets)
for chunk in (0, 64):
    gm.assert_equal(grid, gm.round_trip(grid, "mesh.gtn", KeepOrder=7, ChunkSize=chunk))
    gm.assert_same_mesh(grid, gm.round_trip(grid, "mesh.gtn", ChunkSize=chunk))
check(np.full((30, 3), np.nan), rng.integers(0, 30, (50, 4)))

# Duplicate and unused points.
check(np.concatenate([points, points]), np.concatenate([tets, tets + len(points)]))
check(np.concatenate([points, rng.random((500, 3))]), tets)
check(np.concatenate([rng.random((500, 3)), points]), tets + 500)
check(points, tets[:1])

# Inverted, flat and duplicate tetrahedra; corners that coincide.
check(points, tets[:, [1, 0, 2, 3]])
mixed = tets.copy()
mixed[::3] = mixed[::3][:, [0, 1, 3, 2]]
check(points, mixed)
check(points * np.array([1, 1, 0], np.float32), tets)
check(np.zeros_like(points), tets)
check(points, np.concatenate([tets, tets[:200], tets[:100, [1, 0, 2, 3]], tets[:50, [1, 2, 0, 3]]]))
same = tets.copy()
same[:40, 1] = same[:40, 0]
same[20:40, 2:] = same[20:40, :1]
check(points, same)

# Non-manifold: many tetrahedra on one face, on one edge, on one point; a random soup.
check(rng.random((40, 3)), [[0, 1, 2, i] for i in range(3, 40)])
check(rng.random((40, 3)), [[0, 1, i, i + 1] for i in range(2, 39)])
check(rng.random((31, 3)), [[0, i, i + 1, i + 2] for i in range(1, 29, 3)])
check(rng.random((60, 3)), rng.integers(0, 60, (3000, 4)))
check(rng.random((5, 3)), list(itertools.permutations(range(5), 4)))

# Several components, and a hole.
check(np.concatenate([points + 3 * i for i in range(4)]),
      np.concatenate([tets + len(points) * i for i in range(4)]))
center = points[tets].mean(1)
check(points, tets[np.abs(center - 0.5).max(1) > 0.25])
check(np.concatenate([np.eye(3), np.zeros((1, 3))] * 300), np.arange(1200))

# One tetrahedron, points alone, nothing at all.
check(np.concatenate([np.eye(3), np.zeros((1, 3))]), [[0, 1, 2, 3]])
check(rng.random((100, 3)), [])
check(np.zeros((0, 3)), [])

# Larger, many chunks of different sizes.
points, tets = gm.lattice(14, seed=5)
grid = with_ids(points, tets)
for chunk in (0, 64, 1000, 5000):
    gm.assert_equal(grid, gm.round_trip(grid, "mesh.gtn", KeepOrder=7, ChunkSize=chunk))
    gm.assert_same_mesh(grid, gm.round_trip(grid, "mesh.gtn", ChunkSize=chunk))
