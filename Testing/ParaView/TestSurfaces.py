# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Save Data and File > Open of surfaces, on one rank and on several: polygons, lines and strips come
back, in pieces with ghosts, with their arrays and in time; grids keep their own reader."""

import gatunSample as sample
from gatunParaView import load_plugin, rank_and_ranks
from paraview import servermanager

simple = load_plugin()
rank, ranks = rank_and_ranks()


def count_of(proxy):
    """Points and cells of all ranks."""
    proxy.UpdatePipeline()
    info = proxy.GetDataInformation()
    return info.GetNumberOfPoints(), info.GetNumberOfCells()


def area_in_all(proxy):
    summed = simple.IntegrateVariables(Input=proxy, DivideCellDataByVolume=0)
    summed.UpdatePipeline()
    return servermanager.Fetch(summed).GetCellData().GetArray("Area").GetValue(0)


sphere = simple.Sphere(ThetaResolution=60, PhiResolution=60)
sphere.UpdatePipeline()
path = sample.temporary("surface.gtn")
simple.SaveData(path, proxy=sphere, ChunkSize=300)
reader = simple.OpenDataFile(path)
assert reader.GetXMLName() == "GatunSurfaceReader", reader.GetXMLName()
reader.UpdatePipeline()
info = reader.GetDataInformation()
assert info.GetDataSetTypeAsString() == "vtkPolyData"
assert abs(area_in_all(reader) - area_in_all(sphere)) < 1e-5 * area_in_all(sphere), (area_in_all(reader), area_in_all(sphere))
assert info.GetPointDataInformation().GetArrayInformation("Normals")
if ranks == 1:
    assert count_of(reader) == count_of(sphere)
else:
    assert info.GetCellDataInformation().GetArrayInformation("vtkGhostType")

# A grid beside it, under the same suffix.
mesh = sample.make_source()
grid = sample.temporary("grid.gtn")
simple.SaveData(grid, proxy=mesh)
assert simple.OpenDataFile(grid).GetXMLName() == "GatunReader"

# Isosurfaces, lines and strips.
contour = simple.Contour(Input=mesh, ContourBy=["POINTS", "wave"], Isosurfaces=[0.5])
simple.SaveData(path, proxy=contour, ChunkSize=300)
back = simple.OpenDataFile(path)
assert abs(area_in_all(back) - area_in_all(contour)) < 1e-5 * area_in_all(contour)
edges = simple.FeatureEdges(Input=simple.ExtractSurface(Input=mesh))
simple.SaveData(path, proxy=edges)
back = simple.OpenDataFile(path)
assert back.GetXMLName() == "GatunSurfaceReader"
back.UpdatePipeline()
bounds = [proxy.GetDataInformation().GetBounds() for proxy in (edges, back)]
assert bounds[0] == bounds[1]
strips = simple.TriangleStrips(Input=simple.Plane(XResolution=20, YResolution=20))
simple.SaveData(path, proxy=strips, ChunkSize=64)
back = simple.OpenDataFile(path)
assert abs(area_in_all(back) - 1) < 1e-6, area_in_all(back)

# Rounded, in chosen arrays, and only the outline on demand.
simple.SaveData(path, proxy=sphere, PointTolerance="abs:0.01", ChunkSize=300, ChooseArraysToWrite=1, PointDataArrays=[])
back = simple.OpenDataFile(path)
back.UpdatePipeline()
assert abs(area_in_all(back) - area_in_all(sphere)) < 0.05 * area_in_all(sphere)
assert not back.GetDataInformation().GetPointDataInformation().GetArrayInformation("Normals")
assert back.LargeMesh == 5000000 and not back.GetProperty("SplitCells")
back.LargeMesh = 0
back.UpdatePipeline()
assert back.GetDataInformation().GetNumberOfCells() == 12

# Arrays with errors.
simple.SaveData(path, proxy=sphere, ArrayTolerances=["Normals=abs:0.02"])
back = simple.OpenDataFile(path)
back.UpdatePipeline()
ranges = [[proxy.GetDataInformation().GetPointDataInformation().GetArrayInformation("Normals")
           .GetComponentRange(i) for i in range(3)] for proxy in (sphere, back)]
assert ranges[0] != ranges[1]
for one, other in zip(*ranges):
    for a, b in zip(one, other):
        assert abs(a - b) <= 0.02, ranges
