# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Coordinates that are rounded by request: within the error that was asked for, the same everywhere,
and nothing else changes."""

import os

import numpy as np

import gatunMeshes as gm
import gatunPolyData as pd

KEEP_ALL = 7
path = gm.temporary("rounded.gtn")
rng = np.random.default_rng(0)


def differences(one, other):
    a, b = (gm.vtk_to_numpy(data.GetPoints().GetData()) for data in (one, other))
    fine = np.isfinite(a)
    assert np.array_equal(a[~fine].view("u%d" % a.itemsize), b[~fine].view("u%d" % a.itemsize))
    return np.abs(a[fine].astype(float) - b[fine].astype(float)).max()


for dtype in (np.float32, np.float64):
    for scale, offset in ((1, 0), (1e-6, 1e-7), (1e5, 3e6), (1e-3, -7)):
        surface = pd.add_arrays(pd.wave(40, dtype))
        points = gm.vtk_to_numpy(surface.GetPoints().GetData())
        points[:] = points * scale * rng.uniform(0.9, 1.1, points.shape) + offset
        points[7] = (np.nan, -np.inf, -0.0)
        for error in (0.3 * scale, 1e-3 * scale, 1e-12, 1e300, 5e-324):
            writer = gm.write(surface, path, KeepOrder=KEEP_ALL, PointTolerance=(1, error))
            back = pd.read(path)
            found = differences(surface, back)
            assert found <= error, (dtype, scale, error, found)
            assert found == gm.statistic(writer, "PointError"), (found, gm.statistic(writer, "PointError"))
            assert pd.cells_of(back) == pd.cells_of(surface)
            gm.assert_same_arrays(back.GetPointData(), surface.GetPointData())
            # Once more changes nothing.
            again = gm.write(back, gm.temporary("again.gtn"), PointTolerance=(1, error))
            assert gm.statistic(again, "PointError") == 0
        for bits in (1, 10, 31):
            writer = gm.write(surface, path, KeepOrder=KEEP_ALL, PointTolerance=(4, bits))
            found = differences(surface, pd.read(path))
            fine = np.where(np.isfinite(points), points, np.nan).astype(float)
            step = (np.nanmax(fine, 0) - np.nanmin(fine, 0)).max() / (2 ** bits - 1)
            rounding = np.nanmax(np.abs(fine)) * np.finfo(dtype).eps
            assert found <= step / 2 + rounding, (dtype, scale, bits, found, step)
            assert found == gm.statistic(writer, "PointError")

# Grids, too. Few places make a small file.
grid = gm.block(n=12)
exact = gm.statistic(gm.write(grid, path), "FileBytes")
rounded = gm.write(grid, path, PointTolerance=(1, 0.01), KeepOrder=KEEP_ALL)
assert gm.statistic(rounded, "PointError") <= 0.01
assert differences(grid, gm.read(path)) <= 0.01
assert gm.statistic(gm.write(grid, path, PointTolerance=(4, 8)), "GeometryBytes") < 0.7 * gm.statistic(gm.write(
    grid, path), "GeometryBytes")
assert os.path.getsize(path) == exact

# A number of bits: so many places on the longest side.
surface = pd.wave(40)
gm.write(surface, path, PointTolerance=(4, 4))
given, places = (
    gm.vtk_to_numpy(data.GetPoints().GetData()) for data in (surface, pd.read(path)))
longest = np.ptp(given, 0).argmax()
assert len(np.unique(places[:, longest])) == 16
assert places[:, longest].min() == given[:, longest].min()

# Integers stay.
whole = pd.make(rng.integers(-50, 50, (30, 3)).astype(np.int32), Polys=[[0, 1, 2]])
assert gm.statistic(gm.write(whole, path, PointTolerance=(1, 10.0)), "PointError") == 0

# So do many places, whatever the sign of zeros.
surface = pd.wave(60)
points = gm.vtk_to_numpy(surface.GetPoints().GetData())
points += rng.uniform(-0.3, 0.3, points.shape).astype(points.dtype) * np.ptp(points, 0) / 60
points -= points[0]
points[1], points[2] = (0.0, -0.0, 0.0), (-0.0, 0.0, -0.0)
exact = gm.statistic(gm.write(surface, path), "GeometryBytes")
rounded = gm.statistic(gm.write(surface, path, PointTolerance=(4, 14)), "GeometryBytes")
assert rounded < 0.6 * exact, (rounded, exact)
read = gm.vtk_to_numpy(pd.read(path).GetPoints().GetData())
assert not np.signbit(read[read == 0]).any()
