# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Makes the golden files of version 1.9 with bounds of errors, and adds them to expected.json:

    export PYTHONPATH=build/release/lib/python3/dist-packages:Testing/IO
    Testing/Python/make_golden_bounded.py FOLDER

What is expected is what the decoder written from the specification reads. Gatun must read the same, and
every value must be within its bound of the input, in exact arithmetic."""

import json
import math
import os
import sys
from fractions import Fraction

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

import gatunGolden as golden
from describe_decoded import describe_decoded
from gatun import vtkGatunWriter
from gatunGolden import gm
from gatunGoldenMeshes import add, cubes, jitter, shuffle, single, wave
from gatunTimeSource import TimeSource, connect
from make_golden_quadratic import smooth


def wild(values):
    """The same with values that have no steps."""
    values = values.copy()
    values[::7] = np.resize([np.nan, np.inf, -np.inf, -0.0, 0.0, 1e-45, 3e38], values[::7].shape)
    return values


def make_grid(rng, s, n=4):
    points, tets = cubes((n, n, n))
    points, tets = shuffle(jitter(points, rng), tets, rng)
    points = np.concatenate([points, rng.random((8, 3))])
    center = points[tets].mean(1)
    grid = gm.make_grid(single(points), tets)
    data, cells = grid.GetPointData(), grid.GetCellData()
    field = wave(points + 0.05 * s)
    add(data, single(field), "float")
    add(data, field * 1000, "double")
    add(data, single(np.cos(points + 0.1 * s)), "vector")
    add(data, single(np.cos(points + 0.1 * s))[:, 1], "second")
    add(data, single(wild(field)), "wild")
    add(data, np.round(field * 5000).astype(np.int32), "integers")
    add(data, np.full(len(points), 2.5), "constant")
    add(cells, single(wave(center) + s), "cells")
    add(cells, wild(wave(center)) * 1e10, "wild cells")
    return grid


def bounded(rng):
    return [make_grid(rng, 0)], [], ["*=rel:1e-3", "integers=abs:20"], {}


def bounded_small(_):
    grid = gm.make_grid(np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]], np.float32),
                        np.array([[0, 1, 2, 3], [1, 2, 3, 4]]))
    add(grid.GetPointData(), np.array([0.1, 0.2, 0.25, 0.3, np.nan], np.float32), "T")
    return [grid], [], ["T=abs:0.01"], {}


def bounded_fine(rng):
    return [make_grid(rng, 0)], [], ["*=abs:1e-6", "integers=abs:1.5", "double=abs:1e-12"], {}


def bounded_pointwise(rng):
    return [make_grid(rng, 0)], [], ["*=pw:0.01", "vector=bits:7", "wild cells=bits:12"], {}


def bounded_boundary(rng):
    return [make_grid(rng, 0)], [], ["*=abs:0.02", "wild=pw:0.2"], {
        "WriteBoundary": True, "KeepZeros": True}


def bounded_steps(_):
    grids = [make_grid(np.random.default_rng(5), s, 3) for s in range(5)]
    return grids, [float(s) for s in range(5)], ["*=rel:1e-3", "wild=abs:0.01", "cells=pw:0.01"], {
        "KeyStepInterval": 4, "KeepZeros": True}


def bounded_quadratic(rng):
    """Values that quadratic functions predict, on points and cells."""
    points, tets = cubes((5, 5, 5))
    points, tets = shuffle(jitter(points, rng), tets, rng)
    grid = gm.make_grid(single(points), tets)
    values = smooth(points)
    odd = values.copy()
    odd[::19] = np.resize([np.nan, np.inf, -0.0, 0, 1e-310, 1e300], odd[::19].shape)
    for name, array in (("floats", single(values)), ("odd", odd), ("pointwise", values),
                        ("bits", single(values)), ("integers", np.int32(values * 1e6))):
        add(grid.GetPointData(), array, name)
    add(grid.GetCellData(), single(values[tets].mean(1)), "cells")
    add(grid.GetCellData(), odd[tets].max(1), "odd cells")
    return [grid], [], ["*=abs:1e-4", "pointwise=pw:1e-4", "bits=bits:14", "integers=abs:60"], {}


def bounded_quadratic_steps(rng):
    points, tets = cubes((4, 4, 4))
    points, tets = shuffle(jitter(points, rng), tets, rng)
    grids = []
    for s in range(3):
        grid = gm.make_grid(single(points), tets)
        noise = np.random.default_rng(1).normal(size=len(points))
        add(grid.GetPointData(), single(noise + smooth(points) * s), "changes")
        add(grid.GetCellData(), smooth(points + s)[tets].mean(1), "cells")
        grids.append(grid)
    return grids, [0.0, 1.0, 2.0], ["*=rel:1e-4"], {}


def check(original, found, errors, name):
    """Every value is within its bound."""
    original, found = original.reshape(len(original), -1), found.reshape(len(found), -1)
    bound = errors.get(name, errors.get("*") if original.dtype.kind == "f" else None)
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


def make(folder, function):
    path = os.path.join(folder, function.__name__ + ".gtn")
    grids, times, errors, options = function(np.random.default_rng(7))
    writer = vtkGatunWriter()
    if times:
        connect(writer, TimeSource(grids.__getitem__, times))
        writer.WriteAllTimeStepsOn()
    else:
        writer.SetInputDataObject(grids[0])
    writer.SetFileName(path)
    for name, value in dict(options, ChunkTets=128, KeepOrder=7).items():
        getattr(writer, "Set" + name)(value)
    for error in errors:
        writer.AddError(error)
    assert writer.Write() == 1, path

    with open(path, "rb") as file:
        expected = describe_decoded(file.read())
    golden.assert_same(expected, golden.describe_read(path), path)
    bounds = {}
    for error in errors:
        name, _, bound = error.rpartition("=")
        kind, _, number = bound.partition(":")
        bounds[name] = kind, float(number)
    for grid, back in zip(grids, golden.read_steps(path, True)[0]):
        for of in ("GetPointData", "GetCellData"):
            one, other = getattr(grid, of)(), getattr(back, of)()
            for i in range(one.GetNumberOfArrays()):
                name = one.GetArray(i).GetName()
                found = vtk_to_numpy(other.GetArray(name))
                check(vtk_to_numpy(one.GetArray(i)), found, bounds, name)
    return expected


ALL = [bounded, bounded_small, bounded_fine, bounded_pointwise, bounded_boundary, bounded_steps,
       bounded_quadratic, bounded_quadratic_steps]


def main(folder, functions=ALL):
    os.makedirs(folder, exist_ok=True)
    path = os.path.join(folder, "expected.json")
    expected = {}
    if os.path.exists(path):
        with open(path, encoding="utf-8") as file:
            expected = json.load(file)
    for function in functions:
        name = function.__name__ + ".gtn"
        expected[name] = make(folder, function)
        print(name, os.path.getsize(os.path.join(folder, name)), flush=True)
    with open(path, "w", encoding="utf-8") as file:
        json.dump(expected, file, indent=1)
        file.write("\n")


if __name__ == "__main__":
    main(sys.argv[1])
