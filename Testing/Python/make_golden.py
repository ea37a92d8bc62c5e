#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Makes the golden files, one for each feature of the formats, and expected.json:

    ninja -C build/release makeGolden
    export PYTHONPATH=build/release/lib/python3/dist-packages:Testing/IO
    Testing/Python/make_golden.py build/release/bin/makeGolden Testing/Data/Golden [NAME ...]

With names it makes only these files anew. Each is made by the function with its name in gatunGolden
Tets, Arrays, Steps or Cells, by means of vtkGatunWriter. Files that need private functions of the
core are made by the program makeGolden.

What is expected comes from what was written. Where a file does not keep the order of its input, or
bounds errors, what is expected is what the decoder reads that was written from the specification,
and it is compared with the input without regard to the order, or by the bounds. The order of the
file is always that of this decoder. That Gatun reads the same is checked, too.
"""

import glob
import json
import math
import os
import subprocess
import sys
from fractions import Fraction

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

import gatunGolden as golden
import gatunGoldenArrays
import gatunGoldenCells
import gatunGoldenSteps
import gatunGoldenTets
from describe_decoded import (
    cells_of_decoder, checksum_of, describe_core, describe_decoded, describe_volume)
from gatun.vtk import vtkGatunWriter
from gatunCells import described
from gatunMeshes import set_options, set_tolerance
from gatunGolden import gm
from gatunTimeSource import TimeSource, connect
from ghv_decoder import Volume
from gtn_bytes import checksum
from gtn_decoder import Decoder

MAX_BYTES, MAX_BYTES_IN_TOTAL = 30000, 800000
FUNCTIONS = {
    function.__name__: function
    for module in (gatunGoldenTets, gatunGoldenArrays, gatunGoldenSteps, gatunGoldenCells)
    for function in module.ALL
}


def write(path, inputs, times, errors, options):
    writer = vtkGatunWriter()
    if times:
        connect(writer, TimeSource(inputs.__getitem__, times, inputs[0].GetClassName()))
        writer.WriteAllTimeStepsOn()
    else:
        writer.SetInputDataObject(inputs[0])
    writer.SetFileName(path)
    writer.SetProfileToSmall()  # unless the options say fast
    set_options(writer, **options)
    for error in errors:
        set_tolerance(writer, error)
    assert writer.Write() == 1, path


# --------------------------------------------------------------------------------------------------
# What is expected


def expect(description, grids, times):
    """A description of the input, whose order is kept, with the file's own order of the decoder."""
    of_input = golden.describe_grids(grids, times, grids)
    if "meshes" not in of_input:
        return dict(of_input, file_order=description["file_order"])
    meshes = [dict(one, file_order=other["file_order"])
              for one, other in zip(of_input["meshes"], description["meshes"])]
    return dict(of_input, meshes=meshes)


def check_bounds(original, found, bound, name):
    """Every value is within its bound: none, or its kind and a number."""
    original, found = original.reshape(len(original), -1), found.reshape(len(found), -1)
    for x, y in zip(original.T, found.T):
        finite = x[np.isfinite(x)]
        span = Fraction(finite.max().item()) - Fraction(finite.min().item())
        for a, b in zip(x, y):
            if a.tobytes() == b.tobytes():
                continue
            assert bound and math.isfinite(a) and math.isfinite(b), name
            kind, number = bound
            exact = Fraction(a.item())
            most = {"abs": Fraction(number), "rel": Fraction(number) * span,
                    "pw": Fraction(number) * abs(exact),
                    "bits": Fraction(2) ** (math.frexp(a)[1] - 1 - int(number))}[kind]
            assert abs(exact - Fraction(b.item())) <= most, (name, a, b)


def check_errors(grids, backs, errors):
    bounds = {}
    for error in errors:
        name, _, bound = error.rpartition("=")
        kind, _, number = bound.partition(":")
        bounds[name] = kind, float(number.partition(",")[0])
    for grid, back in zip(grids, backs):
        for part in "GetPointData", "GetCellData":
            for array in gm.arrays_of(getattr(grid, part)()):
                name, values = array.GetName(), vtk_to_numpy(array)
                bound = bounds.get(name, bounds.get("*") if values.dtype.kind == "f" else None)
                found = vtk_to_numpy(getattr(back, part)().GetArray(name))
                check_bounds(values, found, bound, name)


def check_order(grids, backs, keep):
    """Nothing but the order differs from the input."""
    for grid, back in zip(grids, backs):
        if "tets" in golden.describe_cells(grid):
            gm.assert_same_mesh(grid, back)
        else:
            assert described(grid) == described(back)
        if keep & 1:
            assert np.array_equal(
                gm.coordinates(grid).view(np.uint8), gm.coordinates(back).view(np.uint8))
        if keep & 2:
            arrays = [gm.arrays_of(part.GetCellData()) for part in (grid, back)]
            for one, other in zip(*arrays):
                assert np.array_equal(gm.values_of(one), gm.values_of(other))


def make(path, function):
    """Writes a golden file, checks it and gives its description."""
    inputs, options = function(np.random.default_rng(list(function.__name__.encode())))
    options = dict(options)
    errors, times = options.pop("errors", []), options.pop("times", None)
    is_series = isinstance(inputs, list)
    if times is None:
        times = [float(i) for i in range(len(inputs))] if is_series else []
    inputs = inputs if is_series else [inputs]
    write(path, inputs, times, errors, options)

    with open(path, "rb") as file:
        description = expected = describe_decoded(file.read())
    grids, backs = [golden.grid_of(data) for data in inputs], golden.read_steps(path, True)[0]
    keep = options.get("KeepOrder", 0)
    if errors:
        assert keep == 7, "values are compared one by one"
        check_errors(grids, backs, errors)
    elif keep == 7:
        expected = expect(description, grids, times)
    else:
        check_order(grids, backs, keep)
    golden.assert_same(expected, description, path + ", decoder")
    golden.assert_same(expected, golden.describe_read(path), path + ", reader")
    return expected


def check_sums(path, sums):
    """Of a file of the program makeGolden: the decoder reads what was written."""
    with open(path, "rb") as file:
        data = file.read()
    if path.endswith(".ghv"):
        assert sums == ["%016x" % checksum(Volume(data).voxels().tobytes())], path
        return
    decoder = Decoder(data)
    found = [checksum_of(decoder.points(True)),
             checksum_of(np.array([x for _, points, _ in cells_of_decoder(decoder, True)
                                   for x in points], np.int64))]
    for step in range(len(decoder.steps)):
        for array in range(len(decoder.meta.arrays)):
            found.append(checksum_of(decoder.array(step, array, True)))
    assert found == sums, (path, found, sums)


def main(maker, folder, names):
    os.makedirs(folder, exist_ok=True)
    if not names:
        for path in glob.glob(os.path.join(folder, "*.g[th][nv]")):
            os.remove(path)
    expected = {"meshes": {}, "merges": {}, "layers": {}, "volumes": {}}
    if names:
        with open(os.path.join(folder, "expected.json"), encoding="utf-8") as file:
            expected = json.load(file)
    made = subprocess.run([maker, folder], stdout=subprocess.PIPE, check=True, text=True).stdout
    for line in made.splitlines():
        name, *sums = line.split(" ")
        check_sums(os.path.join(folder, name), sums)
    for name, function in FUNCTIONS.items():
        if not names or name in names:
            print(name, flush=True)
            path = os.path.join(folder, name + ".gtn")
            expected["meshes"][name + ".gtn"] = make(path, function)

    total = 0
    for path in sorted(glob.glob(os.path.join(folder, "*.g[th][nv]"))):
        name, size = os.path.basename(path), os.path.getsize(path)
        print("%7d %s" % (size, name), flush=True)
        assert size < MAX_BYTES, name
        total += size
        with open(path, "rb") as file:
            data = file.read()
        if name.endswith(".ghv"):
            expected["volumes"][name] = describe_volume(name, Volume(data))
            continue
        decoder = Decoder(data)
        if name[:-4] not in FUNCTIONS:
            expected["meshes"][name] = describe_decoded(data)
            golden.assert_same(expected["meshes"][name], golden.describe_read(path), path)
        for kind, lines in describe_core(name, decoder).items():
            expected[kind][name] = lines
    assert total < MAX_BYTES_IN_TOTAL, total
    for kind, of_files in expected.items():
        expected[kind] = dict(sorted(of_files.items()))
    with open(os.path.join(folder, "expected.json"), "w", encoding="utf-8") as file:
        json.dump(expected, file, indent=1)
        file.write("\n")
    print(total, "bytes")


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2], sys.argv[3:])
