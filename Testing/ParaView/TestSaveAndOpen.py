# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Save Data and File > Open, on one rank and on several: the mesh comes back, also chosen arrays,
regions, time steps in one file and series of files, pieces."""

import os

import gatunSample as sample
from gatunParaView import load_plugin, rank_and_ranks

simple = load_plugin()
rank, ranks = rank_and_ranks()
mesh = sample.make_source()
assert sample.counts(mesh) == (sample.POINTS, sample.TETS)

path = sample.temporary("saved.gtn")
simple.SaveData(path, proxy=mesh, ChunkSize=300)
reader = simple.OpenDataFile(path)
assert reader.GetXMLName() == "GatunReader"
assert sample.owned(reader) == (sample.POINTS, sample.TETS), sample.owned(reader)
assert (sample.counts(reader)[1] > sample.TETS) == (ranks > 1)
volume = sample.volume(reader)
assert abs(volume - sample.VOLUME) < 1e-6 * sample.VOLUME, volume


def arrays(proxy):
    info = proxy.GetDataInformation()
    return [{data.GetArrayInformation(i).GetName() for i in range(data.GetNumberOfArrays())}
            for data in (info.GetPointDataInformation(), info.GetCellDataInformation())]


ids = [{"GlobalPointIds", "vtkGhostType"}, {"GlobalCellIds", "vtkGhostType"}]
extra = ids if ranks > 1 else [set(), set()]
assert arrays(reader) == [{"wave", "point"} | extra[0], {"cell"} | extra[1]], arrays(reader)
for name, last in (("point", sample.POINTS - 1), ("wave", None)):
    ranges = [p.GetDataInformation().GetPointDataInformation().GetArrayInformation(name)
              .GetComponentRange(0) for p in (mesh, reader)]
    assert ranges[0] == ranges[1], ranges

# The surface has no faces inside, on however many ranks.
surface = simple.ExtractSurface(Input=reader)
surface.UpdatePipeline()
area = simple.IntegrateVariables(Input=surface, DivideCellDataByVolume=0)
area.UpdatePipeline()
area = simple.servermanager.Fetch(area).GetCellData().GetArray("Area").GetValue(0)
assert abs(area - 6 * sample.SIDE ** 2) < 1e-6 * area, area

# Saved once more, from what was read in parts: the parts are joined again.
again = sample.temporary("again.gtn")
simple.SaveData(again, proxy=reader)
assert sample.owned(simple.OpenDataFile(again)) == (sample.POINTS, sample.TETS)
joined = simple.OpenDataFile(again)
joined.GenerateGlobalIds = 1
joined.UpdatePipeline()
ids = joined.GetDataInformation().GetPointDataInformation().GetArrayInformation("GlobalPointIds")
assert ids.GetComponentRange(0) == (0, sample.POINTS - 1), ids.GetComponentRange(0)
# Arrays chosen.
reader.PointArrayStatus = ["wave"]
reader.CellArrayStatus = []
reader.UpdatePipeline()
assert arrays(reader) == [{"wave"} | extra[0], extra[1]], arrays(reader)
reader.PointArrayStatus = ["wave", "point"]
reader.CellArrayStatus = ["cell"]
only = sample.temporary("only.gtn")
simple.SaveData(only, proxy=mesh, ChooseArraysToWrite=1, PointDataArrays=["wave"])
few = simple.OpenDataFile(only)
few.UpdatePipeline()
assert arrays(few)[0] - extra[0] == {"wave"}, arrays(few)

# A region.
reader.Box = [0, 1, 0, 1, 0, 1]
assert 0 < sample.owned(reader)[1] < sample.TETS / 2
reader.Box = [1, -1, 1, -1, 1, -1]
reader.ValueRangeArray = "wave"
reader.ValueRange = [2.9, 3]
part = sample.owned(reader)[1]
assert 0 < part < sample.TETS, part
reader.ValueRangeArray = ""
assert sample.owned(reader)[1] == sample.TETS

# A series of files.
names = []
for i in range(3):
    names.append(sample.temporary("series_%d.gtn" % i))
    moved = simple.Transform(Input=mesh, Transform="Transform")
    moved.Transform.Translate = [i, 0, 0]
    moved.UpdatePipeline()
    simple.SaveData(names[-1], proxy=moved)
series = simple.OpenDataFile(names)
assert list(series.TimestepValues) == [0, 1, 2], list(series.TimestepValues)
for i in (2, 0, 1):
    series.UpdatePipeline(i)
    assert series.GetDataInformation().GetBounds()[0] == i

# Time steps in one file, by the rank that has the mesh or by all of them.
moving = sample.make_moving_source([0.5, 1.5, 2.5])
steps = sample.temporary("steps.gtn")
simple.SaveData(steps, proxy=moving, WriteAllTimeSteps=1)
back = simple.OpenDataFile(steps)
assert list(back.TimestepValues) == [0.5, 1.5, 2.5], list(back.TimestepValues)
for time in (1.5, 0.5, 2.5):
    back.UpdatePipeline(time)
    ramp = back.GetDataInformation().GetPointDataInformation().GetArrayInformation("ramp")
    assert ramp.GetComponentRange(0) == (0, sample.SIDE * time), ramp.GetComponentRange(0)
    assert sample.owned(back) == (sample.POINTS, sample.TETS)

# The same time steps as a series of files, and some of them.
for first, last, stride, expected in ((0, -1, 1, (0, 1, 2)), (1, 2, 1, (1, 2)), (0, 2, 2, (0, 2))):
    names = [sample.temporary("moved_%d.gtn" % i) for i in range(3)]
    simple.SaveData(sample.temporary("moved.gtn"), proxy=moving, WriteTimeStepsAsFileSeries=1,
                    MinTimeStep=first, MaxTimeStep=last, TimeStepStride=stride)
    assert [i for i in range(3) if os.path.exists(names[i])] == list(expected), first
    for i in expected:
        one = simple.OpenDataFile(names[i])
        one.UpdatePipeline()
        ramp = one.GetDataInformation().GetPointDataInformation().GetArrayInformation("ramp")
        assert ramp.GetComponentRange(0) == (0, sample.SIDE * [0.5, 1.5, 2.5][i])

# In pieces, one after the other, of a source that knows them.
pieces = sample.temporary("pieces.gtn")
simple.SaveData(pieces, proxy=reader, NumberOfPieces=4)
assert sample.owned(simple.OpenDataFile(pieces)) == (sample.POINTS, sample.TETS)
