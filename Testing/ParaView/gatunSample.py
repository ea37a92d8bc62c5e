# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""A mesh to test with, made the same on every rank, and what is known about it."""

import contextlib
import os

from paraview import simple


SIDE = 12
TETS = 6 * SIDE ** 3
POINTS = (SIDE + 1) ** 3
BOUNDARY = 12 * SIDE ** 2
VOLUME = float(SIDE ** 3)

# In functions, because ParaView runs scripts among the variables of the main program.
SCRIPT = """
def gatun_fill(output, time=None):
    import numpy as np
    from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray
    n = %d
    axis = np.arange(n + 1)
    x, y, z = (a.ravel() for a in np.meshgrid(axis, axis, axis, indexing="ij"))
    points = np.stack([x, y, z], 1).astype(np.float32)
    at = lambda i, j, k: (((x + i) * (n + 1) + y + j) * (n + 1) + z + k)
    box = [at(i, j, k)[(x < n) & (y < n) & (z < n)] for i in (0, 1) for j in (0, 1) for k in (0, 1)]
    paths = ((1, 3), (3, 2), (2, 6), (6, 4), (4, 5), (5, 1))
    tets = np.concatenate([np.stack([box[0], box[b], box[a], box[7]], 1) for a, b in paths])
    size = 4 * len(tets)
    cells = vtkCellArray()
    cells.SetData(numpy_to_vtkIdTypeArray(np.arange(0, size + 1, 4), deep=1),
                  numpy_to_vtkIdTypeArray(tets.ravel().astype(np.int64), deep=1))
    coordinates = vtkPoints()
    coordinates.SetData(numpy_to_vtk(points, deep=1))
    output.VTKObject.SetPoints(coordinates)
    output.VTKObject.SetCells(10, cells)
    def add(data, values, name):
        array = numpy_to_vtk(values, deep=1)
        array.SetName(name)
        data.AddArray(array)
    add(output.VTKObject.GetPointData(), np.sin(points / 3).sum(1), "wave")
    add(output.VTKObject.GetPointData(), np.arange(len(points), dtype=np.int32), "point")
    add(output.VTKObject.GetCellData(), np.arange(len(tets), dtype=np.int32), "cell")
    if time is not None:
        add(output.VTKObject.GetPointData(), points[:, 0] * time, "ramp")
""" % SIDE


def make_source():
    """The mesh, all of it on the first rank and nothing on the others."""
    made = simple.ProgrammableSource(OutputDataSetType="vtkUnstructuredGrid")
    made.Script = SCRIPT + """
from paraview.modules.vtkRemotingCore import vtkProcessModule
if vtkProcessModule.GetProcessModule().GetPartitionId() == 0:
    gatun_fill(output)
"""
    return made


def make_moving_source(times):
    """The mesh with a point array "ramp", x times the time, all of it on the first rank."""
    made = simple.ProgrammableSource(OutputDataSetType="vtkUnstructuredGrid")
    made.ScriptRequestInformation = """
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
gatun_info = self.GetOutputInformation(0)
gatun_times = %s
gatun_info.Set(vtkStreamingDemandDrivenPipeline.TIME_STEPS(), gatun_times, len(gatun_times))
gatun_info.Set(vtkStreamingDemandDrivenPipeline.TIME_RANGE(), [gatun_times[0], gatun_times[-1]], 2)
""" % times
    made.Script = SCRIPT + """
from paraview.modules.vtkRemotingCore import vtkProcessModule
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
if vtkProcessModule.GetProcessModule().GetPartitionId() == 0:
    gatun_fill(output, self.GetOutputInformation(0).Get(
        vtkStreamingDemandDrivenPipeline.UPDATE_TIME_STEP()))
"""
    return made


def temporary(name):
    """A path of this test alone, as tests run side by side; where nothing is yet."""
    path = os.path.join(os.environ["GATUN_TEST_TEMP"],
                        "%s-%s" % (os.environ["GATUN_TEST_NAME"], name))
    with contextlib.suppress(FileNotFoundError):
        os.remove(path)
    return path


def counts(proxy):
    """Points and cells of all ranks, ghosts included."""
    proxy.UpdatePipeline()
    info = proxy.GetDataInformation()
    return info.GetNumberOfPoints(), info.GetNumberOfCells()


OWNED = """
def gatun_owned(grid, output):
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray
    kept = []
    for data, count in ((grid.GetPointData(), grid.GetNumberOfPoints()),
                        (grid.GetCellData(), grid.GetNumberOfCells())):
        flags = data.GetArray("vtkGhostType")
        kept.append(len([i for i in range(count) if not flags or not int(flags.GetValue(i)) & 1]))
    points = vtkPoints()
    cells = vtkCellArray()
    points.SetNumberOfPoints(1)
    points.SetPoint(0, 0, 0, 0)
    output.SetPoints(points)
    for i in range(kept[WHAT]):
        cells.InsertNextCell(1, [0])
    output.SetCells(1, cells)
gatun_owned(inputs[0].VTKObject, output.VTKObject)
"""


def owned(proxy):
    """Points and cells of all ranks, each by the one who owns it."""
    numbers = []
    for what in (0, 1):
        look = simple.ProgrammableFilter(Input=proxy, OutputDataSetType="vtkUnstructuredGrid")
        look.Script = OWNED.replace("WHAT", str(what))
        numbers.append(counts(look)[1])
    return tuple(numbers)


def volume(proxy):
    """Of all cells but ghosts."""
    sum_of_all = simple.IntegrateVariables(Input=proxy, DivideCellDataByVolume=0)
    sum_of_all.UpdatePipeline()
    values = simple.servermanager.Fetch(sum_of_all)
    return values.GetCellData().GetArray("Volume").GetValue(0)
