# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Points that move with time: every bit of them at every step, in any order, in pieces and regions;
cells are shared by the outputs of all steps."""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataSetAttributes, vtkUnstructuredGrid
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as pipeline

import gatunMeshes as gm
from gatun.vtk import vtkGatunErrorCode, vtkGatunReader, vtkGatunWriter
from gatunTimeSource import TimeSource, connect

STEPS = 50
TIMES = [0.25 * step for step in range(STEPS)]
STILL = (7, 16, 17, 30)
path = gm.temporary("moving.gtn")
start, tets = gm.lattice(8)


def places(step, dtype):
    """A wave that runs through a turning block, which stands still now and then."""
    while step in STILL:
        step -= 1
    x, y, z = start.astype(np.float64).T
    t = 0.03 * step
    moved = np.stack((x * np.cos(t) - y * np.sin(t), x * np.sin(t) + y * np.cos(t),
                      z + 0.1 * np.sin(4 * x + 5 * t)), 1)
    if step == 0:
        moved = start.copy()
    moved = moved.astype(dtype)
    if step > 2:
        moved[step] = (np.nan, -0.0, np.inf)
    return moved


def grid_at(step, dtype=np.float32):
    grid = gm.make_grid(places(step, dtype), tets)
    gm.add_array(grid.GetPointData(), np.sin(5 * start + 0.1 * step), "wave")
    gm.add_array(grid.GetPointData(), np.arange(len(start)), "point")
    gm.add_array(grid.GetCellData(), np.arange(len(tets)), "cell")
    return grid


def write(make, **options):
    writer = vtkGatunWriter()
    writer.SetFileName(path)
    writer.WriteAllTimeStepsOn()
    writer.SetChunkSize(300)
    gm.set_options(writer, **options)
    connect(writer, TimeSource(make, TIMES))
    return writer


def open_reader(**options):
    reader = vtkGatunReader()
    reader.SetFileName(path)
    gm.set_options(reader, **options)
    return reader


def raw(grid):
    return vtk_to_numpy(grid.GetPoints().GetData())


def same_bits(one, other):
    return one.dtype == other.dtype and one.tobytes() == other.tobytes()


rng = np.random.default_rng(5)
for dtype in (np.float32, np.float64):
    writer = write(lambda step, kind=dtype: grid_at(step, kind), KeepOrder=7)
    assert writer.Write() == 1 and gm.statistic(writer, "TimeSteps") == STEPS
    reader = open_reader(RestoreOrder=True)
    reader.UpdateInformation()
    assert np.array_equal(reader.GetOutputInformation(0).Get(pipeline.TIME_STEPS()), TIMES)
    kept = []
    for step in [*range(STEPS), *rng.permutation(STEPS).tolist(), 17, 16, 0, STEPS - 1]:
        reader.UpdateTimeStep(TIMES[step])
        output = reader.GetOutput()
        assert same_bits(raw(output), places(step, dtype)), (dtype, step)
        assert np.array_equal(gm.connectivity(output), tets)
        gm.assert_same_arrays(output.GetPointData(), grid_at(step, dtype).GetPointData())
        copy = vtkUnstructuredGrid()
        copy.ShallowCopy(output)
        kept.append((step, copy))
    # Later steps change nothing of what somebody holds, and share the cells.
    first = kept[0][1]
    for step, copy in kept:
        assert same_bits(raw(copy), places(step, dtype)), step
        assert copy.GetCells().GetConnectivityArray() is first.GetCells().GetConnectivityArray()
    # While points stand still, so do the outputs' points.
    held = dict(kept[15:18])
    assert held[16].GetPoints() is held[15].GetPoints() is held[17].GetPoints()
    assert held[15].GetPoints() is not kept[14][1].GetPoints()

# Pieces with ghosts: each point is where its number says, and owned ones are all there are.
for step in (49, 0, 16, 23):
    count = np.zeros(len(start), int)
    reader = open_reader()
    for piece in range(5):
        info = reader.GetOutputInformation(0)
        reader.UpdateInformation()
        info.Set(pipeline.UPDATE_TIME_STEP(), TIMES[step])
        reader.UpdatePiece(piece, 5, 1)
        output = reader.GetOutput()
        numbers = vtk_to_numpy(output.GetPointData().GetArray("point"))
        assert same_bits(raw(output), places(step, np.float64)[numbers]), (step, piece)
        ghosts = vtk_to_numpy(
            output.GetPointData().GetArray(vtkDataSetAttributes.GhostArrayName()))
        np.add.at(count, numbers[ghosts == 0], 1)
    assert (count == 1).all()

# A region is one of the step's points: all cells that it touches are there, and not all of the mesh.
for step in (49, 0, 20):
    now = places(step, np.float64)
    now[~np.isfinite(now)] = 1e9
    center = now[1000 % len(now)]
    box = np.stack((center - 0.05, center + 0.05), 1).ravel()
    reader = open_reader(Box=box)
    reader.UpdateInformation()
    reader.UpdateTimeStep(TIMES[step])
    output = reader.GetOutput()
    corners = now[tets]
    inside = ((corners > box[::2]) & (corners < box[1::2])).all(2).any(1)
    numbers = vtk_to_numpy(output.GetCellData().GetArray("cell"))
    assert 0 < len(numbers) < len(tets)
    assert set(np.flatnonzero(inside)) <= set(numbers), step

# What the pipeline is told covers all steps.
reader = open_reader()
reader.UpdateInformation()
everywhere = np.concatenate([places(step, np.float64) for step in range(STEPS)])
fine = np.where(np.isfinite(everywhere), everywhere, np.nan)
bounds = np.stack((np.nanmin(fine, 0), np.nanmax(fine, 0)), 1).ravel()
assert np.array_equal(reader.GetOutputInformation(0).Get(pipeline.BOUNDS()), bounds)
table = vtk_to_numpy(reader.GetChunkTable().GetColumnByName("Bounds"))
assert np.array_equal(np.stack((table[:, ::2].min(0), table[:, 1::2].max(0)), 1).ravel(), bounds)

# The outline on demand is that of the step.
reader = open_reader(LargeMesh=0)
for step in (0, 33, 12):
    reader.UpdateTimeStep(TIMES[step])
    now = places(step, np.float64)
    now = np.where(np.isfinite(now), now, np.nan)
    assert np.allclose(reader.GetOutput().GetBounds(),
                       np.stack((np.nanmin(now, 0), np.nanmax(now, 0)), 1).ravel(), 0, 0)

# With a hierarchy, points that remain are where they are in the mesh, at any step.
assert write(lambda step: grid_at(step, np.float64), Hierarchy=True, Levels=2,
             WriteBoundary=True).Write() == 1
reader = open_reader(SimplificationRatio=0.6)
for step in (0, 41, 17, 3):
    reader.UpdateTimeStep(TIMES[step])
    output = reader.GetOutput()
    numbers = vtk_to_numpy(output.GetPointData().GetArray("point"))
    assert 0 < len(numbers) < 0.7 * len(start)
    assert same_bits(raw(output), places(step, np.float64)[numbers]), step

# The boundary on demand.
reader = open_reader(LargeMesh=0)
for step in (0, 41, 17, 3):
    reader.UpdateTimeStep(TIMES[step])
    output = reader.GetOutput()
    numbers = vtk_to_numpy(output.GetPointData().GetArray("point"))
    shown = raw(output)[:-8]
    assert len(shown) > 100
    assert same_bits(shown, places(step, np.float64)[numbers[:-8].astype(int)]), step

# Rounded coordinates stay within the error at every step, and take less room.
exact = write(lambda step: gm.make_grid(places(step % 3, np.float64), tets), KeepOrder=7)
assert exact.Write() == 1
rounded = write(lambda step: gm.make_grid(places(step % 3, np.float64), tets), KeepOrder=7,
                PointTolerance=(1, 1e-4))
assert rounded.Write() == 1
assert gm.statistic(rounded, "GeometryBytes") < 0.7 * gm.statistic(exact, "GeometryBytes")
reader = open_reader(RestoreOrder=True)
for step in range(4):
    reader.UpdateTimeStep(TIMES[step])
    assert np.abs(raw(reader.GetOutput()) - places(step % 3, np.float64)).max() <= 1e-4

# In pieces, moving points are refused.
pieces = write(grid_at, NumberOfPieces=3)
errors = gm.Errors(pieces)
assert pieces.Write() == 0
assert pieces.GetErrorCode() == vtkGatunErrorCode.InvalidInputError
assert "points that move" in str(errors), str(errors)
