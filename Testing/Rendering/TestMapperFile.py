# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""With a reader connected, its file is drawn: the picture is that of the mesh in memory, the reader
is never executed, and what is not seen is not read."""

import os

import numpy as np
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline

import gatunVolumes as gv
from gatun.vtk import vtkGatunReader, vtkGatunWriter
from gatunTimeSource import TimeSource, connect


def make_reader(path):
    reader = vtkGatunReader()
    reader.SetFileName(path)
    reader.starts = 0

    def count(*_):
        reader.starts += 1

    reader.AddObserver("StartEvent", count)
    return reader


mesh = gv.wave(30)
path = gv.gm.temporary("mapper.gtn")
gv.gm.write(mesh, path, ChunkSize=4096)
size = os.path.getsize(path)
reader = make_reader(path)
scene = gv.Scene(reader)
memory = gv.Scene(mesh)

# Bounds come from the file; so does the camera that a renderer sets up by itself.
assert np.allclose(scene.volume.GetBounds(), (0, 1, 0, 1, 0, 1))
for one in (scene, memory):
    one.renderer.ResetCamera()
    gv.require_same(one.render(), one.render())
gv.require_same(scene.render(), memory.render())
for mode in "Composite", "MaximumIntensity", "XRay":
    for one in (scene, memory):
        getattr(one.mapper, "SetBlendModeTo" + mode)()
        one.look(1, 0.5, 2.2)
    gv.require_same(scene.render(), memory.render())

# Nothing was asked of the reader, whatever else VTK asks of a volume.
scene.volume.GetRedrawMTime()
scene.volume.Update()
scene.mapper.Update()
scene.mapper.UpdateWholeExtent()
scene.mapper.UpdatePiece(0, 1, 0)
assert scene.mapper.GetDataSetInput() is None
assert reader.starts == 0
assert reader.GetOutput().GetNumberOfCells() == 0

# Only what is seen is read, of one array; and only once if there is room for it.
close = gv.Scene(make_reader(path), size=(60, 60))
close.camera.SetPosition(-2, 0.1, 0.1)
close.camera.SetFocalPoint(0.1, 0.1, 0.1)
close.camera.SetViewAngle(2)
close.camera.SetClippingRange(0.01, 2.2)
gv.require_same(close.render(), close.render())
few = gv.gm.statistic(close.mapper, "BytesRead")
assert 0 < few < size / 3, (few, size)
close.look(1, 0.5)
close.camera.SetViewAngle(30)
close.render()
many = gv.gm.statistic(close.mapper, "BytesRead")
assert many > 2 * few, (few, many)
close.render()
assert gv.gm.statistic(close.mapper, "BytesRead") == many
close.source.SetMemoryBudget(0)
close.render()
assert gv.gm.statistic(close.mapper, "BytesRead") > many

# A region of interest is made by the reader, and then drawn.
region = make_reader(path)
region.SetBox(0, 0.1, 0, 0.1, 0, 0.1)
part = gv.Scene(region)
gv.require_same(part.render(), gv.Scene(region.GetOutput()).render())
assert region.starts == 1
assert part.mapper.GetDataSetInput().GetNumberOfCells() < mesh.GetNumberOfCells()
assert gv.gm.statistic(part.mapper, "BytesRead") == 0
region.SetBox(1, -1, 1, -1, 1, -1)
gv.require_same(part.render(), gv.Scene(mesh).render())

# A reader that gives but the outline is drawn like any other, executed or not.
region.SetLargeMesh(0)
gv.require_same(part.render(), gv.Scene(mesh).render())
region.Update()
assert region.GetOutput().GetNumberOfCells() == 12
gv.require_same(part.render(), gv.Scene(mesh).render())
assert part.volume.GetBounds() == scene.volume.GetBounds()

# Another file of the same name is another mesh.
other = gv.wave(6, seed=2)
gv.gm.write(other, path)
assert gv.difference(part.render(), gv.Scene(other).render()) <= 2 / 255

# Arrays: those of the file, whether the reader is to read them or not.
points, tets = gv.gm.lattice(6)
grid = gv.gm.make_grid(points, tets)
gv.gm.add_array(grid.GetPointData(), points.astype(np.float64), "place")
gv.gm.add_array(grid.GetPointData(), (points[:, 1] ** 2).astype(np.float32), "square")
gv.gm.add_array(grid.GetCellData(), points[tets].mean(1)[:, 2].astype(np.float32), "middle")
grid.GetPointData().SetActiveScalars("square")
grid.GetCellData().SetActiveScalars("middle")
gv.gm.write(grid, path)
reader = make_reader(path)
reader.UpdateInformation()
reader.GetPointDataArraySelection().DisableAllArrays()
choices = []
for source in (reader, grid):
    scene = gv.Scene(source)
    pictures = [scene.render()]
    for mode in "PointData", "CellData":
        getattr(scene.mapper, "SetScalarModeToUse" + mode)()
        pictures.append(scene.render())
    scene.mapper.SetScalarModeToUsePointFieldData()
    for array, component in (("place", 0), ("place", 2), ("place", -1), (0, 1), (1, 0)):
        scene.mapper.SelectScalarArray(array)
        scene.set(ArrayComponent=component)
        pictures.append(scene.render())
    scene.mapper.SetScalarModeToUseCellFieldData()
    scene.mapper.SelectScalarArray("middle")
    pictures.append(scene.render())
    choices.append(pictures)
for a, b in zip(*choices):
    gv.require_same(a, b)
for i, j in ((0, 2), (3, 4), (4, 5), (3, 6)):
    assert gv.difference(choices[0][i], choices[0][j]) > 0.05, (i, j)
for i, j in ((0, 1), (2, 8), (0, 7)):
    gv.require_same(choices[0][i], choices[0][j])
assert reader.starts == 0

# Time: the step that is asked of the reader.
steps = [gv.wave(4), gv.constant(4)]
steps[1].GetPointData().GetArray("constant").SetName("wave")
source = TimeSource(lambda step: steps[step], [0.0, 1.0])
writer = vtkGatunWriter()
connect(writer, source)
writer.SetFileName(path)
writer.WriteAllTimeStepsOn()
assert writer.Write() == 1
reader = make_reader(path)
scene = gv.Scene(reader)
for time, step in ((None, 0), (1.0, 1), (0.5, 0), (7, 1)):
    if time is not None:
        scene.mapper.GetInputInformation().Set(Pipeline.UPDATE_TIME_STEP(), time)
    gv.require_same(scene.render(), gv.Scene(steps[step]).render())
assert reader.starts == 0
