# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Makes the golden files of version 1.5, with boundaries, and expected.json next to them:

    export PYTHONPATH=build/release/lib/python3/dist-packages:Testing/IO
    Testing/Python/make_golden_boundaries.py FOLDER

Contents are those of gtn_decoder, which shares no code with Gatun and finds the same boundaries."""

import json
import os
import sys

import gatunCells as gc
import gatunGolden as golden
import numpy as np
from describe_decoded import describe_decoded
from gatun import vtkGatunWriter
from gatunGolden import gm
from gatunTimeSource import TimeSource, connect
from gtn_boundary import check_boundary
from gtn_decoder import Decoder

LINEAR = [1, 2, 3, 4, 5, 7, 9, 10, 12, 13, 14, 42]


def one_tet():
    grid = gm.make_grid(np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], np.float32),
                        [[0, 1, 2, 3]])
    gm.add_array(grid.GetPointData(), np.arange(4, dtype=np.float32), "T")
    return [grid]


def steps():
    made = []
    for step in range(3):
        grid = gm.make_grid(*gm.lattice(3))
        gm.add_array(grid.GetPointData(), np.arange(64, dtype=np.int32) * step, "rising")
        gm.add_array(grid.GetCellData(), np.arange(162, dtype=np.int32) + step, "number")
        made.append(grid)
    return made


# Functions and options by names of files.
FILES = {
    "one_tet": (one_tet, {}),
    "chunks": (lambda: [gm.block(n=4)], {"ChunkTets": 64, "KeepOrder": 7}),
    "cells": (lambda: [gc.zoo(LINEAR, 2)], {}),
    "steps": (steps, {}),
}


def make(folder, name):
    """Writes a golden file, checks it and gives its description."""
    path = os.path.join(folder, name + ".gtn")
    function, options = FILES[name]
    grids = function()
    writer = vtkGatunWriter()
    if len(grids) > 1:
        connect(writer, TimeSource(grids.__getitem__, [float(i) for i in range(len(grids))]))
        writer.WriteAllTimeStepsOn()
    else:
        writer.SetInputData(grids[0])
    writer.SetFileName(path)
    writer.WriteBoundaryOn()
    for key, value in options.items():
        getattr(writer, "Set" + key)(value)
    assert writer.Write() == 1, path
    with open(path, "rb") as file:
        data = file.read()
    description = describe_decoded(data)
    golden.assert_same(golden.describe_read(path), description, path)
    decoder = Decoder(data)
    check_boundary(decoder, decoder.boundary())
    return description


def main(folder):
    os.makedirs(folder, exist_ok=True)
    expected = {name + ".gtn": make(folder, name) for name in FILES}
    with open(os.path.join(folder, "expected.json"), "w", encoding="utf-8") as file:
        json.dump(expected, file, indent=1, sort_keys=False)
        file.write("\n")


if __name__ == "__main__":
    main(sys.argv[1])
