# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Meshes whose cells are dealt out to the ranks at random, and geometry that the last rank has."""

import numpy as np

from paraview import simple

import gatunSample as sample

SIDE = sample.SIDE

# In functions, because ParaView runs scripts among the variables of the main program.
SCRIPT = """
def gatun_scatter(mesh, side, output):
    import numpy as np
    from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkUnstructuredGrid
    from vtkmodules.vtkFiltersCore import vtkDelaunay3D
    from paraview.modules.vtkRemotingCore import vtkProcessModule
    module = vtkProcessModule.GetProcessModule()
    rank, ranks = module.GetPartitionId(), module.GetNumberOfLocalPartitions()
    random = np.random.default_rng(3)
    if mesh == "Post":
        # A grid around a cylinder, finer near to it, split into tetrahedra.
        n = np.array([16, 31, 11])
        i, j, k = (a.ravel() for a in np.meshgrid(*(np.arange(m) for m in n), indexing="ij"))
        radius = side * (0.06 + 0.44 * (i / 15) ** 1.7)
        angle = 2 * np.pi * (j % 30) / 30
        points = np.stack([side / 2 + radius * np.cos(angle), side / 2 + radius * np.sin(angle),
                           k * side / 10], 1)
        at = lambda a, b, c: (((i + a) * n[1] + (j + b) % 30) * n[2] + k + c)[
            (i < 15) & (j < 30) & (k < 10)]
        box = [at(a, b, c) for a in (0, 1) for b in (0, 1) for c in (0, 1)]
        paths = ((1, 3), (3, 2), (2, 6), (6, 4), (4, 5), (5, 1))
        tets = np.concatenate([np.stack([box[0], box[b], box[a], box[7]], 1) for a, b in paths])
    else:
        points = side * random.random((1600, 3))
        cloud = vtkUnstructuredGrid()
        places = vtkPoints()
        places.SetData(numpy_to_vtk(points, deep=1))
        cloud.SetPoints(places)
        delaunay = vtkDelaunay3D()
        delaunay.SetInputData(cloud)
        delaunay.Update()
        made = delaunay.GetOutput()
        points = vtk_to_numpy(made.GetPoints().GetData()).astype(float)
        tets = vtk_to_numpy(made.GetCells().GetConnectivityArray()).reshape(-1, 4)
    owner = random.integers(0, ranks, len(tets))
    mine = tets[owner == rank]
    used, mine = np.unique(mine, return_inverse=True)
    points = points[used].astype(np.float32)
    mine = mine.reshape(-1, 4)
    cells = vtkCellArray()
    cells.SetData(numpy_to_vtkIdTypeArray(np.arange(0, mine.size + 1, 4), deep=1),
                  numpy_to_vtkIdTypeArray(mine.ravel().astype(np.int64), deep=1))
    coordinates = vtkPoints()
    coordinates.SetData(numpy_to_vtk(points, deep=1))
    output.SetPoints(coordinates)
    output.SetCells(10, cells)
    wave = numpy_to_vtk(np.sin(points / 3).sum(1), deep=1)
    wave.SetName("wave")
    output.GetPointData().AddArray(wave)
"""


def make_source(mesh):
    made = simple.ProgrammableSource(OutputDataSetType="vtkUnstructuredGrid")
    made.Script = SCRIPT + 'gatun_scatter("%s", %d, output.VTKObject)' % (mesh, SIDE)
    return made


def make_ball():
    """A sphere in the middle of the meshes, all of it on the last rank."""
    made = simple.ProgrammableSource(OutputDataSetType="vtkPolyData")
    made.Script = """
from paraview.modules.vtkRemotingCore import vtkProcessModule
gatun_module = vtkProcessModule.GetProcessModule()
if gatun_module.GetPartitionId() == gatun_module.GetNumberOfLocalPartitions() - 1:
    from vtkmodules.vtkFiltersSources import vtkSphereSource
    gatun_ball = vtkSphereSource()
    gatun_ball.SetCenter(%g, %g, %g)
    gatun_ball.SetRadius(%g)
    gatun_ball.SetThetaResolution(40)
    gatun_ball.SetPhiResolution(40)
    gatun_ball.Update()
    output.VTKObject.ShallowCopy(gatun_ball.GetOutput())
""" % (0.6 * SIDE, 0.55 * SIDE, 0.6 * SIDE, 0.28 * SIDE)
    return made


def count_on_first(made):
    """How many cells the first rank has."""
    count = simple.ProgrammableFilter(Input=made, OutputDataSetType="vtkTable")
    count.Script = """
import numpy as np
output.RowData.append(np.array([inputs[0].GetNumberOfCells()]), "cells")
"""
    count.UpdatePipeline()
    return int(simple.servermanager.Fetch(count).GetRowData().GetArray("cells").GetValue(0))
