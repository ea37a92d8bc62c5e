# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Gatun Contour makes what ParaView's Contour makes, from files that are read on demand and from others,
on one rank and on several, and leaves alone what the reader tells of itself."""

import os

import gatunSample as sample
import numpy as np
from gatunParaView import load_plugin, load_state, rank_and_ranks
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import reference

simple = load_plugin()
ranks = rank_and_ranks()[1]
VALUE = 1.1
mesh = sample.make_source()
mesh.UpdatePipeline()
mesh = simple.Calculator(Input=mesh, ResultArrayName="vector",
                         Function="iHat*wave+jHat*2*coordsX+5*kHat*coordsY")
mesh.UpdatePipeline()
path = sample.temporary("contour.gtn")
simple.SaveData(path, proxy=mesh, ChunkSize=300, Hierarchy=1)


def open_file(mode, name=path):
    reader = simple.OpenDataFile(name)
    reader.LargeMesh = {"Never": -1, "Always": 0}[mode]
    reader.UpdatePipeline()
    return reader


def contour(source, array="wave", value=VALUE, make=simple.GatunContour):
    made = make(Input=source)
    made.ContourBy = ["POINTS", array]
    made.Isosurfaces = [value]
    return made


def area(surface):
    summed = simple.IntegrateVariables(Input=surface)
    summed.UpdatePipeline()
    return simple.servermanager.Fetch(summed).GetCellData().GetArray("Area").GetValue(0)


def same(one, other):
    """As many triangles, and as much area."""
    triangles = [sample.counts(surface)[1] for surface in (one, other)]
    assert triangles[0] == triangles[1] > 0, triangles
    areas = area(one), area(other)
    assert abs(areas[0] - areas[1]) < 1e-5 * areas[1], areas


def arrays(surface):
    surface.UpdatePipeline()
    return set(surface.PointData.keys()), set(surface.CellData.keys())


expected = contour(mesh, make=simple.Contour)
readers = {mode: open_file(mode) for mode in ("Always", "Never")}
shown = {mode: sample.counts(reader) for mode, reader in readers.items()}
assert shown["Always"] == (8, 12), shown  # the outline
for mode, reader in readers.items():
    surface = contour(reader)
    same(surface, expected)
    assert sample.counts(reader) == shown[mode], sample.counts(reader)
    assert arrays(surface) == ({"wave", "point", "vector", "Normals"}, {"cell"}), arrays(surface)
same(contour(mesh), expected)

# Normals are those of the whole mesh: towards lower values, and the same on whichever rank.
whole = simple.servermanager.Fetch(contour(readers["Always"]))
places = vtk_to_numpy(whole.GetPoints().GetData())
normals = vtk_to_numpy(whole.GetPointData().GetNormals())
assert np.allclose(np.linalg.norm(normals, axis=1), 1, atol=1e-5)
_, first, back = np.unique(places, axis=0, return_index=True, return_inverse=True)
assert (normals == normals[first][back.ravel()]).all(), "a seam"
assert (len(first) < len(places)) == (ranks > 1), (len(first), len(places))
gradients = np.cos(places / 3)
steep = np.linalg.norm(gradients, axis=1)
aligned = -np.einsum("ij,ij->i", normals, gradients) / steep
assert (aligned > 0.8)[steep > 0.5].all()  # elsewhere the tetrahedra differ more from the waves

# What it carries, and how.
surface = contour(readers["Always"])
surface.ComputeNormals = surface.ComputeScalars = 0
assert arrays(surface) == ({"point", "vector"}, {"cell"}), arrays(surface)
triangles = sample.counts(surface)[1]
surface.OutputStrips = 1
strips = sample.counts(surface)[1]
assert ranks <= strips < triangles, (strips, triangles)
assert arrays(surface)[1] == set()
surface.OutputPointsPrecision = "Double"
assert sample.counts(surface)[1] == strips
surface.OutputStrips = 0
same(surface, expected)
surface.Isosurfaces = [VALUE, -0.5]
assert sample.counts(surface)[1] == triangles + sample.counts(contour(mesh, value=-0.5))[1]
surface.Isosurfaces = [77]
assert sample.counts(surface) == (0, 0)

# Components and the length, and what the isovalues begin with: the middle of their range.
component = simple.Calculator(Input=mesh, ResultArrayName="number", Function="vector_Y")
length = simple.Calculator(Input=mesh, ResultArrayName="number", Function="mag(vector)")
for number, scalars in ((1, component), (3, length)):
    surface = contour(readers["Always"], "vector", 11.3)
    surface.Component = number
    domain = surface.SMProxy.GetProperty("ContourValues").GetDomain("scalar_range")
    offered = domain.GetMinimum(0, reference(0)), domain.GetMaximum(0, reference(0))
    assert offered == scalars.PointData["number"].GetRange(), offered
    same(surface, contour(scalars, "number", 11.3, simple.Contour))


def isovalue(source):
    """The one that a new filter has, and the range that it is offered."""
    made = simple.GatunContour(Input=source)
    made.ContourBy = ["POINTS", "wave"]
    simple.ResetProperty("ContourValues", made)
    domain = made.SMProxy.GetProperty("ContourValues").GetDomain("scalar_range")
    exists = reference(0)
    return list(made.Isosurfaces), [domain.GetMinimum(0, exists), domain.GetMaximum(0, exists)]


# All that needs is the outline: nothing of a file is decoded of which only the directory is whole.
with open(path, "rb") as file:
    content = bytearray(file.read())
middle = len(content) // 2
content[middle - 2000:middle + 2000] = bytes(4000)
damaged = sample.temporary("contour-damaged.gtn")
with open(damaged, "wb") as file:
    file.write(content)
low, high = mesh.PointData["wave"].GetRange()
for reader in (readers["Always"], readers["Never"], open_file("Always", damaged)):
    value, offered = isovalue(reader)
    assert offered == [low, high], (offered, low, high)
    assert len(value) == 1 and abs(value[0] - (low + high) / 2) < 1e-6 * (high - low), value

# The simplified mesh, and a region, which is not on demand.
for reader in readers.values():
    reader.SimplificationRatio = 0.6
simplified = contour(readers["Never"], make=simple.Contour)
fewer = sample.counts(contour(readers["Always"]))[1]
assert 0 < fewer < 0.8 * triangles, (fewer, triangles)
assert fewer == sample.counts(contour(readers["Never"]))[1]
if ranks == 1:
    same(contour(readers["Always"]), simplified)
for reader in readers.values():
    reader.SimplificationRatio = 0
reader = readers["Never"]
reader.Box = [0, 3, 0, 3, 0, 3]
part = sample.counts(contour(reader))[1]
assert 0 < part < triangles, part
reader.Box = [1, -1, 1, -1, 1, -1]

# A series of files.
names = []
for i in range(3):
    names.append(sample.temporary("contour_%d.gtn" % i))
    moved = simple.Transform(Input=mesh, Transform="Transform")
    moved.Transform.Translate = [i, 0, 0]
    moved.UpdatePipeline()
    simple.SaveData(names[-1], proxy=moved, ChunkSize=300)
for mode in ("Always", "Never"):
    series = open_file(mode, names)
    surface = contour(series)
    for i in (2, 0, 1, 2):
        surface.UpdatePipeline(i)
        bounds = surface.GetDataInformation().GetBounds()
        assert abs(bounds[0] - expected.GetDataInformation().GetBounds()[0] - i) < 1e-5, bounds

# A state.
state = sample.temporary("contour.pvsm")
surface = contour(readers["Always"], value=0.7)
surface.ComputeNormals = 0
kept = sample.counts(surface)
simple.SaveState(state)
for source in list(simple.GetSources().values()):
    simple.Delete(source)
assert not simple.GetSources()
load_state(state)
found = [source for source in simple.GetSources().values()
         if source.GetXMLName() == "GatunContour" and list(source.Isosurfaces) == [0.7]]
assert len(found) == 1, found
assert not found[0].ComputeNormals
assert sample.counts(found[0]) == kept, (sample.counts(found[0]), kept)
os.remove(state)
