# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Golden files of values: types, palettes, scales, copies, bounds of errors and quadratic functions.

Each function of ALL makes the file with its name; see make_golden.py."""

import numpy as np
from vtkmodules import vtkCommonCore
from vtkmodules.util import vtkConstants as c
from vtkmodules.vtkCommonCore import vtkDataArray
from vtkmodules.vtkCommonDataModel import vtkDataSetAttributes

from gatunGolden import gm
from gatunGoldenMeshes import add, add_texts, cubes, jitter, shuffle, single, wave


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
    return grid, {"ChunkSize": 200, "KeepOrder": 7}


TYPES = {
    c.VTK_CHAR: np.int8, c.VTK_SIGNED_CHAR: np.int8, c.VTK_UNSIGNED_CHAR: np.uint8,
    c.VTK_SHORT: np.int16, c.VTK_UNSIGNED_SHORT: np.uint16,
    c.VTK_INT: np.int32, c.VTK_UNSIGNED_INT: np.uint32,
    c.VTK_LONG: np.int64, c.VTK_UNSIGNED_LONG: np.uint64,
    c.VTK_LONG_LONG: np.int64, c.VTK_UNSIGNED_LONG_LONG: np.uint64,
    c.VTK_ID_TYPE: np.int64, c.VTK_FLOAT: np.float32, c.VTK_DOUBLE: np.float64,
    c.VTK_BIT: np.uint8}


def value_types(rng):
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
    return grid, {"KeepOrder": 7, "ChunkSize": 64}


def attributes(rng):
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


def names_and_keys(rng):
    """Information keys of all kinds, of arrays, points and field data, and names of the points."""
    points, tets = cubes((2, 2, 2))
    grid = gm.make_grid(single(jitter(points, rng)), tets)
    add(grid.GetPointData(), wave(points), "pressure")
    add(grid.GetCellData(), np.arange(len(tets), dtype=np.int32), "number")
    add(grid.GetFieldData(), np.array([2.5, 3.5]), "limits")
    places = grid.GetPoints().GetData()
    places.SetName("Position")
    for i, name in enumerate("xyz"):
        places.SetComponentName(i, name)
    arrays = [grid.GetPointData().GetArray(0), grid.GetCellData().GetArray(0), places,
              grid.GetFieldData().GetArray(0)]
    for array, unit in zip(arrays, ("Pa", "", "m", "\u00b5m")):
        array.GetInformation().Set(vtkDataArray.UNITS_LABEL(), unit)
    info = arrays[0].GetInformation()
    for kind, values in (
            ("Integer", -5), ("Double", 0.1), ("IdType", 1 << 40), ("UnsignedLong", 7),
            ("String", "text"), ("IntegerVector", [1, -2, 3]), ("DoubleVector", [0.5, -0.0]),
            ("StringVector", ["one", "", "three"])):
        key = getattr(vtkCommonCore, "vtkInformation%sKey" % kind).MakeKey(
            "OF_" + kind.upper(), "gatunGolden")
        if not isinstance(values, list):
            key.Set(info, values)
        for value in values if isinstance(values, list) else ():
            key.Append(info, value)
    return grid, {"KeepOrder": 7}


def field_data(rng):
    points, tets = cubes((1, 1, 1))
    grid = gm.make_grid(single(points), tets)
    add_texts(grid, "texts", ["", "two words", "Gr\u00f6\u00dfe \u2207\u03c6", "x" * 300])
    add(grid.GetFieldData(), np.array([np.nan, -0.0, 1e-310]), "doubles")
    add(grid.GetFieldData(), np.arange(12, dtype=np.int16).reshape(4, 3), "triples",
        components=["a", "b", "c"])
    add(grid.GetFieldData(), np.array([1 << 63], np.uint64), "large")
    return grid, {}


def decimals(values, digits):
    """Numbers of so many significant digits, as they are read from a text."""
    return np.array(["%.*e" % (digits - 1, value) for value in values.ravel()],
                    float).reshape(values.shape)


def multiples(values, first):
    """Rounded to multiples of 2^first."""
    return np.round(np.ldexp(values, -first)) * 2.0**first + 0.0


def mesh(rng, n=4):
    points, tets = cubes((n, n, n))
    return shuffle(jitter(points, rng), tets, rng)


def scales(rng):
    """Shifts, decimal and fixed-point numbers, and multiples of powers of two."""
    points, tets = mesh(rng)
    points[rng.integers(0, len(points), 9), 1] = 0
    places = np.stack([decimals(points[:, 0] * 0.01, 4), np.round(points[:, 1], 2),
                       multiples(points[:, 2], -10)], -1)
    grid = gm.make_grid(places, tets)
    data, values = grid.GetPointData(), wave(points)
    odd = single(values).astype(float)
    odd[::9] = np.resize([np.nan, np.inf, -np.inf, -0.0, 0.0, 1e-45], odd[::9].shape)
    add(data, single(np.cos(points)).astype(float), "doubles of floats")
    add(data, np.asarray(odd, np.float32).astype(float), "odd")
    add(data, values.astype(np.float16).astype(np.float32), "halves")
    add(data, single(decimals(values * 10.0 ** rng.integers(-9, 9, len(points)), 5)), "five")
    add(data, decimals(values * 1e19, 15), "fifteen")
    # Powers of ten, some of which are rounded down.
    tens = np.array([float("1e%d" % i) for i in range(-22, 23)])
    add(data, single(np.resize(tens, len(points)) * rng.integers(-9, 10, len(points))), "one")
    add(data, np.round(values * 1e9), "large")
    add(data, np.round(values * 100 + 100, 3), "places")
    add(data, (np.arange(len(points)) * 8 - 320).astype(np.int32), "eights")
    add(data, (np.arange(len(points)) * 2**40 + 2**60).astype(np.uint64), "wide")
    add(data, np.full(len(points), -12, np.int8), "constant")
    add(data, single(multiples(values * 2.0**110, 103)), "highest of floats")
    add(data, single(multiples(values * 2.0**-110, -126)), "lowest of floats")
    add(data, multiples(values * 2.0**150, 103), "highest of doubles")
    add(data, np.stack([multiples(values, -9), values], -1), "mixed")
    add(grid.GetCellData(), multiples(values[tets].mean(1), -40), "cells")
    return grid, {"ChunkSize": 128, "KeepOrder": 7}


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
    return grids, {
        "KeyStepInterval": 5, "ChunkSize": 64, "KeepOrder": 7}


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
    return grids, {
        "KeyStepInterval": 4, "ChunkSize": 64, "KeepOrder": 7}


def wild(values):
    """The same with values that have no steps."""
    values = values.copy()
    values[::7] = np.resize([np.nan, np.inf, -np.inf, -0.0, 0.0, 1e-45, 3e38], values[::7].shape)
    return values


def grid_of_all_kinds(rng, s, n=4):
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


def bounded_errors(rng):
    """Bounds of all kinds, and a boundary."""
    return grid_of_all_kinds(rng, 0), {
        "errors": ["*=rel:1e-3,zeros", "integers=abs:20,zeros", "double=abs:1e-12,zeros",
                   "wild=pw:0.01,zeros", "vector=bits:7,zeros", "wild cells=bits:12,zeros"],
        "WriteBoundary": True, "ChunkSize": 128, "KeepOrder": 7}


def bounded_errors_at_steps(_):
    grids = [grid_of_all_kinds(np.random.default_rng(5), s, 3) for s in range(5)]
    return grids, {"errors": ["*=rel:1e-3,zeros", "wild=abs:0.01,zeros", "cells=pw:0.01,zeros"],
                   "KeyStepInterval": 4, "ChunkSize": 128, "KeepOrder": 7}


def fast_bounded_errors(rng):
    grid, options = bounded_errors(rng)
    return grid, {**options, "Profile": 1}


def fast_bounded_errors_at_steps(rng):
    grids, options = bounded_errors_at_steps(rng)
    return grids, {**options, "Profile": 1}


def smooth(points):
    """What a quadratic function predicts better than a linear one."""
    p = np.nan_to_num(points.astype(float), nan=1, posinf=2, neginf=-2) * 0.3
    return np.sin(p[:, 0]) + np.cos(p[:, 1] - p[:, 2]) + 0.2 * p[:, 0] * p[:, 2]


def quadratic_values(rng):
    """On points and cells, with and without bounds of errors."""
    points, tets = mesh(rng, 6)
    grid = gm.make_grid(single(points), tets)
    data, values = grid.GetPointData(), smooth(points)
    odd = single(values)
    odd[::19] = np.resize([np.nan, np.inf, -np.inf, -0.0, 1e-45, 3e38], odd[::19].shape)
    add(data, odd, "odd")
    add(data, np.round(values * 1e7).astype(np.int32), "integers")
    huge = values / np.abs(values).max() * 1e308
    huge[::17] *= -1
    add(data, huge, "huge")
    add(data, values, "bounded")
    add(data, values, "pointwise")
    at_cells = smooth(points[tets].mean(1))
    add(grid.GetCellData(), single(at_cells), "cells")
    add(grid.GetCellData(), at_cells, "bounded cells")
    return grid, {"KeepOrder": 7, "ChunkSize": 512, "errors": [
        "bounded=abs:1e-4", "pointwise=pw:1e-4", "bounded cells=abs:1e-4"]}


def quadratic_neighbors(rng):
    """Neighbors in planes, on lines, at one point, and at none."""
    points, tets = mesh(rng, 6)
    values = smooth(points)
    points[points[:, 2] > 5.5, 2] = 6
    points[(points[:, 0] < 1.5) & (points[:, 2] < 4), 0] = 0.5
    line = (points[:, 1] > 5.5) & (points[:, 2] < 4)
    points[line, 0] = 3
    points[line, 1] = 6
    points[(points[:, 0] > 5.5) & (points[:, 2] < 4)] = 6.5
    points[::41, 0] = np.resize([np.nan, np.inf, -np.inf, 1e300, 1e-310], points[::41, 0].shape)
    grid = gm.make_grid(points, tets)
    add(grid.GetPointData(), single(values), "values")
    add(grid.GetPointData(), values, "doubles")
    add(grid.GetCellData(), single(values[tets].mean(1)), "cells")
    return grid, {"KeepOrder": 7}


def quadric(points):
    """What a quadratic function predicts but for rounding."""
    x, y, z = points.T.astype(float)
    return 0.3 * x * x - 0.2 * x * y + 0.1 * y * z + 0.4 * z * z - x + 2 * y + 5


def quadratic_changes(_):
    """Values have noise that stays, so that changes are smoother than values."""
    points, tets = mesh(np.random.default_rng(7), 4)
    noise = np.random.default_rng(1).normal(size=len(points))
    noise_of_cells = np.random.default_rng(2).normal(size=len(tets))
    grids = []
    for s in range(4):
        grid = gm.make_grid(single(points), tets)
        values = noise + quadric(points) * s / 8
        odd = single(values)
        odd[s::31] = np.resize([np.nan, np.inf, -0.0], odd[s::31].shape)
        add(grid.GetPointData(), single(values), "floats")
        add(grid.GetPointData(), odd, "odd")
        add(grid.GetPointData(), values * (1e307 if s == 2 else 1e300), "huge")
        add(grid.GetPointData(), values, "bounded")
        add(grid.GetPointData(), single(values), "pointwise")
        odd = values.copy()
        odd[s::31] = np.resize([np.nan, np.inf, 1e300], odd[s::31].shape)
        add(grid.GetPointData(), odd, "bounded odd")
        add(grid.GetPointData(), single(smooth(points + 0.5 * s)), "values")
        at_cells = noise_of_cells + quadric(points[tets].mean(1)) * s / 8
        add(grid.GetCellData(), single(at_cells), "cells")
        grids.append(grid)
    return grids, {"errors": ["bounded=abs:1e-9", "pointwise=pw:1e-6", "bounded odd=abs:1e-9"],
        "KeyStepInterval": 3, "KeepOrder": 7, "ChunkSize": 128}


ALL = [
    palettes, value_types, attributes, names_and_keys, field_data, scales, scales_of_steps,
    copies_of_arrays, bounded_errors, bounded_errors_at_steps, fast_bounded_errors,
    fast_bounded_errors_at_steps, quadratic_values, quadratic_neighbors, quadratic_changes]
