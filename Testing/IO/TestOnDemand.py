# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""On demand, the reader's output is the outline of the mesh, with the ranges of its arrays, and none
of the mesh is read; what draws the file draws the mesh."""

import os

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.util.vtkConstants import VTK_LINE, VTK_TETRA
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as pipeline

import gatunMeshes as gm
from gatun.vtk import vtkGatunReader, vtkGatunWriter
from gatunTimeSource import TimeSource, connect

points, tets = gm.lattice(16)
rng = np.random.default_rng(7)
ARRAYS = {
    "plain": points[:, 0] * 3 - 1,
    "float": (points[:, 1] ** 2).astype(np.float32),
    "vector": np.stack([points[:, 1] + 1, -2 * points[:, 1], 0.5 + points[:, 2] ** 2], 1),
    "pair": rng.random((len(points), 2)).astype(np.float32) + 2,
    "tensor": rng.random((len(points), 9)),
    "bytes": rng.integers(-100, 90, len(points), np.int8),
    "huge": np.full(len(points), np.iinfo(np.int64).max),
    "nothing": np.full(len(points), np.nan),
    "ids": np.arange(len(points)),
}
CELL_ARRAYS = {
    "cell": np.arange(len(tets)) * 2,
    "five": rng.random((len(tets), 5)) - 0.5,
}


def make_file(name):
    grid = gm.make_grid(points, tets)
    for array, values in ARRAYS.items():
        gm.add_array(grid.GetPointData(), values, array)
    for array, values in CELL_ARRAYS.items():
        gm.add_array(grid.GetCellData(), values, array)
    grid.GetPointData().SetActiveScalars("float")
    grid.GetPointData().SetActiveGlobalIds("ids")
    path = gm.temporary(name)
    gm.write(grid, path, ChunkSize=500)
    return path


def read(path, **options):
    reader = vtkGatunReader()
    reader.SetFileName(path)
    for option, value in options.items():
        getattr(reader, "Set" + option)(value)
    reader.UpdateInformation()
    reader.Update()
    assert reader.GetErrorCode() == 0
    return reader


def is_outline(reader):
    grid = reader.GetOutput()
    has_key = bool(grid.GetInformation().Has(vtkGatunReader.ON_DEMAND()))
    lines = grid.GetNumberOfCells() > 0 and grid.GetCellType(0) == VTK_LINE
    assert has_key == lines == reader.GetIsOnDemand(), (has_key, lines, reader.GetIsOnDemand())
    if has_key:
        assert (grid.GetNumberOfPoints(), grid.GetNumberOfCells()) == (8, 12)
    else:
        assert grid.GetNumberOfCells() == 0 or grid.GetCellType(0) == VTK_TETRA
    return has_key


def ranges(array, length):
    parts = range(-1 if length else 0, array.GetNumberOfComponents())
    return [array.GetRange(c) for c in parts]


path = make_file("on-demand.gtn")
mesh = read(path)
outline = read(path, LargeMesh=0)

# When there is an outline.
assert mesh.GetLargeMesh() == -1
assert not is_outline(mesh) and is_outline(outline)
assert not is_outline(read(path, LargeMesh=len(tets)))
assert is_outline(read(path, LargeMesh=len(tets) - 1))
assert not vtkGatunReader().GetIsOnDemand()
fresh = vtkGatunReader()
fresh.SetLargeMesh(0)
assert not fresh.GetIsOnDemand()  # no file yet

# The same bounds and ranges as the mesh, and the same types and names.
whole, few = mesh.GetOutput(), outline.GetOutput()
assert whole.GetBounds() == few.GetBounds()
assert whole.GetPoints().GetDataType() == few.GetPoints().GetDataType()
ends = {tuple(sorted(abs(np.subtract(few.GetPoint(c.GetPointId(0)), few.GetPoint(c.GetPointId(1))))))
        for c in (few.GetCell(i) for i in range(12))}
assert ends == {(0, 0, 1)}, ends
for data, small, names in ((whole.GetPointData(), few.GetPointData(), ARRAYS),
                           (whole.GetCellData(), few.GetCellData(), CELL_ARRAYS)):
    assert small.GetNumberOfArrays() == len(names)
    for name in names:
        big, little = data.GetArray(name), small.GetArray(name)
        assert big.GetDataType() == little.GetDataType(), name
        assert big.GetNumberOfComponents() == little.GetNumberOfComponents(), name
        if name == "nothing":
            assert np.isnan(vtk_to_numpy(little)).all()
            continue
        with_length = 1 < big.GetNumberOfComponents() <= 3 or name == "five"
        want, have = ranges(big, with_length), ranges(little, with_length)
        tolerance = 1e-6 if with_length else 1e-15
        assert np.allclose(want, have, rtol=tolerance, atol=0), (name, want, have)
        if with_length:
            assert np.array_equal(want[1:], have[1:]), (name, want, have)
assert few.GetPointData().GetScalars().GetName() == "float"
assert few.GetPointData().GetGlobalIds() is None

# Nothing is read but the tables.
tables = vtkGatunReader()
tables.SetFileName(path)
tables.UpdateInformation()
assert gm.statistic(outline, "BytesRead") == gm.statistic(tables, "BytesRead") < os.path.getsize(path) / 2
assert gm.statistic(outline, "DecodedChunks") == 0 and gm.statistic(outline, "CachedBytes") == 0
assert gm.statistic(mesh, "BytesRead") > gm.statistic(outline, "BytesRead")

# Only selected arrays.
chosen = vtkGatunReader()
chosen.SetFileName(path)
chosen.SetLargeMesh(0)
chosen.UpdateInformation()
chosen.GetPointDataArraySelection().DisableAllArrays()
chosen.SetPointArrayStatus("plain", 1)
chosen.Update()
assert chosen.GetOutput().GetPointData().GetNumberOfArrays() == 1
assert chosen.GetOutput().GetCellData().GetNumberOfArrays() == len(CELL_ARRAYS)

# Piece 0 has it; ghost levels do not matter.
for piece in range(3):
    outline.UpdatePiece(piece, 3, 1)
    grid = outline.GetOutput()
    assert (grid.GetNumberOfCells(), grid.GetNumberOfPoints()) == ((12, 8) if piece == 0 else (0, 0))
    assert grid.GetPointData().GetNumberOfArrays() == len(ARRAYS)
    assert grid.GetInformation().Has(vtkGatunReader.ON_DEMAND())

# A region of interest is a mesh, and switching leads to and fro.
reader = read(path, LargeMesh=0)
for option, region, none in (("Box", (0, 0.2, 0, 0.2, 0, 0.2), (1, -1, 1, -1, 1, -1)),
                             ("ValueRangeArray", "plain", "")):
    gm.set_options(reader, **{option: region})
    reader.Update()
    assert not is_outline(reader)
    gm.set_options(reader, **{option: none})
    reader.Update()
    assert is_outline(reader)
reader.SetLargeMesh(-1)
reader.Update()
assert not is_outline(reader)
assert reader.GetOutput().GetNumberOfCells() == len(tets)
assert gm.statistic(reader, "CachedBytes") > 0
reader.SetLargeMesh(0)
reader.Update()
assert is_outline(reader) and gm.statistic(reader, "CachedBytes") == 0

# A file that changes.
small = gm.make_grid(points * 2, tets)
gm.add_array(small.GetPointData(), points[:, 0], "plain")
gm.write(small, path, ChunkSize=500)
reader.Update()
assert reader.GetOutput().GetBounds() == (0, 2, 0, 2, 0, 2)
assert reader.GetOutput().GetPointData().GetNumberOfArrays() == 1

# Time: the ranges of the step asked for, or of the last one before it.
def step(index):
    grid = gm.make_grid(points, tets)
    gm.add_array(grid.GetPointData(), points[:, 0] * (index + 1), "ramp")
    gm.add_array(grid.GetFieldData(), np.array([index * 1.0]), "index")
    return grid


moving = gm.temporary("on-demand-steps.gtn")
writer = vtkGatunWriter()
connect(writer, TimeSource(step, [0.0, 1.0, 2.0]))
writer.SetFileName(moving)
writer.SetWriteAllTimeSteps(True)
writer.Update()
reader = read(moving, LargeMesh=0)
assert reader.GetOutputInformation(0).Length(pipeline.TIME_STEPS()) == 3
for time, index in ((2.0, 2), (0.0, 0), (1.7, 1), (-3, 0), (9, 2)):
    reader.UpdateTimeStep(time)
    grid = reader.GetOutput()
    assert is_outline(reader)
    assert grid.GetInformation().Get(vtkDataObject.DATA_TIME_STEP()) == index
    assert grid.GetPointData().GetArray("ramp").GetRange() == (0, index + 1)
    assert grid.GetFieldData().GetArray("index").GetValue(0) == index
assert gm.statistic(reader, "DecodedChunks") == 0

# Meshes without cells, and without anything.
for empty, count in ((gm.make_grid(points[:0], tets[:0]), 0), (gm.make_grid(points, tets[:0]), 8)):
    gm.write(empty, path)
    reader = read(path, LargeMesh=0)
    assert reader.GetOutput().GetNumberOfPoints() == count, reader.GetOutput().GetBounds()
