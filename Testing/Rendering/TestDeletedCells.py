# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Series in which cells die are drawn from their files: the picture of each step is that of the remaining
cells in memory, at rest and in motion, by mapper and ray caster."""

import numpy as np
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline

import gatunVolumes as gv
from gatun.vtk import vtkGatunReader, vtkGatunWriter
from gatunTimeSource import TimeSource, connect

WHOLE = gv.wave(12)
POINTS, TETS = gv.gm.coordinates(WHOLE), gv.gm.connectivity(WHOLE)
CENTERS = POINTS[TETS].mean(axis=1)[:, 0]
FRONTS = [0, 0.25, 0.45, 0]
TIMES = [float(i) for i in range(len(FRONTS))]


def step(index, drops):
    low, high = CENTERS.min(), CENTERS.max()
    alive = TETS[CENTERS >= low + FRONTS[index] * (high - low)]
    kept = np.unique(alive) if drops else np.arange(len(POINTS))
    number = np.zeros(len(POINTS), int)
    number[kept] = np.arange(len(kept))
    grid = gv.gm.make_grid(POINTS[kept], number[alive])
    for array in gv.gm.arrays_of(WHOLE.GetPointData()):
        gv.gm.add_array(grid.GetPointData(), gv.gm.values_of(array)[kept], array.GetName())
    grid.GetPointData().SetActiveScalars(WHOLE.GetPointData().GetScalars().GetName())
    return grid


path = gv.gm.temporary("deleted_pictures.gtn")
for drops in (False, True):
    writer = vtkGatunWriter()
    connect(writer, TimeSource(lambda index: step(index, drops), TIMES))
    writer.SetFileName(path)
    writer.SetChunkSize(900)
    writer.WriteAllTimeStepsOn()
    assert writer.Write() == 1 and gv.gm.statistic(writer, "Meshes") == 1
    reader = vtkGatunReader()
    reader.SetFileName(path)
    scene = gv.Scene(reader)
    caster = gv.make_caster(
        reader, Camera=scene.camera, Property=scene.volume.GetProperty(), Size=(160, 120))
    for index in (0, 2, 1, 3):
        scene.mapper.GetInputInformation().Set(Pipeline.UPDATE_TIME_STEP(), TIMES[index])
        memory = gv.Scene(step(index, drops))
        for one in scene, memory:
            one.look(1, 0.5, 2.2)
        gv.require_same(scene.render(), memory.render())
        scene.window.SetDesiredUpdateRate(30)
        scene.render()
        scene.window.SetDesiredUpdateRate(0.0001)
        gv.require_same(scene.render(), memory.render())
        caster.UpdateTimeStep(TIMES[index])
        gv.require_same(gv.made_by(caster)[0], gv.cast(memory, step(index, drops), (160, 120)))
