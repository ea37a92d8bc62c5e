# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Makes the golden files of version 1.4, with surfaces, and expected.json next to them:

    export PYTHONPATH=build/release/lib/python3/dist-packages:Testing/IO
    Testing/Python/make_golden_surfaces.py FOLDER

As for other golden files, what is expected is computed from the input where a file keeps the order
of its input, else by gtn_decoder, which shares no code with Gatun."""

import json
import os
import sys

import numpy as np

import gatunGolden as golden
import gatunPolyData as pd
from describe_decoded import describe_decoded
from gatun import vtkGatunWriter
from gatunGolden import gm
from gatunTimeSource import TimeSource, connect

MAX_BYTES = 20000
ALL = {"KeepOrder": 7}
CHUNKS = {"ChunkTets": 64}


def two_faces():
    surface = pd.make(np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [2, 0, 0]], np.float32),
                      Polys=[[0, 1, 2, 3], [1, 4, 2]])
    gm.add_array(surface.GetPointData(), np.arange(5, dtype=np.float32), "T")
    return surface


def steps():
    """Values of all lists that move."""
    made = []
    for step in range(3):
        surface = pd.make(np.random.default_rng(4).random((30, 3)), wide=False, Verts=[[0], [1, 2]],
                          Lines=[[3, 4], [4, 5, 6]], Polys=[[7, 8, 9], [9, 8, 10, 11]],
                          Strips=[[12, 13, 14, 15]])
        gm.add_array(surface.GetCellData(), np.arange(7, dtype=np.int32) * 3 + step, "rising")
        made.append(surface)
    return made, [0.0, 1.0, 2.5]


# Functions and options by names of files.
FILES = {
    "two_faces": (two_faces, {}),
    "all_lists": (lambda: pd.add_arrays(pd.mixed(12)), {**ALL, **CHUNKS}),
    "in_any_order": (lambda: pd.add_arrays(pd.mixed(8)), {}),
    "odd": (lambda: pd.add_arrays(pd.odd()), ALL),
    "moebius": (lambda: pd.moebius(20), {}),
    "nothing": (lambda: pd.make(np.zeros((0, 3), np.float32)), {}),
    "points": (lambda: pd.make(np.eye(3)), ALL),
    "rounded": (lambda: pd.add_arrays(pd.wave(10)), {**ALL, "PointError": 0.01}),
    "steps": (steps, ALL),
}


def make(folder, name):
    """Writes a golden file, checks it and gives its description."""
    path = os.path.join(folder, name + ".gtn")
    function, options = FILES[name]
    made = function()
    surfaces, times = made if isinstance(made, tuple) else ([made], [])
    writer = vtkGatunWriter()
    if times:
        connect(writer, TimeSource(surfaces.__getitem__, times, "vtkPolyData"))
        writer.WriteAllTimeStepsOn()
    else:
        writer.SetInputDataObject(surfaces[0])
    writer.SetFileName(path)
    for key, value in options.items():
        getattr(writer, "Set" + key)(value)
    assert writer.Write() == 1, path
    with open(path, "rb") as file:
        description = describe_decoded(file.read())
    expected = description
    if options.get("KeepOrder") == 7 and "PointError" not in options:
        grids = [golden.grid_of(surface) for surface in surfaces]
        expected = dict(golden.describe_grids(grids, times, grids),
                        file_order=description["file_order"])
    golden.assert_same(expected, description, path + ", decoder")
    golden.assert_same(expected, golden.describe_read(path), path + ", reader")
    return expected, os.path.getsize(path)


def main(folder):
    os.makedirs(folder, exist_ok=True)
    expected = {}
    for name in FILES:
        expected[name + ".gtn"], size = make(folder, name)
        print("%7d %s" % (size, name), flush=True)
        assert size < MAX_BYTES, name
    with open(os.path.join(folder, "expected.json"), "w", encoding="utf-8") as file:
        json.dump(expected, file, indent=1, sort_keys=False)
        file.write("\n")


if __name__ == "__main__":
    main(sys.argv[1])
