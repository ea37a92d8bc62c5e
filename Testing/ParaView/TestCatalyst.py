# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The example of Catalyst: a simulation on any number of ranks runs the script, which writes the mesh of
each time step. To be run symmetrically. Usage: TestCatalyst.py FOLDER_OF_THE_EXAMPLE
"""

import os
import runpy
import shutil
import sys

import numpy as np
from gatunParaView import load_plugin, rank_and_ranks
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkParallelCore import vtkMultiProcessController

CUBES = 8
example = sys.argv[1]
folder = os.path.join(os.environ["GATUN_TEST_TEMP"], os.environ["GATUN_TEST_NAME"])
controller = vtkMultiProcessController.GetGlobalController()
if rank_and_ranks()[0] == 0:
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
controller.Barrier()
sys.argv[1:] = [os.path.join(example, "gatun_catalyst.py"), folder, str(CUBES), "3"]
runpy.run_path(os.path.join(example, "simulation.py"))
controller.Barrier()
simple = load_plugin()
files = sorted(name for name in os.listdir(folder) if name.endswith(".gtn"))
assert files == ["mesh_%04d.gtn" % i for i in range(3)], os.listdir(folder)
assert os.path.exists(os.path.join(folder, "surface_0002.pvtp")), os.listdir(folder)
for step in range(3):
    reader = simple.GatunReader(FileNames=[os.path.join(folder, files[step])])
    reader.UpdatePipeline()
    grid = reader.SMProxy.GetClientSideObject().GetOutputDataObject(0)
    points = vtk_to_numpy(grid.GetPoints().GetData())
    center = [0.3 + 0.4 * step / 3, 0.5, 0.4]
    expected = np.exp(-20 * ((points - center) ** 2).sum(1))
    assert abs(vtk_to_numpy(grid.GetPointData().GetArray("temperature")) - expected).max() < 1e-15
    # Each cell once: all of them together fill the box.
    volume = simple.IntegrateVariables(Input=reader, DivideCellDataByVolume=0)
    volume.UpdatePipeline()
    sums = volume.SMProxy.GetClientSideObject().GetOutputDataObject(0)
    if rank_and_ranks()[0] == 0:
        assert abs(sums.GetCellData().GetArray("Volume").GetValue(0) - 1) < 1e-9
    simple.Delete(volume)
    simple.Delete(reader)
controller.Barrier()
if rank_and_ranks()[0] == 0:
    shutil.rmtree(folder)
