# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Makes the golden files of version 1.10 with points that move, and adds them to expected.json:

    export PYTHONPATH=build/release/lib/python3/dist-packages:Testing/IO
    Testing/Python/make_golden_moving.py FOLDER

What is expected is what the decoder written from the specification reads. Gatun must read the same, and
the input must come back."""

import json
import os
import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

import gatunGolden as golden
from describe_decoded import describe_decoded
from gatun import vtkGatunWriter
from gatunGolden import gm
from gatunGoldenMeshes import add, cubes, jitter, shuffle, single, wave
from gatunTimeSource import TimeSource, connect


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


def grids_of(n, kind, steps, digits=None, unused=5):
    rng = np.random.default_rng(3)
    points, tets = cubes((n, n, n))
    points, tets = shuffle(jitter(points, rng), tets, rng)
    points = np.concatenate([points, rng.random((unused, 3))])
    grids = []
    for s in range(steps):
        places = move(points, s)
        places = places if digits is None else np.round(places, digits)
        grid = gm.make_grid(places.astype(kind), tets)
        add(grid.GetPointData(), single(wave(points + 0.05 * s)), "values")
        grids.append(grid)
    return grids


def moving():
    return grids_of(4, np.float32, 7), {"KeyStepInterval": 3}


def moving_doubles():
    return grids_of(3, np.float64, 5), {}


def moving_decimals():
    return grids_of(3, np.float64, 5, 3), {"KeyStepInterval": 2}


def moving_tree():
    return grids_of(4, np.float32, 4, unused=0), {
        "Hierarchy": True, "WriteBoundary": True, "KeyStepInterval": 2}


def moving_small():
    points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]], np.float32)
    tets = np.array([[0, 1, 2, 3], [1, 2, 3, 4]])
    return [gm.make_grid(points + np.float32(0.1) * s * points[:, ::-1], tets) for s in (0, 1, 1, 2)], {}


def make(folder, function):
    path = os.path.join(folder, function.__name__ + ".gtn")
    grids, options = function()
    writer = vtkGatunWriter()
    times = [0.5 * s for s in range(len(grids))]
    connect(writer, TimeSource(grids.__getitem__, times))
    writer.WriteAllTimeStepsOn()
    writer.SetFileName(path)
    for name, value in dict(options, ChunkTets=128, KeepOrder=7).items():
        getattr(writer, "Set" + name)(value)
    assert writer.Write() == 1, path
    with open(path, "rb") as file:
        expected = describe_decoded(file.read())
    golden.assert_same(expected, golden.describe_read(path), path)
    for grid, back in zip(grids, golden.read_steps(path, True)[0]):
        one, other = (vtk_to_numpy(data.GetPoints().GetData()) for data in (grid, back))
        assert one.tobytes() == other.tobytes(), path
    return expected


def main(folder):
    os.makedirs(folder, exist_ok=True)
    path = os.path.join(folder, "expected.json")
    expected = {}
    for function in (moving, moving_doubles, moving_decimals, moving_tree, moving_small):
        name = function.__name__ + ".gtn"
        expected[name] = make(folder, function)
        print(name, os.path.getsize(os.path.join(folder, name)), flush=True)
    with open(path, "w", encoding="utf-8") as file:
        json.dump(expected, file, indent=1)
        file.write("\n")


if __name__ == "__main__":
    main(sys.argv[1])
