# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""A mesh is simplified in memory by each rank on its own, and the pieces fit together: no point of
the inside is on a face that only one tetrahedron has. Each rank has cells from everywhere. And a surface."""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

import gatunSample as sample
from gatunParaView import load_plugin, rank_and_ranks

simple = load_plugin()
rank, ranks = rank_and_ranks()
mesh = simple.ProgrammableSource(OutputDataSetType="vtkUnstructuredGrid")
mesh.Script = sample.SCRIPT + """
gatun_fill(output)
def gatun_scatter(grid):
    import numpy as np
    from paraview.modules.vtkRemotingCore import vtkProcessModule
    from vtkmodules.util.numpy_support import numpy_to_vtkIdTypeArray, vtk_to_numpy
    from vtkmodules.vtkCommonDataModel import vtkCellArray
    process = vtkProcessModule.GetProcessModule()
    tets = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4)
    x, y, z = vtk_to_numpy(grid.GetPoints().GetData())[tets[:, 0]].T
    waves = (x + 2 * np.sin(y) + np.cos(z) + 3) // 5
    tets = tets[waves % process.GetNumberOfLocalPartitions() == process.GetPartitionId()]
    cells = vtkCellArray()
    cells.SetData(numpy_to_vtkIdTypeArray(np.arange(0, tets.size + 1, 4), deep=1),
                  numpy_to_vtkIdTypeArray(tets.ravel().astype(np.int64), deep=1))
    grid.SetCells(10, cells)
    grid.GetCellData().Initialize()
gatun_scatter(output.VTKObject)
"""
assert sample.counts(mesh)[1] == sample.TETS
simplified = simple.GatunSimplify(Input=mesh, SimplificationRatio=0.8)

# The corners of all tetrahedra, on the first rank.
gathered = simple.ProgrammableFilter(Input=simplified, OutputDataSetType="vtkPolyData")
gathered.Script = """
def gatun_gather(grid, output):
    from paraview import vtk
    from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
    places = vtk_to_numpy(grid.GetPoints().GetData())
    mine = numpy_to_vtk(places[vtk_to_numpy(grid.GetCells().GetConnectivityArray())], deep=1)
    controller = vtk.vtkMultiProcessController.GetGlobalController()
    if controller.GetNumberOfProcesses() > 1:
        every = mine.NewInstance()
        controller.GatherV(mine, every, 0)
        mine = every
    if controller.GetLocalProcessId() == 0:
        points = vtk.vtkPoints()
        mine.SetNumberOfComponents(3)
        points.SetData(mine)
        output.SetPoints(points)
gatun_gather(inputs[0].VTKObject, output.VTKObject)
"""
gathered.UpdatePipeline()
corners = simple.servermanager.Fetch(gathered)
if rank == 0:
    corners = vtk_to_numpy(corners.GetPoints().GetData())
    assert len(corners) == 4 * sample.counts(simplified)[1]
    places, ids = np.unique(corners, axis=0, return_inverse=True)
    tets = ids.reshape(-1, 4)
    assert 0 < len(tets) < 0.7 * sample.TETS, len(tets)
    faces = np.sort(np.concatenate([np.delete(tets, i, axis=1) for i in range(4)]), axis=1)
    faces, times = np.unique(faces, axis=0, return_counts=True)
    assert times.max() == 2
    outside = places[np.unique(faces[times == 1])]
    assert np.isin(outside, (0, sample.SIDE)).any(axis=1).all(), "a crack between ranks"

sphere = simple.Sphere(ThetaResolution=64, PhiResolution=64)
surface = simple.GatunSimplify(Input=sphere, SimplificationRatio=0.8)
surface.UpdatePipeline()
before, after = sphere.GetDataInformation(), surface.GetDataInformation()
assert after.GetDataSetTypeAsString() == "vtkPolyData"
assert 0 < after.GetNumberOfPoints() < 0.5 * before.GetNumberOfPoints()
