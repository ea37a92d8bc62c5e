# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Points that move with time: the picture from a file is that of the mesh in memory at each step, of
volumes and of surfaces, as a whole and simplified; contours go with them."""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline

import gatunVolumes as gv
from gatun.vtk import vtkGatunContour, vtkGatunReader, vtkGatunSimplify, vtkGatunWriter
from gatunTimeSource import TimeSource, connect

STEPS = 12
mesh = gv.wave(14)
start = vtk_to_numpy(mesh.GetPoints().GetData()).astype(np.float64)


def grid_at(step):
    """A block that is bent and turned, and goes out of where it was; a step without motion."""
    step -= step == 7
    t = 0.1 * step
    x, y, z = start.T
    places = np.stack((x * np.cos(t) - z * np.sin(t) + 0.05 * step,
                       y + 0.2 * np.sin(3 * x + t) * t, x * np.sin(t) + z * np.cos(t)), 1)
    grid = mesh.NewInstance()
    grid.DeepCopy(mesh)
    moved = places.astype(np.float32) if step > 0 else start.astype(np.float32)
    grid.GetPoints().SetData(gv.gm.numpy_to_vtk(moved, deep=True))
    return grid


def write(path, **options):
    writer = vtkGatunWriter()
    writer.SetFileName(path)
    writer.WriteAllTimeStepsOn()
    writer.SetChunkSize(1500)
    for name, value in options.items():
        getattr(writer, "Set" + name)(value)
    connect(writer, TimeSource(grid_at, list(range(STEPS))))
    assert writer.Write() == 1


def make_reader(path, **options):
    reader = vtkGatunReader()
    reader.SetFileName(path)
    for name, value in options.items():
        getattr(reader, "Set" + name)(value)
    return reader


def go_to(consumer, step):
    consumer.UpdateInformation()
    consumer.GetInputInformation(0, 0).Set(Pipeline.UPDATE_TIME_STEP(), float(step))


path = gv.gm.temporary("moving_pictures.gtn")
write(path, KeyStepInterval=4)
scene = gv.Scene(make_reader(path))
pictures = {}
for step in (0, 1, 11, 6, 7, 8, 2, 0, 11):
    go_to(scene.mapper, step)
    scene.mapper.Modified()
    expected = gv.Scene(grid_at(step))
    pictures[step] = scene.render()
    gv.require_same(pictures[step], expected.render())
    assert np.allclose(scene.volume.GetBounds(), grid_at(step).GetBounds(), 0, 1e-6), step
assert gv.difference(pictures[0], pictures[11]) > 0.1
assert gv.difference(pictures[6], pictures[7]) == 0

# The reader's grid, and vtkGatunRayCaster.
reader = make_reader(path)
caster = gv.make_caster(make_reader(path), Camera=scene.camera,
                        Property=scene.volume.GetProperty(), Size=(160, 120))
for step in (11, 0, 5):
    reader.UpdateTimeStep(step)
    gv.require_same(gv.Scene(reader.GetOutput()).render(), gv.Scene(grid_at(step)).render())
    caster.UpdateTimeStep(step)
    colors = gv.made_by(caster)[0]
    expected = gv.cast(gv.Scene(grid_at(step)), grid_at(step), (160, 120))
    gv.require_same(colors, expected)


# Contours: the same points. (A quadrilateral may be cut along either diagonal.)
def places_of(contour):
    return np.sort(vtk_to_numpy(contour.GetOutput().GetPoints().GetData()).astype(np.float64), 0)


for options in ({}, {"LargeMesh": 0}):
    contour = vtkGatunContour()
    reader = make_reader(path, **options)
    contour.SetInputConnection(reader.GetOutputPort())
    contour.SetValue(0, 0.5)
    for step in (0, 11, 7, 3):
        contour.UpdateTimeStep(step)
        alone = vtkGatunContour()
        alone.SetInputData(grid_at(step))
        alone.SetValue(0, 0.5)
        alone.Update()
        found, expected = places_of(contour), places_of(alone)
        assert len(found) == len(expected) > 100
        assert np.allclose(found, expected, 0, 1e-5), step

# Simplified on demand: the same as what the reader's grid gives, at the points of the step.
write(path, Hierarchy=True)
for step in (0, 11, 5):
    simplify = vtkGatunSimplify()
    reader = make_reader(path, LargeMesh=0)
    simplify.SetInputConnection(reader.GetOutputPort())
    simplify.UpdateTimeStep(step)
    output = simplify.GetOutput()
    assert 0 < output.GetNumberOfPoints() < 0.8 * len(start)
    moved = vtk_to_numpy(grid_at(step).GetPoints().GetData())
    known = {tuple(place) for place in moved}
    assert all(tuple(p) in known for p in vtk_to_numpy(output.GetPoints().GetData())), step
    coarse = gv.Scene(make_reader(path, SimplificationRatio=0.5))
    go_to(coarse.mapper, step)
    grid = make_reader(path, SimplificationRatio=0.5)
    grid.UpdateTimeStep(step)
    gv.require_same(coarse.render(), gv.Scene(grid.GetOutput()).render())
