"""A simulation that runs scripts of ParaView Catalyst. Each process has some layers of a box of hexahedra, in
which a warm ball moves.

    mpiexec -n 3 pvbatch --sym simulation.py gatun_catalyst.py [FOLDER OF RESULTS [CUBES [STEPS]]]
"""

import os
import sys

import numpy as np
from paraview.catalyst import bridge
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON, vtkCellArray, vtkUnstructuredGrid
from vtkmodules.vtkParallelCore import vtkMultiProcessController


class Simulation:
    """The layers that this process has. The mesh stays, the values change."""

    def __init__(self, cubes, rank, ranks):
        first, last = cubes * rank // ranks, cubes * (rank + 1) // ranks
        side = np.arange(cubes + 1)
        z, y, x = np.meshgrid(np.arange(first, last + 1), side, side, indexing="ij")
        self.points = np.stack([x.ravel(), y.ravel(), z.ravel()], 1) / cubes
        z, y, x = np.meshgrid(np.arange(last - first), side[:-1], side[:-1], indexing="ij")
        corner = ((z * (cubes + 1) + y) * (cubes + 1) + x).ravel()
        plane = (cubes + 1) ** 2
        around = np.array([0, 1, cubes + 2, cubes + 1])
        self.cells = corner[:, None] + np.concatenate([around, around + plane])

    def grid(self, time):
        """The mesh with the temperatures at a time."""
        grid = vtkUnstructuredGrid()
        points = vtkPoints()
        points.SetData(numpy_to_vtk(self.points, deep=1))
        grid.SetPoints(points)
        cells = vtkCellArray()
        cells.SetData(numpy_to_vtkIdTypeArray(np.arange(0, self.cells.size + 1, 8), deep=1),
                      numpy_to_vtkIdTypeArray(self.cells.ravel().astype(np.int64), deep=1))
        grid.SetCells(VTK_HEXAHEDRON, cells)
        center = [0.3 + 0.4 * time, 0.5, 0.4]
        values = numpy_to_vtk(np.exp(-20 * ((self.points - center) ** 2).sum(1)), deep=1)
        values.SetName("temperature")
        grid.GetPointData().SetScalars(values)
        return grid


def main(script, folder=".", cubes=12, steps=4):
    """Runs the simulation, with the script at each step."""
    os.environ["GATUN_RESULTS"] = folder  # for the script
    bridge.initialize()
    bridge.add_pipeline(script)
    controller = vtkMultiProcessController.GetGlobalController()
    simulation = Simulation(int(cubes), controller.GetLocalProcessId(),
                            controller.GetNumberOfProcesses())
    for step in range(int(steps)):
        time = step / int(steps)
        bridge.coprocess(time, step, simulation.grid(time), name="mesh")
    bridge.finalize()


main(*sys.argv[1:])
