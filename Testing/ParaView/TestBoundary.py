# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""A mesh on demand shows the boundary that Save Data wrote, which looks like that of the whole mesh,
and filters work on it, on any number of ranks."""

import gatunSample as sample
from gatunParaView import load_plugin, rank_and_ranks
from gatunSurfacePicture import compare_picture
from paraview import servermanager, smtesting

smtesting.ProcessCommandLineArguments()
simple = load_plugin()
rank, ranks = rank_and_ranks()
path = sample.temporary("boundary.gtn")
simple.SaveData(path, proxy=sample.make_source(), ChunkSize=300, WriteBoundary=1)
reader = simple.OpenDataFile(path)
reader.LargeMesh = 0


def cells_of(proxy):
    proxy.UpdatePipeline()
    return proxy.GetDataInformation().GetNumberOfCells()


def range_of(proxy, name):
    return proxy.PointData[name].GetRange(0)


def size_of(proxy, name):
    """The length or area of all cells, without those that several ranks have."""
    proxy.UpdatePipeline()
    summed = simple.IntegrateVariables(Input=proxy)
    summed.UpdatePipeline()
    return servermanager.Fetch(summed).GetCellData().GetArray(name).GetValue(0)


faces = cells_of(reader)
assert faces == sample.BOUNDARY if ranks == 1 else faces >= sample.BOUNDARY, faces
assert abs(size_of(reader, "Area") - 6 * sample.SIDE ** 2) < 1e-2
whole = simple.OpenDataFile(path)
whole.LargeMesh = -1
assert cells_of(whole) >= sample.TETS > 2 * faces
assert range_of(reader, "wave") == range_of(whole, "wave")
assert reader.GetDataInformation().GetBounds() == whole.GetDataInformation().GetBounds()

# Planes and surfaces that all ranks have a part of, as IntegrateVariables needs a cell on the first one.
# A slice is the outline of the cut, a clip the shell of one side, a contour the lines where the
# isosurface ends.
middle = [0.5 * sample.SIDE + 0.25] * 3
cut = simple.Slice(Input=reader)
cut.SliceType.Origin = middle
cut.SliceType.Normal = [0, 0, 1]
assert abs(size_of(cut, "Length") - 4 * sample.SIDE) < 1e-3, size_of(cut, "Length")
half = simple.Clip(Input=reader)
half.ClipType.Origin = middle
half.ClipType.Normal = [0, 0, 1]
expected = sample.SIDE ** 2 + 4 * sample.SIDE * middle[0]
assert abs(size_of(half, "Area") - expected) < 1e-2, size_of(half, "Area")
lines = simple.Contour(Input=reader, ContourBy=["POINTS", "wave"], Isosurfaces=[0.5])
assert cells_of(lines) > sample.SIDE

compare_picture(reader)
