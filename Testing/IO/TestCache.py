# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Chunks that were decoded are kept: pieces, arrays and time steps do not decode them again, as far
as MemoryBudget allows; the output is the same whatever it is."""

import os

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid

import gatunMeshes as gm
from gatun.vtk import vtkGatunReader

PIECES = 8
points, tets = gm.lattice(20)
grid = gm.make_grid(points, tets)
gm.add_array(grid.GetPointData(), np.sin(5 * points), "wave")
gm.add_array(grid.GetPointData(), np.arange(len(points)), "point")
gm.add_array(grid.GetCellData(), np.random.default_rng(1).random((len(tets), 4)), "noise")
path = gm.temporary("cache.gtn")


def new_reader(size=None):
    made = vtkGatunReader()
    if size is not None:
        made.SetMemoryBudget(size)
    made.SetFileName(path)
    made.UpdateInformation()
    return made


def sweep(reader, ghosts):
    """Copies of all pieces, and the bytes read and the chunks decoded for them."""
    read, decoded = gm.statistic(reader, "BytesRead"), gm.statistic(reader, "DecodedChunks")
    copies = []
    for piece in range(PIECES):
        reader.UpdatePiece(piece, PIECES, ghosts)
        assert reader.GetErrorCode() == 0
        assert gm.statistic(reader, "CachedBytes") <= reader.GetMemoryBudget() << 20
        copies.append(vtkUnstructuredGrid())
        copies[-1].DeepCopy(reader.GetOutput())
    return copies, gm.statistic(reader, "BytesRead") - read, gm.statistic(reader, "DecodedChunks") - decoded


assert vtkGatunReader().GetMemoryBudget() == 512
assert gm.statistic(vtkGatunReader(), "CachedBytes") == gm.statistic(vtkGatunReader(), "DecodedChunks") == 0

for keep in (0, 7):
    gm.write(grid, path, ChunkSize=500, KeepOrder=keep)

    # Ghost cells are chunks of other pieces: each is decoded once.
    reader = new_reader()
    chunks = reader.GetChunkTable().GetNumberOfRows()
    assert chunks >= 5 * PIECES
    right, read, decoded = sweep(reader, 1)
    assert decoded == chunks
    assert read < os.path.getsize(path)
    again, read, decoded = sweep(reader, 1)
    assert read == 0 and decoded == 0
    more = sweep(reader, 2)
    assert more[1] == 0 and more[2] == 0
    # The whole, its order and its global ids are there as well.
    reader.UpdatePiece(0, 1, 0)
    assert gm.statistic(reader, "DecodedChunks") == chunks
    if keep:
        gm.assert_equal(grid, reader.GetOutput())
    else:
        gm.assert_same_mesh(grid, reader.GetOutput())

    # Less memory or none: the same, but slower.
    for size in (0, 1, 2):
        small = new_reader(size)
        copies, read, decoded = sweep(small, 1)
        for one, other, third in zip(right, copies, again):
            gm.assert_equal(one, other)
            gm.assert_equal(one, third)
        assert decoded > chunks and read > os.path.getsize(path) // 2
    assert sweep(new_reader(0), 1)[2] > sweep(new_reader(2), 1)[2]

# A whole mesh without time steps is read past the cache, which keeps shared points only.
reader = new_reader()
reader.Update()
whole = gm.statistic(reader, "CachedBytes")
assert gm.statistic(reader, "DecodedChunks") == chunks
gm.assert_equal(grid, reader.GetOutput())

# Its size is not a modification, and holds at once.
reader = new_reader()
sweep(reader, 1)
reader.UpdatePiece(0, 1, 0)
time, full = reader.GetMTime(), gm.statistic(reader, "CachedBytes")
output = reader.GetOutput().GetMTime()
assert full > 2 << 20 and full > 10 * whole
for size in (2, 0, -5):
    reader.SetMemoryBudget(size)
    assert reader.GetMemoryBudget() == max(0, size)
    assert gm.statistic(reader, "CachedBytes") <= max(0, size) << 20
reader.Update()
assert reader.GetMTime() == time and reader.GetOutput().GetMTime() == output

# The first change of arrays decodes the meshes once more, and from then on they are kept. Arrays
# that were read before are not read again.
reader = new_reader()
reader.SetCellArrayStatus("noise", 0)
reader.Update()
assert gm.statistic(reader, "DecodedChunks") == chunks
reader.SetPointArrayStatus("wave", 0)
reader.Update()
assert gm.statistic(reader, "DecodedChunks") == 2 * chunks
reader.SetPointArrayStatus("wave", 1)
reader.Update()
read, decoded = gm.statistic(reader, "BytesRead"), gm.statistic(reader, "DecodedChunks")
reader.SetCellArrayStatus("noise", 1)
reader.Update()
assert gm.statistic(reader, "DecodedChunks") == decoded == 2 * chunks
noise = gm.statistic(reader, "BytesRead") - read
assert noise > 0
for name in ("wave", "point"):
    reader.SetPointArrayStatus(name, 0)
reader.Update()
for name in ("wave", "point"):
    reader.SetPointArrayStatus(name, 1)
reader.Update()
assert gm.statistic(reader, "BytesRead") - read == noise
gm.assert_equal(grid, reader.GetOutput())

# A file that changes: nothing of the old one is left.
other_points, other_tets = gm.lattice(8, seed=9)
other = gm.make_grid(other_points, other_tets)
gm.add_array(other.GetPointData(), np.cos(5 * other_points), "wave")
gm.write(other, path, ChunkSize=500, KeepOrder=7)
reader.Update()
gm.assert_equal(other, reader.GetOutput())
assert 0 < gm.statistic(reader, "DecodedChunks") <= reader.GetChunkTable().GetNumberOfRows()
assert 0 < gm.statistic(reader, "CachedBytes") < full

# So after an error.
content = open(path, "rb").read()
errors = gm.Errors(reader)
open(path, "wb").write(content[:len(content) // 2])
reader.Update()
assert reader.GetErrorCode() != 0 and str(errors)
assert gm.statistic(reader, "CachedBytes") == 0
open(path, "wb").write(content)
reader.Update()
assert reader.GetErrorCode() == 0
gm.assert_equal(other, reader.GetOutput())
