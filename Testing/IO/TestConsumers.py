# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Consumers of one output port do not disturb each other: each gets the piece, the ghost levels and
the time that it asked for, whatever another one asked for before."""

import random

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkUnstructuredGrid
from vtkmodules.vtkCommonExecutionModel import (
    vtkCompositeDataPipeline, vtkStreamingDemandDrivenPipeline as pipeline)

import gatunMeshes as gm
from gatun.vtk import vtkGatunContour, vtkGatunReader, vtkGatunSimplify, vtkGatunWriter

points, tets = gm.lattice(6)
TIMES = [0.0, 0.5, 2.0]


class Source(VTKPythonAlgorithmBase):
    """The steps to write."""

    def __init__(self):
        super().__init__(nInputPorts=0, nOutputPorts=1, outputType="vtkUnstructuredGrid")

    def RequestInformation(self, request, inInfo, outInfo):
        info = outInfo.GetInformationObject(0)
        info.Set(pipeline.TIME_STEPS(), TIMES, len(TIMES))
        info.Set(pipeline.TIME_RANGE(), [TIMES[0], TIMES[-1]], 2)
        return 1

    def RequestData(self, request, inInfo, outInfo):
        time = outInfo.GetInformationObject(0).Get(pipeline.UPDATE_TIME_STEP())
        grid = gm.make_grid(points, tets)
        gm.add_array(grid.GetPointData(), np.sin(points * (time + 1)), "wave")
        gm.add_array(grid.GetCellData(), np.arange(len(tets)), "cell")
        output = vtkUnstructuredGrid.GetData(outInfo, 0)
        output.ShallowCopy(grid)
        output.GetInformation().Set(vtkDataObject.DATA_TIME_STEP(), time)
        return 1


class Consumer(VTKPythonAlgorithmBase):
    """Keeps a copy of what it was given."""

    def __init__(self, reader):
        super().__init__(nInputPorts=1, nOutputPorts=1, inputType="vtkUnstructuredGrid",
                         outputType="vtkUnstructuredGrid")
        self.SetInputConnection(reader.GetOutputPort())
        self.runs = 0

    def RequestData(self, request, inInfo, outInfo):
        self.given = vtkUnstructuredGrid()
        self.given.DeepCopy(vtkUnstructuredGrid.GetData(inInfo[0], 0))
        self.runs += 1
        return 1

    def ask(self, time, piece, pieces, ghosts):
        """Asks anew, even for what it asked for before."""
        self.Modified()
        runs = self.runs
        self.UpdateTimeStep(time, piece, pieces, ghosts)
        assert self.runs == runs + 1
        return self.given


path = gm.temporary("consumers.gtn")
source = Source()
writer = vtkGatunWriter()
writer.SetInputConnection(source.GetOutputPort())
writer.SetFileName(path)
writer.SetChunkSize(100)
writer.WriteAllTimeStepsOn()
assert writer.Write() == 1


def new_reader(executive=None):
    made = vtkGatunReader()
    if executive:
        made.SetExecutive(executive)
    made.SetFileName(path)
    return made


def alone(request):
    """What a reader gives that nobody else asks."""
    lonely = new_reader()
    return Consumer(lonely).ask(*request), lonely


REQUESTS = [(TIMES[t], piece, pieces, ghosts)
            for t, (piece, pieces), ghosts in
            [(0, (0, 1), 0), (0, (1, 4), 0), (0, (1, 4), 1), (0, (1, 4), 2), (1, (1, 4), 0),
             (1, (2, 4), 1), (2, (3, 7), 2), (2, (3, 7), 0), (2, (0, 1), 1)]]
right = {request: alone(request)[0] for request in REQUESTS}
sizes = [right[request].GetNumberOfCells() for request in REQUESTS[1:4]]
assert sizes[0] < sizes[1] < sizes[2], "the requests must differ"

for executive in (None, pipeline(), vtkCompositeDataPipeline()):
    reader = new_reader(executive)
    # Every request once after every other one, of one consumer each.
    consumers = {request: Consumer(reader) for request in REQUESTS}
    for first in REQUESTS:
        for second in REQUESTS:
            for request in (first, second):
                given = consumers[request].ask(*request)
                gm.assert_equal(right[request], given)
                time = given.GetInformation().Get(vtkDataObject.DATA_TIME_STEP())
                assert time == request[0], (time, request)
    # And at random, of two consumers that change their minds.
    chance = random.Random(1)
    pair = [Consumer(reader), Consumer(reader)]
    for _ in range(60):
        request = chance.choice(REQUESTS)
        gm.assert_equal(right[request], chance.choice(pair).ask(*request))

# What was read is kept: the same request again does not read again, whatever its ghosts.
reader = new_reader()
consumer, other = Consumer(reader), Consumer(reader)
for request in REQUESTS:
    consumer.ask(*request)
    before = reader.GetOutput().GetMTime()
    consumer.ask(*request)
    other.ask(*request)
    assert reader.GetOutput().GetMTime() == before, request

# Fewer ghosts than before, asked of the reader itself.
reader = new_reader()
for ghosts in (0, 2, 1, 0, 1, -1):
    reader.UpdateTimeStep(TIMES[0], 1, 4, ghosts)
    gm.assert_equal(right[TIMES[0], 1, 4, max(0, ghosts)], reader.GetOutput())

# As everywhere in VTK, who asks for no time gets the one last asked for at this port.
reader = new_reader()
one, other = Consumer(reader), Consumer(reader)
one.UpdateTimeStep(TIMES[2])
other.Update()
assert other.given.GetInformation().Get(vtkDataObject.DATA_TIME_STEP()) == TIMES[2]


# Consumers of the file on the same port: neither do they change what others get, nor the other way round.
def contour_of(reader):
    contour = vtkGatunContour()
    contour.SetInputConnection(reader.GetOutputPort())
    contour.SetInputArrayToProcess(0, 0, 0, 0, "wave")
    contour.SetArrayComponent(0)
    contour.SetValue(0, 0.3)
    return contour


def simplified_of(reader):
    simplify = vtkGatunSimplify()
    simplify.SetInputConnection(reader.GetOutputPort())
    simplify.SetSimplificationRatio(0.5)
    return simplify


def copy_of(algorithm, request):
    """What it makes anew for a request."""
    algorithm.Modified()
    algorithm.UpdateTimeStep(*request)
    assert algorithm.GetErrorCode() == 0
    copy = algorithm.GetOutput().NewInstance()
    copy.DeepCopy(algorithm.GetOutput())
    return copy


writer.SetHierarchy(True)
assert writer.Write() == 1
for request in REQUESTS:  # in another order than before
    right[request] = alone(request)[0]
MAKERS = (contour_of, simplified_of)
expected = {(make, request): copy_of(make(new_reader()), request)
            for make in MAKERS for request in REQUESTS}
cells = [expected[contour_of, request].GetNumberOfCells() for request in REQUESTS]
assert max(cells) > 100 and len(set(cells)) > 4, cells
reader = new_reader()
consumer = Consumer(reader)
of_file = {make: make(reader) for make in MAKERS}
chance = random.Random(2)
for _ in range(80):
    request, kind = chance.choice(REQUESTS), chance.randrange(3)
    if kind == 2:
        gm.assert_equal(right[request], consumer.ask(*request))
        continue
    given = copy_of(of_file[MAKERS[kind]], request)
    if kind == 1:
        gm.assert_equal(expected[MAKERS[kind], request], given)
    else:
        assert given.GetNumberOfCells() == expected[MAKERS[kind], request].GetNumberOfCells()
        if given.GetNumberOfPoints():
            np.testing.assert_array_equal(
                vtk_to_numpy(given.GetPoints().GetData()),
                vtk_to_numpy(expected[MAKERS[kind], request].GetPoints().GetData()))
