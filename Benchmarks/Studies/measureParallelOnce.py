# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""For measureParallel.py, on some ranks: draws a .gtn file as a volume in one way, and prints the seconds
until the mesh is there, for the first image and for a later one from another side, and the bytes that the
ranks have sent for that one.

Usage: mpiexec -n RANKS pvbatch measureParallelOnce.py REPRESENTATION PARTITION FILE PICTURE
"""

import os
import sys
import time

from paraview import simple

SCATTERED = """
def gatun_scattered(grid, output):
    import numpy as np
    from vtkmodules.vtkCommonCore import vtkIdList
    from vtkmodules.vtkFiltersCore import vtkExtractCells
    from paraview.modules.vtkRemotingCore import vtkProcessModule
    module = vtkProcessModule.GetProcessModule()
    rank, ranks = module.GetPartitionId(), module.GetNumberOfLocalPartitions()
    owner = np.random.default_rng(1).integers(0, ranks, grid.GetNumberOfCells())
    extract = vtkExtractCells()
    extract.SetInputData(grid)
    ids = vtkIdList()
    for cell in np.flatnonzero(owner == rank):
        ids.InsertNextId(int(cell))
    extract.SetCellList(ids)
    extract.Update()
    output.ShallowCopy(extract.GetOutput())
gatun_scattered(self.GetInputDataObject(0, 0), output.VTKObject)
"""

WHOLE = """
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
gatun_info = self.GetInputInformation(0, 0)
gatun_info.Set(vtkStreamingDemandDrivenPipeline.UPDATE_PIECE_NUMBER(), 0)
gatun_info.Set(vtkStreamingDemandDrivenPipeline.UPDATE_NUMBER_OF_PIECES(), 1)
"""

representation, partition, path, picture = sys.argv[1:5]
simple._DisableFirstRenderCameraReset()
simple.LoadPlugin(os.environ["GATUN_PLUGIN"], remote=False, ns=vars(simple))
view = simple.CreateRenderView()
view.ViewSize = [1024, 1024]
view.OrientationAxesVisibility = 0
view.UseFXAA = 0
simple.Render(view)

begin = time.time()
mesh = simple.GatunReader(FileNames=[path],
                          OnDemand="Always" if partition == "on-demand" else "Never")
mesh.UpdatePipeline()
colored = mesh.PointData[0].GetName()  # not "array", a name of ParaView's scripts
if partition == "scattered":
    # Each rank takes cells at random, of all.
    mesh = simple.ProgrammableFilter(Input=mesh, OutputDataSetType="vtkUnstructuredGrid")
    mesh.RequestUpdateExtentScript = WHOLE
    mesh.Script = SCATTERED
elif partition == "redistributed":
    mesh = simple.RedistributeDataSet(Input=mesh)
mesh.UpdatePipeline()
loaded = time.time() - begin

shown = simple.Show(mesh, view)
shown.SetRepresentationType(representation)
simple.ColorBy(shown, ("POINTS", colored))
simple.ResetCamera(view)
begin = time.time()
simple.Render(view)
first = time.time() - begin
later = []
for _ in range(3):
    view.GetActiveCamera().Azimuth(20)
    view.CameraPosition = view.CameraPosition
    begin = time.time()
    simple.Render(view)
    later.append(time.time() - begin)
sent = 0
if representation == "Gatun Volume":
    shown.SMProxy.UpdatePropertyInformation()
    sent = shown.SMProxy.GetProperty("BytesSent").GetElement(0)
simple.SaveScreenshot(picture, view)
print("measured %.3f %.3f %.3f %d" % (loaded, first, sorted(later)[1], sent))
sys.stdout.flush()
