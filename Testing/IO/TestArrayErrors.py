# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Arrays with a bounded error: every value is within it in all ways to read a file, what must be exact
is, and wrong bounds are refused."""

from fractions import Fraction
import os

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray

import gatunMeshes as gm
from gatun.vtk import vtkGatunReader, vtkGatunWriter

KEEP_ALL = 7
path = gm.temporary("errors.gtn")
rng = np.random.default_rng(4)
grid = gm.block(n=10)
points, cells = grid.GetNumberOfPoints(), grid.GetNumberOfCells()
for name in [grid.GetPointData().GetArrayName(i)
             for i in range(grid.GetPointData().GetNumberOfArrays())]:
    grid.GetPointData().RemoveArray(name)
place = gm.vtk_to_numpy(grid.GetPoints().GetData()).astype(float)


def add(where, name, values):
    array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
    array.SetName(name)
    where.AddArray(array)


smooth = np.sin(5 * place[:, 0]) * np.cos(3 * place[:, 1]) + 0.1 * place[:, 2]
add(grid.GetPointData(), "smooth", smooth.astype(np.float32))
add(grid.GetPointData(), "vector", np.stack([smooth, 1e8 * smooth ** 3, rng.normal(size=points)], 1))
wild = np.exp(rng.uniform(-700, 700, points)) * rng.choice([-1, 1], points)
wild[:9] = (np.nan, np.inf, -np.inf, -0.0, 0.0, 5e-324, -2.5e-310, 1.7e308, -1.7e308)
wild.view(np.uint64)[9] = 0x7FF4DEADBEEF0001
add(grid.GetPointData(), "wild", wild)
add(grid.GetPointData(), "mask", np.where(smooth > 0, smooth, 0))
add(grid.GetCellData(), "count", rng.integers(-2**31, 2**31, cells).astype(np.int32))
add(grid.GetCellData(), "energy", rng.lognormal(0, 8, cells))
ids = numpy_to_vtkIdTypeArray(np.arange(points, dtype=np.int64), deep=True)
ids.SetName("ids")
grid.GetPointData().SetGlobalIds(ids)
names = ("smooth", "vector", "wild", "mask", "count", "energy")


def array_of(data, name):
    return gm.vtk_to_numpy(data.GetPointData().GetArray(name) or data.GetCellData().GetArray(name))


def largest_allowed(kind, bound, value, spread):
    """Exact: fractions of the numbers that are stored."""
    if kind == "abs":
        return Fraction(bound)
    if kind == "rel":
        return Fraction(bound) * spread
    if kind == "pw":
        return Fraction(bound) * abs(value)
    # Half a unit of the last of so many digits.
    exponent = np.frexp(float(value))[1] - 1
    return Fraction(2) ** int(exponent - bound) if value else Fraction(0)


def require_within(before, after, kind, bound):
    for a, b in zip(before.reshape(points if len(before) == points else cells, -1).T,
                    after.reshape(len(after), -1).T):
        finite = np.isfinite(a)
        exact = a[~finite], b[~finite]
        assert exact[0].tobytes() == exact[1].tobytes(), "NaN or infinity"
        assert np.isfinite(b[finite]).all()
        spread = Fraction(a[finite].max().item()) - Fraction(a[finite].min().item())
        for x, y in zip(a[finite], b[finite]):
            x, y = Fraction(x.item()), Fraction(y.item())
            assert abs(x - y) <= largest_allowed(kind, bound, x, spread), (kind, bound, float(x), float(y))


def write(errors, **options):
    writer = vtkGatunWriter()
    writer.SetInputData(grid)
    writer.SetFileName(path)
    gm.set_options(writer, **{"KeepOrder": KEEP_ALL, "ChunkSize": 1200, **options})
    for error in errors:
        gm.set_tolerance(writer, error)
    assert writer.Write() == 1
    return os.path.getsize(path)


lossless = write([])
gm.assert_same_arrays(gm.read(path).GetPointData(), grid.GetPointData())
for kind, bounds in {"abs": (0.5, 1e-3, 1e-320, 1e300), "rel": (0.1, 1e-3, 1e-9), "pw": (0.3, 1e-6),
                     "bits": (1, 12, 52)}.items():
    for bound in bounds:
        for options in {}, {"Hierarchy": True, "Levels": 3, "WriteBoundary": True}:
            chosen = [name for name in names if name != "count" or kind in ("abs", "rel")]
            if bound == 1e300:
                chosen.remove("smooth")  # more than any number of single precision
            size = write([f"{name}={kind}:{bound!r}" for name in chosen], **options)
            back = gm.read(path)
            for name in names:
                before, after = array_of(grid, name), array_of(back, name)
                assert before.dtype == after.dtype
                if name in chosen:
                    require_within(before, after, kind, bound)
                else:
                    assert before.tobytes() == after.tobytes(), name
            assert array_of(back, "ids").tobytes() == array_of(grid, "ids").tobytes()
            assert back.GetPointData().GetGlobalIds() is not None
            if bound in (1e-3, 12):
                assert size < (1.5 if options else 0.8) * lossless, (kind, bound, size, lossless)

# Zeros on request.
zeros = array_of(grid, "mask") == 0
for keeps in True, False:
    write(["mask=abs:0.25" + ",zeros" * keeps])
    mask = array_of(gm.read(path), "mask")
    assert np.all(mask[zeros] == 0) == keeps
    require_within(array_of(grid, "mask"), mask, "abs", 0.25)

# Pieces and one array of them have the values of the whole.
write(["*=rel:1e-3"])
whole = array_of(gm.read(path), "smooth")
assert len(np.unique(whole)) > 100
reader = vtkGatunReader()
reader.SetFileName(path)
seen = 0
for piece in range(3):
    reader.UpdatePiece(piece, 3, 0)
    part = reader.GetOutput()
    values = array_of(part, "smooth")
    number = array_of(part, "ids")
    assert np.array_equal(values, whole[number])
    seen += part.GetNumberOfCells()
assert seen == cells

# What is wrong is told, and the file stays.
before = open(path, "rb").read()
for error, says in (("smooth=abs:0", "above 0"), ("smooth=abs:-1", "above 0"),
                    ("smooth=abs:nan", "above 0"), ("smooth=abs:inf", "above 0"),
                    ("smooth=rel:2", "at most 1"), ("smooth=pw:1", "below 1"),
                    ("smooth=bits:0", "above 0"), ("smooth=bits:53", "from 1 to 52"),
                    ("smooth=bits:2.5", "from 1 to 52"), ("nobody=abs:1", "nobody"),
                    ("=abs:1", "''"), ("smooth=abs:1e300", "smooth"), ("ids=abs:1", "ids"),
                    ("count=pw:0.1", "count")):
    writer = vtkGatunWriter()
    writer.SetInputData(grid)
    writer.SetFileName(path)
    gm.set_tolerance(writer, error)
    messages = gm.Errors(writer)
    assert writer.Write() == 0, error
    assert says in str(messages), (error, str(messages))
    assert open(path, "rb").read() == before
for kind in -1, 5, 1 << 20:
    writer.ClearArrayTolerances()
    writer.SetArrayTolerance("smooth", kind, 0.1)
    messages = gm.Errors(writer)
    assert writer.Write() == 0 and "unknown kind" in str(messages), str(messages)
# The last one of a name holds, and none takes it back.
writer.SetArrayTolerance("smooth", writer.TOLERANCE_ABSOLUTE, 0.5)
writer.SetArrayTolerance("smooth", writer.TOLERANCE_NONE, 0)
assert writer.Write() == 1
gm.assert_same_mesh(gm.read(path), grid)
writer.SetArrayTolerance("smooth", writer.TOLERANCE_ABSOLUTE, 0)
writer.ClearArrayTolerances()
assert writer.Write() == 1
