#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Makes the golden files of version 1.0 of the format, once, and expected.json next to them:

    PYTHONPATH=build/release/lib/python3/dist-packages Testing/Python/make_golden.py FOLDER

Golden files stay as they are: a reader must read them forever.
"""

import itertools
import sys

import numpy as np
from vtkmodules.util import vtkConstants as c
from vtkmodules.vtkCommonDataModel import vtkDataSetAttributes

from gatunGolden import gm
from gatunGoldenFiles import make_all
from gatunGoldenMeshes import (
    add, add_texts, add_usual, cubes, delaunay, fan, jitter, shuffle, single, wave)


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


def tets_six(rng):
    points, tets = cubes((4, 4, 4))
    points, tets = shuffle(single(jitter(points, rng)), tets, rng)
    return add_usual(gm.make_grid(points, tets, False)), {}


def hexes_split(rng):
    points, tets = cubes((7, 5, 4), 5)
    return add_usual(gm.make_grid(single(points * [1, 1.5, 2]), tets)), {}


def sliver_layers(rng):
    points, tets = cubes((5, 5, 4))
    points = jitter(points, rng) * [1, 1, 1e-3]
    points, tets = shuffle(single(points), tets, rng)
    return add_usual(gm.make_grid(points, tets)), {"ChunkTets": 150}


def chunks(rng):
    points, tets = cubes((4, 4, 4))
    points, tets = shuffle(single(jitter(points, rng)), tets, rng)
    return add_usual(gm.make_grid(points, tets)), {"ChunkTets": 64}


def chunks_keep_all(rng):
    points, tets = cubes((4, 4, 3))
    points, tets = shuffle(jitter(points, rng), tets, rng)
    return add_usual(gm.make_grid(points, tets)), {"ChunkTets": 100, "KeepOrder": 7}


def keep_points(rng):
    points, tets = cubes((3, 3, 3))
    return add_usual(gm.make_grid(single(jitter(points, rng)), tets)), {"KeepOrder": 1}


def keep_cells(rng):
    points, tets = cubes((3, 3, 3))
    return add_usual(gm.make_grid(single(jitter(points, rng)), tets)), {"KeepOrder": 2}


def palettes(rng):
    points, tets = cubes((4, 4, 4))
    points = np.round(jitter(points, rng) * 10) / 10
    points[rng.integers(0, len(points), 5), 0] = -0.0
    grid = gm.make_grid(points, tets)
    levels = np.array([0.0, -0.0, 0.1, 1 / 3, 1e300, np.inf, -5])
    add(grid.GetPointData(), levels[(3 * (points ** 2).sum(1)).astype(int) % 7], "levels")
    few = np.stack([np.round(points[:, 0]), wave(points), np.full(len(points), np.nan)], -1)
    add(grid.GetPointData(), single(few), "one of three")
    add(grid.GetCellData(), single(np.round(points[tets].mean(1)[:, 1])), "layer")
    return grid, {"ChunkTets": 200, "KeepOrder": 7}


def odd_coordinates(rng):
    points, tets = cubes((4, 3, 3))
    points = jitter(points, rng) * 1e-3
    flat = points.reshape(-1)
    strewn = rng.choice(flat.size, 24, replace=False)
    flat[strewn] = [np.nan, np.inf, -np.inf, -0.0, 1e308, 5e-324] * 4
    flat.view(np.uint64)[strewn[::6]] = 0x7FF8000000000000 + np.arange(4, dtype=np.uint64)
    flat.view(np.uint64)[strewn[12]] = 0xFFF0000000000001
    return add_usual(gm.make_grid(points, tets)), {"KeepOrder": 7, "ChunkTets": 120}


def huge_and_tiny(rng):
    points, tets = cubes((2, 2, 2))
    grid = gm.make_grid(jitter(points, rng) * 1e300, tets)
    add(grid.GetPointData(), wave(points) * 1e-310, "subnormal")
    add(grid.GetPointData(), single(wave(points) * 1e-41), "subnormal float")
    add(grid.GetPointData(), single(np.where(wave(points) > 0, 3.4e38, -3.4e38)), "largest")
    return grid, {"KeepOrder": 7}


TYPES = {
    c.VTK_CHAR: np.int8, c.VTK_SIGNED_CHAR: np.int8, c.VTK_UNSIGNED_CHAR: np.uint8,
    c.VTK_SHORT: np.int16, c.VTK_UNSIGNED_SHORT: np.uint16,
    c.VTK_INT: np.int32, c.VTK_UNSIGNED_INT: np.uint32,
    c.VTK_LONG: np.int64, c.VTK_UNSIGNED_LONG: np.uint64,
    c.VTK_LONG_LONG: np.int64, c.VTK_UNSIGNED_LONG_LONG: np.uint64,
    c.VTK_ID_TYPE: np.int64, c.VTK_FLOAT: np.float32, c.VTK_DOUBLE: np.float64,
    c.VTK_BIT: np.uint8}


def types(rng):
    points, tets = cubes((2, 2, 2))
    points, tets = shuffle(single(jitter(points, rng)), tets, rng)
    grid = gm.make_grid(points, tets)
    for vtk_type, dtype in TYPES.items():
        size = np.dtype(dtype).itemsize
        centers = points[tets].mean(1)
        for where, at in ((grid.GetPointData(), points), (grid.GetCellData(), centers)):
            noise = rng.integers(0, 256, (len(at), size), np.uint8).view(dtype).ravel()
            if vtk_type == c.VTK_BIT:
                noise &= 1
            else:
                scale = 30 if size == 1 else 1000.5
                smooth = (wave(at) * scale).astype(dtype if dtype(0).dtype.kind != "u" else "i8")
                noise[::2] = smooth.astype(dtype)[::2]
                if dtype(0).dtype.kind in "iu":
                    noise[1], noise[3] = np.iinfo(dtype).min, np.iinfo(dtype).max
            add(where, noise, "type %d" % vtk_type, vtk_type)
    return grid, {"KeepOrder": 7, "ChunkTets": 64}


def components_and_roles(rng):
    points, tets = cubes((2, 2, 2))
    grid = gm.make_grid(single(jitter(points, rng)), tets)
    data = grid.GetPointData()
    add(data, np.stack([wave(points)] * 2, -1), "twice", components=["one", ""])
    add(data, points.astype(np.int16), "Grad \u03c6", components=["x", "y", "z"])
    add(data, np.tile(points, 3), "tensor")
    add(data, rng.random(len(points)), "same name")
    add(data, rng.integers(-9, 9, (len(points), 5)), "")
    data.SetActiveVectors("Grad \u03c6")
    data.SetActiveTensors("tensor")
    add(grid.GetCellData(), np.arange(len(tets))[::-1].copy(), "ids", c.VTK_ID_TYPE)
    add(grid.GetCellData(), rng.random(len(tets)), "same name")
    grid.GetCellData().SetActiveAttribute("ids", vtkDataSetAttributes.GLOBALIDS)
    grid.GetCellData().SetActiveScalars("same name")
    return grid, {"KeepOrder": 7}


def unused(rng):
    points, tets = cubes((3, 3, 3))
    more = rng.random((30, 3))
    points = single(np.concatenate([more[:10], points, more[10:]]))
    return add_usual(gm.make_grid(points, tets + 10)), {"KeepOrder": 7, "ChunkTets": 64}


def unused_not_kept(rng):
    points, tets = cubes((3, 3, 3))
    points = single(np.concatenate([rng.random((30, 3)), points]))
    return add_usual(gm.make_grid(points, tets + 30)), {"ChunkTets": 100}


def flipped(rng):
    points, tets = cubes((4, 4, 3))
    turn = rng.random(len(tets)) < 0.1
    tets[turn] = tets[turn][:, [1, 0, 2, 3]]
    tets = np.concatenate([tets, tets[:9], tets[50:60, ::-1]])
    return add_usual(gm.make_grid(single(jitter(points, rng)), tets)), {"ChunkTets": 160}


def with_holes(rng):
    points, tets = cubes((6, 6, 6))
    tets = tets[rng.random(len(tets)) < 0.5]
    points = single(np.round(jitter(points, rng), 2))
    return gm.make_grid(*shuffle(points, tets, rng)), {"ChunkTets": 200}


def soup(rng):
    points = single(rng.random((60, 3)))
    tets = rng.integers(0, 60, (150, 4))
    tets = np.concatenate([tets, tets[:20], tets[20:40][:, ::-1], np.zeros((2, 4), int)])
    return add_usual(gm.make_grid(points, tets)), {"KeepOrder": 7}


def soup_in_chunks(rng):
    points = single(rng.random((40, 3)))
    tets = rng.integers(0, 40, (600, 4))
    return gm.make_grid(points, tets), {"ChunkTets": 64}


def many_neighbours(rng):
    """More than 64 chunks that meet in one point."""
    points, tets = cubes((2, 2, 220), 5)
    tets[::17, 3] = len(points)
    points = np.concatenate([points, [[9, 9, 30]]])
    return gm.make_grid(single(points), tets), {"ChunkTets": 64}


def around_an_edge(rng):
    points, tets = fan(280)
    return add_usual(gm.make_grid(single(points), tets)), {}


def flat(rng):
    points, tets = cubes((3, 3, 2))
    points[:, 2] = 0
    return gm.make_grid(single(points), tets), {"KeepOrder": 4}


def one_place(rng):
    """No extent, so no lattice; and points that are nowhere."""
    points = np.full((12, 3), 7.5)
    points[10:] = np.nan
    tets = rng.integers(0, 12, (30, 4))
    return gm.make_grid(single(points), tets), {"KeepOrder": 2}


def strip(rng):
    points, tets = cubes((1, 1, 60))
    points = jitter(points, rng) + np.sin(points[:, [2, 2, 0]] / 9)
    return gm.make_grid(*shuffle(single(points), tets, rng)), {}


def random_strip(rng):
    """Each tetrahedron adds one point anywhere."""
    points = single(rng.random((400, 3)))
    order = rng.permutation(400)
    return gm.make_grid(points, np.stack([order[i : 397 + i] for i in range(4)], 1)), {}


def all_of_few(rng):
    """All tetrahedra of nine points, twice: edges with many open faces."""
    tets = list(itertools.combinations(range(9), 4))
    return gm.make_grid(single(rng.random((9, 3))), np.array(tets + tets)), {}


def large_chunks(rng):
    points, tets = cubes((9, 9, 7))
    points = single(np.round(jitter(points, rng), 1))
    return gm.make_grid(points, tets), {"ChunkTets": 900}


def shared_fans(rng):
    """Two chunks that share nearly all of their points, and long edges: long searches."""
    n = 700
    points = np.round(rng.random((n, 3)), 2)
    hubs = [[-2, 0, 0.5], [-2, 1, 0.5], [3, 0, 0.5], [3, 1, 0.5]]
    tets = []
    for a in (n, n + 2):
        order = rng.permutation(n)
        tets += [[a, a + 1, order[i], order[i - 1]] for i in range(n)]
    return gm.make_grid(single(np.concatenate([points, hubs])), tets), {"ChunkTets": n}


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


def cones(rng):
    return around_a_point([(n, 20) for n in range(6, 18)], rng)


# In these a turn ends at the last face where it may, or would end at the next one.


def turns_32(_):
    return around_a_point([(15, 23)], np.random.default_rng(21))


def turns_32_back(_):
    return around_a_point([(15, 23)], np.random.default_rng(126))


def turns_33(_):
    return around_a_point([(15, 23)], np.random.default_rng(74))


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
    return gm.make_grid(points, tets), {"ChunkTets": len(tets) // 2}


def long_searches(rng):
    return searches(3000, 80, 0.9, 0.3, rng)


def long_searches_end(_):
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
    return gm.make_grid(single(np.concatenate([points, hubs])), tets), {"ChunkTets": n}


def regular_chunks(_):
    """Shared points just as far away as a search goes."""
    points, tets = cubes((5, 5, 5))
    return gm.make_grid(single(points), tets), {"ChunkTets": 400}


CORNERS = np.stack(np.meshgrid([0, 65535], [0, 65535], [0, 65535]), -1).reshape(-1, 3)


def large_and_small(rng):
    """A Delaunay mesh with tetrahedra as small as the steps of the lattice and as large as all."""
    small = 20000 + rng.uniform(0, 20, (250, 3))
    points = single(np.concatenate([small, rng.uniform(0, 65535, (40, 3)), CORNERS]))
    return gm.make_grid(*shuffle(points, delaunay(points), rng)), {}


def needles(_):
    """A Delaunay mesh of which some faces are made nearly a line, or just that: large circles."""
    rng = np.random.default_rng(1)
    points = single(np.concatenate([rng.uniform(0, 65535, (120, 3)), CORNERS]))
    points = np.floor(points / 64) * 64
    tets = delaunay(points)
    for a, b, c in tets[rng.permutation(len(tets))[:25], :3]:
        points[c] = (points[a] + points[b]) / 2 + rng.choice([0, 16]) * rng.integers(-1, 2, 3)
    return gm.make_grid(*shuffle(points, tets, rng)), {}


def merged_layers(rng):
    """Six meshes in the same place that have many points in common, so faces of many cells."""
    points, tets = cubes((4, 4, 4))
    n = len(points)
    layers = [tets]
    for i in range(1, 6):
        layers.append(np.where(rng.random(n) < 0.7, np.arange(n), np.arange(n) + i * n)[tets])
    points = np.concatenate([points] + [points + 0.3] * 5)
    used, tets = np.unique(np.concatenate(layers), return_inverse=True)
    points = single(np.round(jitter(points, rng), 2))[used]
    return gm.make_grid(*shuffle(points, tets.reshape(-1, 4), rng)), {}


def field_data(rng):
    points, tets = cubes((1, 1, 1))
    grid = gm.make_grid(single(points), tets)
    add_texts(grid, "texts", ["", "two words", "Gr\u00f6\u00dfe \u2207\u03c6", "x" * 300])
    add(grid.GetFieldData(), np.array([np.nan, -0.0, 1e-310]), "doubles")
    add(grid.GetFieldData(), np.arange(12, dtype=np.int16).reshape(4, 3), "triples",
        components=["a", "b", "c"])
    add(grid.GetFieldData(), np.array([1 << 63], np.uint64), "large")
    return grid, {}


def steps_mesh(rng):
    points, tets = cubes((3, 3, 3))
    return shuffle(single(jitter(points, rng)), tets, rng)


def steps(rng):
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
    return grids, [-1.5, 0.0, 0.1, 0.30000000000000004, 2.0, 1e3, 1e4], {
        "KeyStepInterval": 5, "ChunkTets": 64, "KeepOrder": 7}


def steps_not_kept(rng):
    points, tets = steps_mesh(rng)
    grids = []
    for s in range(4):
        grid = gm.make_grid(points, tets)
        add(grid.GetPointData(), np.cos(points.astype(float) + 0.1 * s), "vector")
        add(grid.GetCellData(), single(points[tets].mean(1)[:, 0] + s), "x")
        grids.append(grid)
    return grids, [0.0, 1.0, 2.0, 3.0], {"KeyStepInterval": 2}


def one_step(rng):
    points, tets = cubes((1, 1, 2))
    grid = gm.make_grid(single(points), tets)
    add(grid.GetPointData(), wave(points), "wave")
    return [grid], [0.25], {"KeepOrder": 3}


ALL = [
    one_tet, empty, only_points, tets_six, hexes_split, sliver_layers, chunks, chunks_keep_all,
    keep_points, keep_cells, palettes, odd_coordinates, huge_and_tiny, types, components_and_roles,
    unused, unused_not_kept, flipped, with_holes, soup, soup_in_chunks, many_neighbours,
    around_an_edge, cones, turns_32, turns_32_back, turns_33, flat, one_place, strip, random_strip,
    all_of_few, large_chunks, shared_fans, long_searches, large_and_small, merged_layers,
    field_data, steps, steps_not_kept, one_step, long_searches_end, equal_ranks, regular_chunks,
    needles]


if __name__ == "__main__":
    make_all(sys.argv[1], ALL)