# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Arrays chosen in the reader and in the writer; options of the writer; progress and abort."""

import os

import numpy as np
from vtkmodules.vtkCommonCore import vtkSMPTools
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

import gatunMeshes as gm
from gatun.vtk import vtkGatunErrorCode, vtkGatunReader, vtkGatunWriter

grid = gm.block(n=12)
path = gm.temporary("selections.gtn")
gm.write(grid, path)


def names(attributes):
    return [a.GetName() for a in gm.arrays_of(attributes)]


# The reader.
reader = vtkGatunReader()
reader.SetFileName(path)
# A choice made before the file is known holds.
reader.SetPointArrayStatus("wave", 0)
reader.SetCellArrayStatus("no such array", 0)
reader.UpdateInformation()
assert [reader.GetPointArrayName(i) for i in range(reader.GetNumberOfPointArrays())] == \
    ["point", "wave", "vector"]
assert reader.GetNumberOfCellArrays() == 1 and reader.GetCellArrayName(0) == "cell"
assert reader.GetPointArrayStatus("wave") == 0 and reader.GetPointArrayStatus("point") == 1
reader.Update()
assert names(reader.GetOutput().GetPointData()) == ["point", "vector"]
gm.assert_same_mesh(grid, reader.GetOutput(), skip=["wave"])
time = reader.GetMTime()
reader.GetCellDataArraySelection().DisableAllArrays()
assert reader.GetMTime() > time
reader.Update()
assert names(reader.GetOutput().GetCellData()) == []
reader.GetPointDataArraySelection().EnableAllArrays()
reader.GetCellDataArraySelection().EnableAllArrays()
reader.Update()
gm.assert_same_mesh(grid, reader.GetOutput())
# Looking at the file does not modify the reader.
reader = vtkGatunReader()
reader.SetFileName(path)
reader.UpdateInformation()  # VTK 9.6 takes new names of arrays for a change
time = reader.GetMTime()
reader.UpdateInformation()
reader.Update()
assert reader.GetMTime() == time
# A choice survives a file that does not have the array.
other = gm.temporary("no-wave.gtn")
few = gm.block(n=2)
few.GetPointData().RemoveArray("wave")
gm.write(few, other)
reader.SetPointArrayStatus("wave", 0)
for name in (other, path):
    reader.SetFileName(name)
    reader.Update()
    assert names(reader.GetOutput().GetPointData()) == ["point", "vector"], name
assert not reader.GetPointArrayStatus("wave")

# The writer.
writer = vtkGatunWriter()
writer.SetInputDataObject(grid)
writer.SetFileName(path)
writer.GetPointDataArraySelection().DisableArray("vector")
assert writer.Write() == 1
assert names(gm.read(path).GetPointData()) == ["point", "wave"]
assert names(gm.read(path).GetCellData()) == ["cell"]
writer.GetPointDataArraySelection().SetUnknownArraySetting(0)
writer.GetCellDataArraySelection().SetUnknownArraySetting(0)
writer.GetPointDataArraySelection().EnableArray("wave")
assert writer.Write() == 1
assert names(gm.read(path).GetPointData()) == ["wave"]
assert names(gm.read(path).GetCellData()) == []
gm.assert_same_mesh(gm.make_grid(*gm.lattice(12)), gm.read(path), skip=["wave"])

# Options are clamped.
for value, expected in ((-5, 0), (0, 0), (1, 64), (64, 64), (5000, 5000), (1 << 30, 1048576)):
    writer.SetChunkSize(value)
    assert writer.GetChunkSize() == expected
for value, expected in ((0, 1), (5, 5)):
    writer.SetKeyStepInterval(value)
    assert writer.GetKeyStepInterval() == expected
for setter, expected in ((writer.SetKeepOrderToPoints, 1), (writer.SetKeepOrderToCells, 2),
                         (writer.SetKeepOrderToPointsAndCells, 3), (writer.SetKeepOrderToAll, 7),
                         (writer.SetKeepOrderToNone, 0)):
    setter()
    assert writer.GetKeepOrder() == expected

# Statistics add up.
writer = gm.write(grid, path, KeepOrder=7)
assert gm.statistic(writer, "Points") == grid.GetNumberOfPoints()
assert gm.statistic(writer, "Cells") == grid.GetNumberOfCells() and gm.statistic(writer, "TimeSteps") == 1
parts = [gm.statistic(writer, part + "Bytes") for part in (
    "Connectivity", "Geometry", "Order", "Array", "FieldData", "Directory")]
assert sum(parts) == os.path.getsize(path) == gm.statistic(writer, "FileBytes"), (parts, gm.statistic(writer, "FileBytes"))
assert gm.statistic(writer, "ConnectivityBytes") > 0 and gm.statistic(writer, "OrderBytes") > 0

# Writing does what Update does, and the same bytes each time.
first = open(path, "rb").read()
writer.Modified()
writer.Update()
assert writer.GetErrorCode() == 0 and open(path, "rb").read() == first


# Progress goes up to 1; abort leaves nothing behind, and the next run is whole.
class Watch:
    def __init__(self, algorithm, stop=2.0):
        self.seen, self.stop, self.algorithm = [], stop, algorithm
        self.tag = algorithm.AddObserver("ProgressEvent", self.note)

    def note(self, *_):
        self.seen.append(self.algorithm.GetProgress())
        if self.algorithm.GetProgress() >= self.stop:
            self.algorithm.AbortExecuteOn()

    def end(self):
        self.algorithm.RemoveObserver(self.tag)
        self.algorithm.AbortExecuteOff()  # the pipeline does so itself before VTK 9.2


for make, run in ((vtkGatunReader, "Update"), (vtkGatunWriter, "Write")):
    algorithm = make()
    algorithm.SetFileName(path)
    if make is vtkGatunWriter:
        algorithm.SetInputDataObject(grid)
        algorithm.SetChunkSize(500)
    watch = Watch(algorithm)
    getattr(algorithm, run)()
    assert watch.seen == sorted(watch.seen) and watch.seen[-1] == 1 and len(watch.seen) > 3, watch.seen
    watch.end()

content = open(path, "rb").read()


def files():
    """Ours in the folder, where other tests may be at work, too."""
    names = os.listdir(os.path.dirname(path))
    return sorted(name for name in names if "aborted" in name or "selections" in name)


# In one thread, because others may have done all of the work before this one tells its progress.
vtkSMPTools.Initialize(1)
before = files()
for stop in (0.0, 0.2, 0.6):
    writer = vtkGatunWriter()
    errors = gm.Errors(writer)
    writer.SetFileName(path)
    writer.SetInputDataObject(grid)
    writer.SetChunkSize(300)
    watch = Watch(writer, stop)
    assert writer.Write() == 0 and writer.GetErrorCode() == vtkGatunErrorCode.AbortedError
    assert not errors.messages
    assert open(path, "rb").read() == content
    watch.end()
    other = gm.temporary("aborted.gtn")
    writer.SetFileName(other)
    assert writer.Write() == 1 and writer.GetErrorCode() == 0
    gm.assert_same_mesh(grid, gm.read(other))
    os.remove(other)
assert files() == before

for stop in (0.0, 0.3):
    reader = vtkGatunReader()
    errors = gm.Errors(reader)
    reader.SetFileName(path)
    watch = Watch(reader, stop)
    reader.Update()
    assert reader.GetErrorCode() == vtkGatunErrorCode.AbortedError and not errors.messages
    assert reader.GetOutput().GetNumberOfPoints() == 0
    watch.end()
    reader.Update()
    assert reader.GetErrorCode() == 0
    gm.assert_same_mesh(grid, reader.GetOutput())
vtkSMPTools.Initialize()
