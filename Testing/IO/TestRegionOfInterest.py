# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""A box or a value range reads fewer bytes, and loses no cell that is inside."""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

import gatunMeshes as gm
from gatun.vtk import vtkGatunErrorCode, vtkGatunReader

points, tets = gm.lattice(16)
grid = gm.make_grid(points, tets)
rng = np.random.default_rng(4)
ramp = points[:, 0].astype(np.float64) * 10
vector = np.stack([points[:, 1], -2 * points[:, 1], 0 * points[:, 1]], 1).astype(np.float32)
gm.add_array(grid.GetPointData(), ramp, "ramp")
gm.add_array(grid.GetPointData(), vector, "vector")
gm.add_array(grid.GetPointData(), rng.random((len(points), 3)), "noise")
gm.add_array(grid.GetCellData(), np.arange(len(tets)), "cell")
gm.add_array(grid.GetCellData(), points[tets].mean(1)[:, 2], "height")
path = gm.temporary("region.gtn")
gm.write(grid, path, ChunkSize=500)


def cells_and_bytes(**options):
    reader = vtkGatunReader()
    reader.SetFileName(path)
    reader.UpdateInformation()
    gm.set_options(reader, **options)
    before = gm.statistic(reader, "BytesRead")
    reader.Update()
    assert reader.GetErrorCode() == 0
    cells = reader.GetOutput().GetCellData().GetArray("cell")
    ids = vtk_to_numpy(cells) if cells and cells.GetNumberOfTuples() else np.zeros(0, int)
    return set(ids), gm.statistic(reader, "BytesRead") - before


everything, all_bytes = cells_and_bytes()
assert everything == set(range(len(tets)))
assert all_bytes > 0


def check(inside, fraction, **options):
    cells, size = cells_and_bytes(**options)
    assert set(np.flatnonzero(inside)) <= cells
    assert len(cells) < fraction * len(tets), len(cells) / len(tets)
    assert size < 1.5 * fraction * all_bytes, (size, all_bytes)


corners = points[tets]
low, high = corners.min(1), corners.max(1)
box = (0.1, 0.2, 0.3, 0.4, 0.0, 1.0)
touches = ((low <= box[1::2]) & (high >= box[::2])).all(1)
check(touches, 0.5, Box=box)
# A minimum above its maximum is no box, on any axis.
for axis in range(3):
    none = list(box)
    none[2 * axis:2 * axis + 2] = 1, -1
    assert cells_and_bytes(Box=tuple(none))[0] == everything
assert cells_and_bytes(Box=(2, 3, 0, 1, 0, 1))[0] == set()
assert cells_and_bytes(Box=(-1, 2, -1, 2, -1, 2))[0] == everything
# A box that no chunk's inside touches, only its bounds.
check(low[:, 0] <= 0, 0.5, Box=(-1, 0, -9, 9, -9, 9))

values = ramp[tets]
inside = (values.min(1) <= 3.5) & (values.max(1) >= 3.4)
of_ramp = dict(ValueRangeArray="ramp", ValueRange=(3.4, 3.5))
check(inside, 0.5, **of_ramp)
assert cells_and_bytes(ValueRange=(3.4, 3.5))[0] == everything
assert cells_and_bytes(ValueRangeArray="ramp", ValueRange=(11, 12))[0] == set()

length = np.sqrt((vector.astype(np.float64) ** 2).sum(1))[tets]
inside = (length.min(1) <= 0.6) & (length.max(1) >= 0.5)
check(inside, 0.6, ValueRangeArray="vector", ValueRange=(0.5, 0.6))
height = points[tets].mean(1)[:, 2]
check((height >= 0.5) & (height <= 0.55), 0.6, ValueRangeArray="height",
      ValueRange=(0.5, 0.55))
# Both at once.
check(touches & (ramp[tets].min(1) <= 1.6) & (ramp[tets].max(1) >= 1.5), 0.4, Box=box,
      ValueRangeArray="ramp", ValueRange=(1.5, 1.6))

# Fewer arrays, fewer bytes; the array of the range need not be read.
reader = vtkGatunReader()
reader.SetFileName(path)
reader.SetPointArrayStatus("noise", 0)
reader.SetPointArrayStatus("ramp", 0)
reader.SetValueRangeArray("ramp")
reader.SetValueRange(3.4, 3.5)
reader.Update()
assert not reader.GetOutput().GetPointData().HasArray("ramp")
assert 0 < reader.GetOutput().GetNumberOfCells() < len(tets)
reader.SetValueRangeArray(None)
before = gm.statistic(reader, "BytesRead")
reader.Update()
assert gm.statistic(reader, "BytesRead") - before < 0.7 * all_bytes

# Pieces of a region are that region.
part = cells_and_bytes(**of_ramp)[0]
reader = vtkGatunReader()
reader.SetFileName(path)
reader.SetValueRangeArray("ramp")
reader.SetValueRange(3.4, 3.5)
seen = []
for piece in range(3):
    reader.UpdatePiece(piece, 3, 0)
    seen.extend(vtk_to_numpy(reader.GetOutput().GetCellData().GetArray("cell")))
assert len(seen) == len(part) and set(seen) == part

# An array that is not there.
reader = vtkGatunReader()
errors = gm.Errors(reader)
reader.SetFileName(path)
reader.SetValueRangeArray("heights")
reader.Update()
assert reader.GetErrorCode() == vtkGatunErrorCode.InvalidInputError
assert path in str(errors) and "no array 'heights'" in str(errors), str(errors)
assert reader.GetOutput().GetNumberOfCells() == 0
