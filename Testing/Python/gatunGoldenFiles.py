# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Writes and checks golden files.

A file is made by a function that is named like it and takes a random number generator. It returns a
grid and options of the writer, or grids, times and options.

Where a file keeps the order of its input, what is expected is computed from the input, else by
gtn_decoder, which shares no code with Gatun. That Gatun reads what was written is checked, too.
"""

import json
import os

import numpy as np

import gatunGolden as golden
from describe_decoded import describe_decoded
from gatun import vtkGatunWriter
from gatunGolden import gm
from gatunTimeSource import TimeSource, connect

MAX_BYTES, MAX_BYTES_IN_TOTAL = 30000, 250000


def write(path, grids, times, options):
    writer = vtkGatunWriter()
    if times:
        connect(writer, TimeSource(grids.__getitem__, times))
        writer.WriteAllTimeStepsOn()
    else:
        writer.SetInputDataObject(grids[0])
    writer.SetFileName(path)
    for name, value in options.items():
        getattr(writer, "Set" + name)(value)
    assert writer.Write() == 1, path


def make(folder, function):
    """Writes a golden file, checks it and returns its name, description and size."""
    path = os.path.join(folder, function.__name__ + ".gtn")
    made = function(np.random.default_rng(list(function.__name__.encode())))
    grids, times, options = made if len(made) == 3 else ([made[0]], [], made[1])
    write(path, grids, times, options)

    # With all of the order the input tells what to expect, else the decoder.
    with open(path, "rb") as file:
        description = describe_decoded(file.read())
    keep = options.get("KeepOrder", 0)
    of_input = golden.describe_grids(grids, times, grids)
    expected = dict(of_input, file_order=description["file_order"])
    if keep != 7:
        expected["input_order"] = description["input_order"]
    golden.assert_same(expected, description, path + ", decoder")
    golden.assert_same(expected, golden.describe_read(path), path + ", reader")

    # Nothing but the order may differ from the input.
    for grid, back in zip(grids, golden.read_steps(path, True)[0]):
        if keep != 7:  # else input_order has told that already
            gm.assert_same_mesh(grid, back)
        if keep & 1:
            assert np.array_equal(
                gm.coordinates(grid).view(np.uint8), gm.coordinates(back).view(np.uint8))
        if keep & 2:
            arrays = [gm.arrays_of(part.GetCellData()) for part in (grid, back)]
            for one, other in zip(*arrays):
                assert np.array_equal(gm.values_of(one), gm.values_of(other))
    return os.path.basename(path), expected, os.path.getsize(path)


def make_all(folder, functions, adds=False):
    """Writes the files of these functions and expected.json. adds: to what that has."""
    os.makedirs(folder, exist_ok=True)
    expected, total = {}, 0
    if adds:
        with open(os.path.join(folder, "expected.json"), encoding="utf-8") as file:
            expected = json.load(file)
    for function in functions:
        name, description, size = make(folder, function)
        expected[name] = description
        print("%7d %s" % (size, name), flush=True)
        assert size < MAX_BYTES, name
        total += size
    assert total < MAX_BYTES_IN_TOTAL, total
    with open(os.path.join(folder, "expected.json"), "w", encoding="utf-8") as file:
        json.dump(expected, file, indent=1, sort_keys=False)
        file.write("\n")
    print(total, "bytes")
