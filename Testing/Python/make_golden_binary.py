# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Makes the golden files of version 1.11 with multiples of powers of two, and adds them to expected.json:

    export PYTHONPATH=build/release/lib/python3/dist-packages:Testing/IO
    Testing/Python/make_golden_binary.py FOLDER

Values are those of the input; the decoder written from the specification agrees."""

import sys

import numpy as np

import gtn_decoder
from gatunGolden import gm
from gatunGoldenFiles import make_all
from gatunGoldenMeshes import add, single, wave
from make_golden_scales import mesh

FIRST = set()


class Multiples(gtn_decoder.Multiples):
    """Remembers which scales a file has."""

    def __init__(self, kind, first):
        super().__init__(kind, first)
        FIRST.add((kind, first))


def multiples(values, first):
    """Rounded to multiples of 2^first."""
    return np.round(np.ldexp(values, -first)) * 2.0**first + 0.0


def binary_numbers(rng):
    points, tets = mesh(rng)
    grid = gm.make_grid(single(multiples(points, -10)), tets)
    data, values = grid.GetPointData(), wave(points)
    add(data, single(multiples(values, -20)), "fine")
    add(data, single(multiples(values * 2.0**110, 103)), "highest of floats")
    add(data, single(multiples(values * 2.0**-110, -126)), "lowest of floats")
    add(data, multiples(values * 2.0**150, 103), "highest of doubles")
    add(data, multiples(values * 2.0**-80, -126), "lowest of doubles")
    add(data, multiples(np.cos(points) * 1000, 0), "whole")
    add(data, np.stack([multiples(values, -9), values], -1), "mixed")
    add(grid.GetCellData(), multiples(wave(points)[tets].mean(1), -40), "cells")
    return grid, {"ChunkTets": 128, "KeepOrder": 7}


def binary_steps(rng):
    """Points move, and fineness changes, between keys of 2^-10 and others."""
    points, tets = mesh(rng, 3)
    points = np.concatenate([points, rng.random((8, 3))])
    grids = []
    for s in range(6):
        places = points + 0.1 * s * np.sin(points + s)
        grid = gm.make_grid(single(multiples(places, -12 if s == 3 else -10)), tets)
        add(grid.GetPointData(), multiples(np.cos(points + 0.1 * s), -12 + s % 3), "finer at times")
        add(grid.GetCellData(), single(multiples(wave(points)[tets].mean(1) + s, -8)), "cells")
        grids.append(grid)
    return grids, [float(s) for s in range(6)], {
        "KeyStepInterval": 4, "ChunkTets": 128, "KeepOrder": 7}


if __name__ == "__main__":
    gtn_decoder.Multiples = Multiples
    make_all(sys.argv[1], [binary_numbers, binary_steps], adds=True)
    print("types and exponents:", sorted(FIRST))
