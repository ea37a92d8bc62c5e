# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Time steps over one mesh: written from an upstream with time, read in any order, sharing points
and cells; arrays that change are an error that names the step."""

import os

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as pipeline

import gatunMeshes as gm
from gatun.vtk import vtkGatunErrorCode, vtkGatunReader, vtkGatunWriter
from gatunTimeSource import TimeSource, connect

points, tets = gm.lattice(5)
TIMES = [-1.5, 0.0, 0.1, 0.30000000000000004, 2.0, 1e3] + [2e3 + i for i in range(14)]


def step(index):
    grid = gm.make_grid(points, tets)
    gm.add_array(grid.GetPointData(), np.arange(len(points)), "point")
    gm.add_array(grid.GetPointData(), np.sin(points * (index + 1)).astype(np.float32), "wave")
    gm.add_array(grid.GetCellData(), np.arange(len(tets)), "cell")
    noise = np.random.default_rng(index).integers(0, 1 << 62, len(tets))
    gm.add_array(grid.GetCellData(), noise, "noise")
    gm.add_array(grid.GetFieldData(), np.array([index * 1.0]), "index")
    names = vtkStringArray()
    names.SetName("name")
    names.InsertNextValue("step %d" % index)
    grid.GetFieldData().AddArray(names)
    return grid


def source_of(make=step, times=TIMES):
    return TimeSource(make, times)


def write_all(path, source, **options):
    writer = vtkGatunWriter()
    connect(writer, source)
    writer.SetFileName(path)
    writer.WriteAllTimeStepsOn()
    gm.set_options(writer, **options)
    return writer


def output_at(reader, time):
    reader.UpdateTimeStep(time)
    assert reader.GetErrorCode() == 0
    return reader.GetOutput()


path = gm.temporary("time.gtn")
for interval in (1, 3, 8, 100):
    for keep, chunk in ((7, 0), (0, 200)):
        writer = write_all(path, source_of(), KeyStepInterval=interval, KeepOrder=keep, ChunkSize=chunk)
        assert writer.Write() == 1
        assert gm.statistic(writer, "TimeSteps") == len(TIMES)
        reader = vtkGatunReader()
        reader.SetFileName(path)
        reader.UpdateInformation()
        info = reader.GetOutputInformation(0)
        assert list(info.Get(pipeline.TIME_STEPS())) == TIMES
        assert list(info.Get(pipeline.TIME_RANGE())) == [TIMES[0], TIMES[-1]]
        order = list(range(len(TIMES))) + [7, 0, 19, 3, 2, 2, 18, 1]
        grids = set()
        for index in order:
            grid = output_at(reader, TIMES[index])
            assert grid.GetInformation().Get(vtkDataObject.DATA_TIME_STEP()) == TIMES[index]
            if keep:
                gm.assert_equal(step(index), grid)
            else:
                gm.assert_same_mesh(step(index), grid)
                gm.assert_same_field(step(index).GetFieldData(), grid.GetFieldData())
            # Points and cells are the very same objects, not copies.
            grids.add((grid.GetPoints().GetData().GetVoidPointer(0),
                       grid.GetCells().GetConnectivityArray().GetVoidPointer(0)))
        assert len(grids) == 1
        assert gm.statistic(reader, "DecodedChunks") == reader.GetChunkTable().GetNumberOfRows()

# One mesh in one file beats a file for each step.
alone = [gm.statistic(gm.write(step(i), gm.temporary("alone.gtn")), "FileBytes") for i in range(3)]
size = write_all(path, source_of()).Write() and os.path.getsize(path)
assert size < 20 * min(alone) * 0.9, (size, alone)

# Time between steps, before the first and after the last.
reader = vtkGatunReader()
reader.SetFileName(path)
for time, expected in ((-100, -1.5), (-1.5, -1.5), (-0.1, -1.5), (0.05, 0.0), (0.3, 0.1),
                       (1.999, 0.30000000000000004), (1e9, TIMES[-1])):
    data = output_at(reader, time).GetInformation()
    assert data.Get(vtkDataObject.DATA_TIME_STEP()) == expected

# Pieces at different times, in turn.
for time, piece in ((0.0, 0), (2.0, 1), (0.1, 0), (0.1, 1), (2.0, 1)):
    reader.UpdateTimeStep(time, piece, 2)
    cells = reader.GetOutput().GetCellData()
    if reader.GetOutput().GetNumberOfCells():
        noise = vtk_to_numpy(cells.GetArray("noise"))
        number = vtk_to_numpy(cells.GetArray("cell"))
        expected = np.random.default_rng(TIMES.index(time)).integers(0, 1 << 62, len(tets))
        assert np.array_equal(noise, expected[number])

# Deselecting arrays between steps.
reader.SetPointArrayStatus("wave", 0)
grid = output_at(reader, 2.0)
assert not grid.GetPointData().HasArray("wave") and grid.GetCellData().HasArray("noise")
reader.SetPointArrayStatus("wave", 1)
gm.assert_same_mesh(step(4), output_at(reader, 2.0))

# Without WriteAllTimeSteps the step at hand is written, with its time.
source = source_of()
writer = write_all(path, source)
writer.WriteAllTimeStepsOff()
source.UpdateTimeStep(2.0)
assert writer.Write() == 1 and gm.statistic(writer, "TimeSteps") == 1
reader = vtkGatunReader()
reader.SetFileName(path)
reader.UpdateInformation()
assert list(reader.GetOutputInformation(0).Get(pipeline.TIME_STEPS())) == [2.0]
reader.Update()
gm.assert_same_mesh(step(4), reader.GetOutput())

# A file without time has no times.
gm.write(step(0), path)
reader.UpdateInformation()
assert not reader.GetOutputInformation(0).Has(pipeline.TIME_STEPS())
reader.Update()
assert not reader.GetOutput().GetInformation().Has(vtkDataObject.DATA_TIME_STEP())
gm.assert_same_mesh(step(0), reader.GetOutput())


# What must be the same in all steps.
def fewer_arrays(index):
    grid = step(index)
    if index == 3:
        grid.GetCellData().RemoveArray("noise")
    return grid


def other_type(index):
    grid = step(index)
    if index == 3:
        grid.GetCellData().RemoveArray("noise")
        gm.add_array(grid.GetCellData(), np.zeros(len(tets), np.float32), "noise")
    return grid


def in_place():
    """The same objects at each step, changed in place."""
    grid = step(0)

    def make(index):
        raw = vtk_to_numpy(grid.GetPoints().GetData())
        raw[17, 1] = points[17, 1] if index != 3 else 7
        grid.GetPoints().Modified()
        return grid

    return make


gm.write(step(0), path)
before = open(path, "rb").read()
for make in fewer_arrays, other_type:
    writer = write_all(path, source_of(make))
    errors = gm.Errors(writer)
    assert writer.Write() == 0
    assert writer.GetErrorCode() == vtkGatunErrorCode.InvalidInputError
    said = "is missing" if make is fewer_arrays else "is float with 1 component"
    assert path in str(errors) and said in str(errors), str(errors)
    assert "in time step 3 (time 0.30000000000000004) the cell array 'noise'" in str(errors), str(errors)
    assert open(path, "rb").read() == before
    # The writer is as good as new.
    connect(writer, source_of())
    assert writer.Write() == 1 and gm.statistic(writer, "TimeSteps") == len(TIMES)
    gm.write(step(0), path)

# Arrays may come and go on request: at most one more pass, however many of them.
calls = []


def come_and_go(index):
    calls.append(index)
    grid = step(index)
    if index % 2:
        grid.GetCellData().RemoveArray("noise")
    gm.add_array(grid.GetPointData(), np.full(len(points), index), "only%d" % index)
    return grid


writer = write_all(path, source_of(come_and_go), KeepOrder=7, FillMissingArrays=True)
assert writer.Write() == 1 and calls == list(range(len(TIMES))) * 2, calls
reader = vtkGatunReader()
reader.SetFileName(path)
for index in (0, 1, 7, len(TIMES) - 1):
    output = output_at(reader, TIMES[index])
    noise = vtk_to_numpy(output.GetCellData().GetArray("noise"))
    expected = vtk_to_numpy(step(index).GetCellData().GetArray("noise"))
    assert np.array_equal(noise, 0 * expected if index % 2 else expected)
    for other in range(len(TIMES)):
        values = vtk_to_numpy(output.GetPointData().GetArray("only%d" % other))
        assert (values == (index if other == index else 0)).all()


# An empty first step takes no part in the kinds of arrays.
def begins_empty(index):
    return gm.make_grid(np.zeros((0, 3)), []) if index in (0, 2) else step(index)


assert write_all(path, source_of(begins_empty), KeepOrder=7).Write() == 1
reader = vtkGatunReader()
reader.SetFileName(path)
assert output_at(reader, TIMES[2]).GetNumberOfPoints() == 0
for index in (1, 3):
    output = output_at(reader, TIMES[index])
    assert np.array_equal(vtk_to_numpy(output.GetPointData().GetArray("point")), np.arange(len(points)))
gm.write(step(0), path)

# Points may change, even in place: the file has them at every step.
assert write_all(path, source_of(in_place()), KeepOrder=7).Write() == 1
moving = vtkGatunReader()
moving.SetFileName(path)
moving.RestoreOrderOn()
for index in (0, 3, 4, 2, 3, len(TIMES) - 1):
    expected = points.copy()
    expected[17, 1] = points[17, 1] if index != 3 else 7
    output = output_at(moving, TIMES[index])
    assert np.array_equal(vtk_to_numpy(output.GetPoints().GetData()), expected), index
gm.write(step(0), path)

# An upstream that fails where the file is begun once more, because the points move.
calls = []
make_moving = in_place()


def make_once(index):
    calls.append(index)
    return make_moving(index) if calls.count(0) == 1 else None


source = source_of(make_once)
gm.Errors(source)
writer = write_all(path, source)
errors = gm.Errors(writer)
assert writer.Write() == 0 and writer.GetErrorCode() != 0 and "not written" in str(errors)
assert calls == [0, 1, 2, 3, 0], calls
assert open(path, "rb").read() == before

# An upstream that fails in the middle.
source = source_of(lambda index: step(index) if index < 3 else None)
gm.Errors(source)
writer = write_all(path, source)
errors = gm.Errors(writer)
assert writer.Write() == 0 and writer.GetErrorCode() != 0 and "not written" in str(errors)
assert open(path, "rb").read() == before
connect(writer, source_of())
assert writer.Write() == 1 and gm.statistic(writer, "TimeSteps") == len(TIMES)
reader.Update()
gm.assert_same_mesh(step(0), output_at(reader, TIMES[0]))
