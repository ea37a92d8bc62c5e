# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The next time step is decoded in the background: the output is the same, and what was decoded ahead is
not read again."""

import time

import numpy as np

import gatunMeshes as gm
from gatun.vtk import vtkGatunReader, vtkGatunWriter
from gatunTimeSource import TimeSource, connect

points, tets = gm.lattice(12)
TIMES = [float(i) for i in range(12)]


def step(index):
    grid = gm.make_grid(points, tets)
    gm.add_array(grid.GetPointData(), np.sin(points * (index + 1)).astype(np.float32), "wave")
    noise = np.random.default_rng(index).integers(0, 1 << 62, len(tets))
    gm.add_array(grid.GetCellData(), noise, "noise")
    return grid


path = gm.temporary("prefetch.gtn")
writer = vtkGatunWriter()
connect(writer, TimeSource(step, TIMES))
writer.SetFileName(path)
writer.WriteAllTimeStepsOn()
writer.SetKeepOrder(7)
writer.SetChunkSize(1000)
assert writer.Write() == 1


def open_reader(prefetch=True, **options):
    reader = vtkGatunReader()
    reader.SetFileName(path)
    reader.SetPrefetchTimeSteps(prefetch)
    gm.set_options(reader, **options)
    return reader


def read(reader, index, *piece):
    reader.UpdateTimeStep(TIMES[index], *piece)
    assert reader.GetErrorCode() == 0
    return reader.GetOutput()


def wait(reader):
    """Until nothing was read for some time."""
    last, since = -1, time.monotonic()
    while time.monotonic() < since + 0.5:
        if gm.statistic(reader, "BytesRead") != last:
            last, since = gm.statistic(reader, "BytesRead"), time.monotonic()
        time.sleep(0.02)


# The same output in any order, at once and after a while.
reader = open_reader()
assert not vtkGatunReader().GetPrefetchTimeSteps()
rng = np.random.default_rng(1)
for index in [*range(12), *range(11, -1, -1), *rng.permutation(12).tolist()]:
    gm.assert_equal(step(index), read(reader, index))


def bytes_of(reader, index):
    """What a step reads."""
    before = gm.statistic(reader, "BytesRead")
    read(reader, index)
    return gm.statistic(reader, "BytesRead") - before


# Forward and backward, the next step is there.
for first, second, following in ((2, 3, 4), (9, 8, 7)):
    reader = open_reader()
    for index in (first, second):
        read(reader, index)
        wait(reader)
    reader.PrefetchTimeStepsOff()
    assert bytes_of(reader, following) == 0, (first, second)
    gm.assert_equal(step(following), read(reader, following))
plain = open_reader(prefetch=False)
read(plain, 0)
wait(plain)
assert bytes_of(plain, 1) > 1000

# Nothing is decoded ahead at the last step, without room, and without arrays.
for index, options in ((11, {}), (3, {"MemoryBudget": 0})):
    reader = open_reader(**options)
    read(reader, index)
    before = gm.statistic(reader, "BytesRead")
    wait(reader)
    assert gm.statistic(reader, "BytesRead") == before
reader = open_reader()
reader.UpdateInformation()
reader.SetPointArrayStatus("wave", 0)
reader.SetCellArrayStatus("noise", 0)
read(reader, 3)
before = gm.statistic(reader, "BytesRead")
wait(reader)
assert gm.statistic(reader, "BytesRead") == before

# Only the chunks of the piece.
reader = open_reader()
read(reader, 3, 0, 8, 0)
wait(reader)
part = gm.statistic(reader, "BytesRead")
whole = open_reader()
read(whole, 3)
wait(whole)
assert part < 0.5 * gm.statistic(whole, "BytesRead")

# In the middle of it: another file, another budget, the end.
for _ in range(20):
    reader = open_reader()
    read(reader, 3)
    reader.SetMemoryBudget(1)
    reader.SetFileName(gm.temporary("none.gtn"))
    reader.SetFileName(path)
    read(reader, 5)
    del reader
