# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Series whose mesh changes are drawn from their files: the picture of each step is that of its mesh
in memory, for volumes and surfaces, at rest and in motion, by mapper and ray caster."""

from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter

import gatunVolumes as gv
from gatun.vtk import vtkGatunReader, vtkGatunWriter
from gatunSurfaceScene import VIEWS, pair, require_equal
from gatunTimeSource import TimeSource, connect

GRIDS = [gv.wave(10), gv.wave(14, seed=3), gv.wave(6, seed=5)]
MESHES = [0, 1, 2, 0, 1]
TIMES = [float(i) for i in range(len(MESHES))]


def step(index):
    return GRIDS[MESHES[index]]


def write(path, make, kind="vtkUnstructuredGrid", **options):
    writer = vtkGatunWriter()
    connect(writer, TimeSource(make, TIMES, kind))
    writer.SetFileName(path)
    writer.WriteAllTimeStepsOn()
    for name, value in options.items():
        getattr(writer, "Set" + name)(value)
    assert writer.Write() == 1 and gv.gm.statistic(writer, "Meshes") > 2
    return writer


path = gv.gm.temporary("changing_pictures.gtn")
for options in {"ChunkSize": 1000}, {"ChunkSize": 1000, "Hierarchy": True, "Levels": 2}:
    write(path, step, **options)
    reader = vtkGatunReader()
    reader.SetFileName(path)
    scene = gv.Scene(reader)
    caster = gv.make_caster(
        reader, Camera=scene.camera, Property=scene.volume.GetProperty(), Size=(160, 120))
    for index in (0, 1, 2, 4, 3, 2):
        scene.mapper.GetInputInformation().Set(Pipeline.UPDATE_TIME_STEP(), TIMES[index])
        memory = gv.Scene(step(index))
        for one in scene, memory:
            one.look(1, 0.5, 2.2)
        gv.require_same(scene.render(), memory.render())
        # In motion, and at rest again.
        scene.window.SetDesiredUpdateRate(30)
        scene.render()
        scene.window.SetDesiredUpdateRate(0.0001)
        gv.require_same(scene.render(), memory.render())
        caster.UpdateTimeStep(TIMES[index])
        gv.require_same(gv.made_by(caster)[0], gv.cast(memory, step(index), (160, 120)))


def skin(index):
    surface = vtkGeometryFilter()
    surface.SetInputData(step(index))
    surface.Update()
    return surface.GetOutput()


write(path, skin, "vtkPolyData", ChunkSize=300)
ours, theirs = pair(path)
for index in (0, 1, 2, 4, 3, 2):
    ours.mapper.GetInputInformation().Set(Pipeline.UPDATE_TIME_STEP(), TIMES[index])
    theirs.mapper.SetInputDataObject(skin(index))
    for view in VIEWS:
        for scene in ours, theirs:
            scene.look(*view)
        require_equal(ours, theirs, (index, view))
    assert ours.mapper.GetIsDrawingFile()
