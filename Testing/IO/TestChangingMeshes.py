# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Series whose mesh changes: every step is the grid that was written, whatever the order of reading;
meshes that return are not written again; pieces, on demand, contours, simplification and regions of
interest take the mesh of the step."""

import os

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON, VTK_WEDGE, vtkDataObject
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline
from vtkmodules.vtkCommonMisc import vtkErrorCode

import gatunMeshes as gm
from gatun.vtk import (
    vtkGatunContour, vtkGatunReader, vtkGatunSimplify, vtkGatunWriter)
from gatunTimeSource import TimeSource, connect

LATTICES = [gm.lattice(n) for n in (7, 9, 5)]
# The mesh of each step: the first one returns twice, and the third one follows another one again.
MESHES = [0, 0, 1, 1, 0, 2, 2, 0, 1, 2]
TIMES = [0.5 * i - 1 for i in range(len(MESHES))]
# Of those that return, only the first mesh is not written again.
WRITTEN = [0, 0, 1, 1, 0, 2, 2, 0, 3, 4]


def step(index, lattices=tuple(LATTICES)):
    points, tets = lattices[MESHES[index]]
    grid = gm.make_grid(points, tets)
    wave = np.sin(points.astype(float) * 3 + index).sum(axis=1).astype(np.float32)
    gm.add_array(grid.GetPointData(), wave, "wave")
    gm.add_array(grid.GetCellData(), np.arange(len(tets)) * (index + 1), "cell")
    gm.add_array(grid.GetFieldData(), np.array([index * 1.0]), "index")
    return grid


def write(path, make=step, times=TIMES, **options):
    writer = vtkGatunWriter()
    connect(writer, TimeSource(make, times))
    writer.SetFileName(path)
    writer.WriteAllTimeStepsOn()
    gm.set_options(writer, **options)
    assert writer.Write() == 1
    assert gm.statistic(writer, "FileBytes") == os.path.getsize(path)
    return writer


def open_reader(path, **options):
    reader = vtkGatunReader()
    reader.SetFileName(path)
    gm.set_options(reader, **options)
    return reader


path = gm.temporary("changing_meshes.gtn")
rng = np.random.default_rng(4)
for keep, chunk in ((7, 0), (0, 200)):
    writer = write(path, KeepOrder=keep, ChunkSize=chunk)
    assert gm.statistic(writer, "Meshes") == max(WRITTEN) + 1
    assert gm.statistic(writer, "TimeSteps") == len(TIMES)
    lattices = [LATTICES[i] for i in (0, 1, 2, 1, 2)]
    assert gm.statistic(writer, "Points") == sum(len(points) for points, _ in lattices)
    assert gm.statistic(writer, "Cells") == sum(len(tets) for _, tets in lattices)
    sizes = [gm.statistic(writer, what + "Bytes") for what in (
        "Connectivity", "Geometry", "Order", "Array", "FieldData", "OtherMesh", "Directory")]
    assert all(sizes[i] > 0 for i in (0, 1, 3, 4, 5, 6)) and sum(sizes) == gm.statistic(writer, "FileBytes")

    reader = open_reader(path)
    reader.UpdateInformation()
    info = reader.GetOutputInformation(0)
    assert list(info.Get(Pipeline.TIME_STEPS())) == TIMES
    order = list(range(len(TIMES))) + list(rng.permutation(len(TIMES))) + [5, 5, 6, 0]
    for index in order:
        reader.UpdateTimeStep(TIMES[index])
        assert reader.GetErrorCode() == 0
        grid = reader.GetOutput()
        assert grid.GetInformation().Get(vtkDataObject.DATA_TIME_STEP()) == TIMES[index]
        (gm.assert_equal if keep else gm.assert_same_mesh)(step(index), grid)
        gm.assert_same_field(step(index).GetFieldData(), grid.GetFieldData())
        # The table of chunks is that of the mesh.
        cells = vtk_to_numpy(reader.GetChunkTable().GetColumnByName("Cells"))
        assert cells.sum() == grid.GetNumberOfCells()

# Steps of a mesh share its points and cells.
reader.UpdateTimeStep(TIMES[5])
first = reader.GetOutput().GetPoints().GetData().GetVoidPointer(0)
decoded = gm.statistic(reader, "DecodedChunks")
reader.UpdateTimeStep(TIMES[6])
assert reader.GetOutput().GetPoints().GetData().GetVoidPointer(0) == first
assert gm.statistic(reader, "DecodedChunks") == decoded

# Between the times.
for time, index in ((-100, 0), (-0.26, 1), (0, 2), (0.26, 2), (1.49, 4), (1.5, 5), (1e9, 9)):
    reader.UpdateTimeStep(time)
    gm.assert_same_mesh(step(index), reader.GetOutput())

# Pieces of the mesh of the step, with one layer of ghosts or none.
for index in (9, 0, 4, 2):
    for ghosts in (0, 1):
        count = 0
        for piece in range(3):
            reader.UpdateTimeStep(TIMES[index], piece, 3, ghosts)
            cells = reader.GetOutput().GetCellData()
            marks = cells.GetArray("vtkGhostType")
            own = vtk_to_numpy(marks) == 0 if marks else np.ones(reader.GetOutput().GetNumberOfCells())
            count += int(own.sum())
        assert count == step(index).GetNumberOfCells()

# On demand, consumers take the mesh of the time from the file; the reader gives its outline.
demand = open_reader(path, LargeMesh=0)
for source in demand, open_reader(path):
    contour = vtkGatunContour()
    contour.SetInputConnection(source.GetOutputPort())
    contour.SetInputArrayToProcess(0, 0, 0, 0, "wave")
    contour.SetValue(0, 0.4)
    for index in (0, 2, 5, 9, 4, 8):
        expected = vtkGatunContour()
        expected.SetInputData(step(index))
        expected.SetInputArrayToProcess(0, 0, 0, 0, "wave")
        expected.SetValue(0, 0.4)
        expected.Update()
        contour.UpdateTimeStep(TIMES[index])
        surface = contour.GetOutput()
        assert surface.GetNumberOfCells() == expected.GetOutput().GetNumberOfCells() > 0
        found, wanted = (np.sort(np.round(vtk_to_numpy(s.GetPoints().GetData()), 5), axis=0)
                         for s in (surface, expected.GetOutput()))
        assert found.shape == wanted.shape and np.abs(found - wanted).max() < 2e-5
assert demand.GetIsOnDemand()
demand.UpdateTimeStep(TIMES[5])
assert demand.GetOutput().GetNumberOfCells() == 12, "the lines of a box"
assert np.allclose(demand.GetOutput().GetBounds(), step(5).GetBounds())

# A region of interest is one of the mesh of the step.
reader.SetBox(0, 0.2, 0, 0.2, 0, 0.2)
for index in (0, 2, 5):
    reader.UpdateTimeStep(TIMES[index])
    assert 0 < reader.GetOutput().GetNumberOfCells() < step(index).GetNumberOfCells()
reader.SetBox(1, -1, 1, -1, 1, -1)

# Each mesh has a hierarchy of its own, and a boundary.
write(path, Hierarchy=True, WriteBoundary=True, ChunkSize=300)
for make in vtkGatunSimplify, None:
    reader = open_reader(path)
    if make:
        last = make()
        last.SetInputConnection(reader.GetOutputPort())
    else:
        last = reader
    last.SetSimplificationRatio(0.5)
    for index in (0, 2, 5, 4, 9):
        last.UpdateTimeStep(TIMES[index])
        assert last.GetErrorCode() == 0
        grid = last.GetOutputDataObject(0)
        assert abs(grid.GetNumberOfPoints() / step(index).GetNumberOfPoints() - 0.5) < 0.02
demand = open_reader(path, LargeMesh=0)
for index in (0, 5, 8):
    demand.UpdateTimeStep(TIMES[index])
    faces = demand.GetOutput()
    n = (7, 9, 5)[MESHES[index]]
    assert faces.GetNumberOfCells() == 12 * n ** 2, "the boundary of a lattice"

# Layers, by the values of the first step of each mesh.
write(path, Layers=("wave", -1, 4))
reader = open_reader(path)
for index in (8, 1, 5):
    reader.UpdateTimeStep(TIMES[index])
    gm.assert_same_mesh(step(index), reader.GetOutput())


def hexahedra(index):
    """Other types of cells, and the coordinates in another type."""
    if index % 2 == 0:
        grid = step(2 * index)
        grid.GetCellData().RemoveArray("cell")
        return grid
    points = np.stack(np.meshgrid(*[np.arange(4.0)] * 3, indexing="ij"), -1).reshape(-1, 3) * 1.1
    at = np.arange(64).reshape(4, 4, 4)
    grid = gm.make_grid(points, np.zeros((0, 4), int))
    grid.Allocate()
    for i, j, k in np.ndindex(3, 3, 3):
        corners = [at[i, j, k], at[i + 1, j, k], at[i + 1, j + 1, k], at[i, j + 1, k]]
        corners += [c + 1 for c in corners]
        if k == 2:
            grid.InsertNextCell(VTK_WEDGE, 6, [corners[c] for c in (0, 1, 2, 4, 5, 6)])
        else:
            grid.InsertNextCell(VTK_HEXAHEDRON, 8, corners)
    gm.add_array(grid.GetPointData(), (points[:, 0] * index).astype(np.float32), "wave")
    gm.add_array(grid.GetFieldData(), np.array([index * 1.0]), "index")
    return grid


assert gm.statistic(write(path, hexahedra, TIMES[:4], KeepOrder=7), "Meshes") == 2
reader = open_reader(path)
for index in (0, 3, 1, 2):
    reader.UpdateTimeStep(TIMES[index])
    gm.assert_equal(hexahedra(index), reader.GetOutput())

# A series that returns to one mesh is hardly larger than one that stays.
stays = gm.statistic(write(gm.temporary("stays.gtn"), lambda i: step(0 if i < 5 else 1)), "FileBytes")
back = write(path, lambda i: step((0, 5)[i % 2]))
assert gm.statistic(back, "Meshes") == 2
again = open_reader(path)
for index in range(len(TIMES)):
    again.UpdateTimeStep(TIMES[index])
    gm.assert_same_mesh(step((0, 5)[index % 2]), again.GetOutput())


# What is damaged is an error at its steps, and only there.
content = bytearray(open(path, "rb").read())
assert content.count(b"GRID") == 2
begin = content.find(b"GRID")  # the last mesh; the last name is in the directory
content[begin + 24 + 1000] ^= 4
open(path, "wb").write(content)
reader = open_reader(path)
errors = gm.Errors(reader)
reader.UpdateTimeStep(TIMES[0])
gm.assert_same_mesh(step(0), reader.GetOutput())
reader.UpdateTimeStep(TIMES[1])
assert reader.GetErrorCode() == vtkErrorCode.FileFormatError and "mesh 2" in str(errors)
reader.UpdateTimeStep(TIMES[2])
assert reader.GetErrorCode() == 0
gm.assert_same_mesh(step(0), reader.GetOutput())
