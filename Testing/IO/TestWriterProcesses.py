# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""vtkGatunWriter on several processes: each has some of the cells, at random, the last one none, and all
write one file. It has the mesh, values and time steps of the whole; errors of one process are those of all."""

import os
import sys

import numpy as np

try:
    from mpi4py import MPI
    from vtkmodules.vtkParallelMPI import vtkMPIController
except ImportError:
    sys.exit(125)
from vtkmodules.util import vtkConstants as c
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkDataSetAttributes, vtkUnstructuredGrid
from vtkmodules.vtkCommonExecutionModel import (
    vtkAlgorithm, vtkStreamingDemandDrivenPipeline as pipeline)

import gatunMeshes as gm
from gatun import vtkGatunReader, vtkGatunWriter

world = MPI.COMM_WORLD
rank, ranks = world.Get_rank(), world.Get_size()
controller = vtkMPIController()
controller.Initialize()
assert (controller.GetLocalProcessId(), controller.GetNumberOfProcesses()) == (rank, ranks)
folder = os.path.join(os.environ["GATUN_TEST_TEMP"], f"writer-processes-{ranks}")
if rank == 0:
    os.makedirs(folder, exist_ok=True)
    for name in os.listdir(folder):
        os.remove(os.path.join(folder, name))
world.Barrier()
path = os.path.join(folder, "processes.gtn")


class Source(VTKPythonAlgorithmBase):
    """make(step) returns the piece of this process."""

    def __init__(self, make, times=()):
        super().__init__(nInputPorts=0, nOutputPorts=1, outputType="vtkUnstructuredGrid")
        self.make, self.times = make, list(times)

    def RequestInformation(self, request, inInfo, outInfo):
        info = outInfo.GetInformationObject(0)
        info.Set(vtkAlgorithm.CAN_HANDLE_PIECE_REQUEST(), 1)
        if self.times:
            info.Set(pipeline.TIME_STEPS(), self.times, len(self.times))
            info.Set(pipeline.TIME_RANGE(), [self.times[0], self.times[-1]], 2)
        return 1

    def RequestData(self, request, inInfo, outInfo):
        info = outInfo.GetInformationObject(0)
        assert info.Get(pipeline.UPDATE_PIECE_NUMBER()) == (rank if ranks > 1 else 0)
        assert info.Get(pipeline.UPDATE_NUMBER_OF_PIECES()) == ranks
        step = 0
        if self.times and info.Has(pipeline.UPDATE_TIME_STEP()):
            step = self.times.index(info.Get(pipeline.UPDATE_TIME_STEP()))
        output = vtkUnstructuredGrid.GetData(outInfo, 0)
        output.ShallowCopy(self.make(step))
        if self.times:
            output.GetInformation().Set(vtkDataObject.DATA_TIME_STEP(), self.times[step])
        return 1


def write(source, expected=1, **options):
    writer = vtkGatunWriter()
    messages = []

    @gm.calldata_type(c.VTK_STRING)
    def note(_object, _event, text):
        messages.append(text)

    writer.AddObserver("WarningEvent", note)
    writer.AddObserver("ErrorEvent", note)
    writer.SetInputConnection(source.GetOutputPort())
    writer.SetController(controller)
    writer.SetFileName(path)
    writer.SetChunkTets(200)
    for key, value in options.items():
        getattr(writer, "Set" + key)(value)
    assert writer.Write() == expected, messages
    world.Barrier()
    assert len(os.listdir(folder)) == (1 if os.path.exists(path) else 0), os.listdir(folder)
    return writer, messages


whole = gm.block(n=7)
cells = whole.GetNumberOfCells()
owner = np.random.default_rng(5).integers(0, max(ranks - 1, 1), cells)  # the last one has none


def own_part(grid):
    return gm.part_of(grid, owner == rank) if (owner == rank).any() else vtkUnstructuredGrid()


writer, messages = write(Source(lambda step: own_part(whole)))
assert not messages, messages
gm.assert_same_mesh(gm.read(path), whole)
assert writer.GetWrittenPoints() == whole.GetNumberOfPoints()
assert writer.GetWrittenCells() == cells
assert writer.GetFileBytes() == os.path.getsize(path)

# Time steps.
steps = [gm.block(n=7) for _ in range(3)]
for step, grid in enumerate(steps):
    gm.add_array(grid.GetPointData(), gm.coordinates(grid)[:, 0] * step, "moving")
times = [0., .5, 2.]
writer, messages = write(Source(lambda step: own_part(steps[step]), times), WriteAllTimeSteps=True)
assert not messages, messages
assert writer.GetWrittenSteps() == 3
reader = vtkGatunReader()
reader.SetFileName(path)
for step, time in enumerate(times):
    reader.UpdateTimeStep(time)
    gm.assert_same_mesh(reader.GetOutput(), steps[step])
world.Barrier()


# Ghost cells are not written.
def with_ghosts(_step):
    extra = (owner != rank) & (np.arange(cells) % 3 == 0)
    wanted = (owner == rank) | extra
    grid = gm.part_of(whole, wanted)
    marks = vtkUnsignedCharArray()
    marks.SetName(vtkDataSetAttributes.GhostArrayName())
    for ghost in extra[wanted]:
        marks.InsertNextValue(vtkDataSetAttributes.DUPLICATECELL if ghost else 0)
    grid.GetCellData().AddArray(marks)
    return grid


if ranks > 1:
    write(Source(with_ghosts))
    gm.assert_same_mesh(gm.read(path), whole)
    world.Barrier()

# No process has cells.
write(Source(lambda step: vtkUnstructuredGrid()))
assert gm.read(path).GetNumberOfCells() == 0
world.Barrier()

# An array that one process does not have, and a folder that is missing, are errors of all.
if ranks > 2:
    def without_array(_step):
        grid = own_part(whole)
        if rank == 1:
            grid.GetPointData().RemoveArray(0)
        return grid

    before = open(path, "rb").read()
    world.Barrier()
    _, messages = write(Source(without_array), expected=0)
    assert len(messages) == 1 and "array" in messages[0], messages
    assert open(path, "rb").read() == before
if ranks > 1:
    _, messages = write(Source(lambda step: own_part(whole)), expected=0,
                        FileName=os.path.join(folder, "missing", "file.gtn"))
    assert len(messages) == 1 and "missing" in messages[0], messages
    _, messages = write(Source(lambda step: own_part(whole)), expected=0, Hierarchy=True)
    assert len(messages) == 1 and "hierarchy" in messages[0], messages
