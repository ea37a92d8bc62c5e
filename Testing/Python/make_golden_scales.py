# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Makes the golden files of version 1.8, with scales, and expected.json next to them:

    export PYTHONPATH=build/release/lib/python3/dist-packages:Testing/IO
    Testing/Python/make_golden_scales.py FOLDER

Values are those of the input; the decoder written from the specification agrees."""

import sys

import numpy as np

from gatunGolden import gm
from gatunGoldenFiles import make_all
from gatunGoldenMeshes import add, cubes, jitter, shuffle, single, wave


def decimals(values, digits):
    """Numbers of so many significant digits, as they are read from a text."""
    return np.array(["%.*e" % (digits - 1, value) for value in values.ravel()],
                    float).reshape(values.shape)


def mesh(rng, n=4):
    points, tets = cubes((n, n, n))
    return shuffle(jitter(points, rng), tets, rng)


def small(rng):
    points, tets = cubes((3, 3, 1))
    grid = gm.make_grid(single(points), tets)
    values = decimals(wave(points), 3)
    add(grid.GetPointData(), single(values), "decimal")
    add(grid.GetPointData(), single(values), "the same")
    return grid, {"KeepOrder": 7}


def doubles_of_floats(rng):
    points, tets = mesh(rng)
    points = single(points).astype(float)
    grid = gm.make_grid(points, tets)
    odd = single(wave(points)).astype(float)
    odd[::9] = np.resize([np.nan, np.inf, -np.inf, -0.0, 0.0, 1e-45], odd[::9].shape)
    add(grid.GetPointData(), single(np.cos(points)).astype(float), "vector")
    add(grid.GetPointData(), np.asarray(odd, np.float32).astype(float), "odd")
    add(grid.GetPointData(), wave(points).astype(np.float16).astype(np.float32), "halves")
    add(grid.GetCellData(), single(wave(points)[tets].mean(1)).astype(float), "cells")
    return grid, {"ChunkTets": 128, "KeepOrder": 7}


def decimal_numbers(rng):
    points, tets = mesh(rng)
    points[rng.integers(0, len(points), 9), 1] = 0
    grid = gm.make_grid(single(decimals(points * 0.01, 4)), tets)
    data = grid.GetPointData()
    add(data, single(decimals(wave(points) * 10.0 ** rng.integers(-9, 9, len(points)), 5)), "five")
    add(data, decimals(np.cos(points) * 1e-6, 3), "three of doubles")
    add(data, decimals(wave(points) * 1e19, 15), "fifteen")
    # Powers of ten, some of which are rounded down.
    tens = np.array([float("1e%d" % i) for i in range(-22, 23)])
    add(data, single(np.resize(tens, len(points)) * rng.integers(-9, 10, len(points))), "one")
    add(grid.GetCellData(), single(decimals(wave(points)[tets].mean(1), 4)), "cells")
    return grid, {"ChunkTets": 128, "KeepOrder": 7}


def fixed_numbers(rng):
    points, tets = mesh(rng)
    grid = gm.make_grid(np.round(points, 2), tets)
    data = grid.GetPointData()
    add(data, np.round(wave(points) * 1000), "whole")
    add(data, np.round(wave(points) * 1e9), "large")
    add(data, np.round(wave(points) * 100 + 100, 3), "places")
    add(data, (np.arange(len(points)) * 8 - 320).astype(np.int32), "eights")
    add(data, (np.arange(len(points)) * 2**40 + 2**60).astype(np.uint64), "wide")
    add(data, np.full(len(points), -12, np.int8), "one")
    return grid, {"ChunkTets": 128, "KeepOrder": 7}


def scales_of_steps(rng):
    points, tets = mesh(rng, 3)
    points = np.concatenate([points, rng.random((8, 3))])
    center = points[tets].mean(1)
    grids = []
    for s in range(7):
        grid = gm.make_grid(single(points), tets)
        data, cells = grid.GetPointData(), grid.GetCellData()
        add(data, single(np.cos(points + 0.1 * s)).astype(float), "floats")
        add(data, decimals(wave(points + 0.1 * s), 3 if s < 3 else 5), "more digits")
        add(data, decimals(wave(points + 0.1 * s), 5 if s < 3 else 3), "fewer digits")
        mixed = np.stack([np.round(wave(points) + s, 2), wave(points) + s], -1)
        add(data, single(mixed) if s != 4 else single(np.round(mixed)), "mixed")
        add(data, np.round(wave(points) * 99) if s else np.zeros(len(points)), "begins with 0")
        add(cells, decimals(wave(center) * (1 + 0.01 * s), 4), "cells")
        add(cells, (np.arange(len(tets)) + s) * (4 if s != 2 else 2), "multiples")
        grids.append(grid)
    return grids, [float(s) for s in range(7)], {
        "KeyStepInterval": 5, "ChunkTets": 64, "KeepOrder": 7}


def copies_of_arrays(rng):
    """Copies that are some only at some steps, and copies of arrays that have a before."""
    points, tets = mesh(rng, 3)
    points = np.concatenate([points, rng.random((8, 3))])
    grids = []
    for s in range(6):
        grid = gm.make_grid(single(points), tets)
        data, cells = grid.GetPointData(), grid.GetCellData()
        vector = single(np.cos(points + 0.1 * s))
        add(data, vector[:, 1], "second")
        add(data, vector, "vector")
        add(data, vector[:, ::-1] if s != 2 else vector + 1, "turned")
        add(data, vector[:, 0] if s in (1, 4) else wave(points).astype(np.float32), "at times")
        add(data, vector.astype(float), "of another type")
        ids = np.arange(len(tets))
        add(cells, ids, "ids")
        add(cells, ids if s < 3 else ids[::-1], "at first")
        add(cells, np.stack([ids] * 2, -1), "twice")
        grids.append(grid)
    return grids, [float(s) for s in range(6)], {
        "KeyStepInterval": 4, "ChunkTets": 64, "KeepOrder": 7}


ALL = [
    small, doubles_of_floats, decimal_numbers, fixed_numbers, scales_of_steps, copies_of_arrays]


if __name__ == "__main__":
    make_all(sys.argv[1], ALL)
