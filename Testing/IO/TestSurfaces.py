# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Surfaces come back from a .gtn as they were: exactly with their order kept, and as the same points
and cells without."""

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkContourFilter, vtkPolyDataNormals, vtkStripper, vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource

import gatunMeshes as gm
import gatunPolyData as pd
from gatun.vtk import vtkGatunWriter

KEEP_ALL = 7


def sphere():
    source = vtkSphereSource()
    source.SetThetaResolution(80)
    source.SetPhiResolution(60)
    source.Update()
    return source.GetOutput()


def strips():
    stripper = vtkStripper()
    stripper.SetInputData(sphere())
    stripper.Update()
    assert stripper.GetOutput().GetNumberOfStrips() > 100
    return stripper.GetOutput()


def contour():
    filter = vtkContourFilter()
    filter.SetInputData(gm.block(n=8))
    filter.SetInputArrayToProcess(0, 0, 0, 0, "wave")
    filter.SetValue(0, 1.5)
    filter.Update()
    assert filter.GetOutput().GetNumberOfPolys() > 100
    return filter.GetOutput()


narrow = pd.make(np.random.default_rng(0).random((9, 3)).astype(np.float32), wide=False,
                 Lines=[[0, 1], [1, 2, 3]], Polys=[[4, 5, 6], [5, 6, 7, 8]])
surfaces = {
    "sphere": sphere(), "strips": strips(), "contour": contour(), "wave": pd.wave(),
    "double": pd.wave(dtype=np.float64), "moebius": pd.moebius(), "odd": pd.odd(),
    "mixed": pd.mixed(), "narrow": narrow,
    "points": pd.make(np.random.default_rng(1).random((20, 3))),
    "vertices": pd.make(np.eye(3), Verts=[[0], [2], [1]]), "empty": vtkPolyData(),
    "no points": pd.make(np.zeros((0, 3)), Polys=[[], []])}
for name, surface in surfaces.items():
    if name not in ("sphere", "strips", "contour"):
        pd.add_arrays(surface)
    for options in ({}, {"ChunkSize": 64}):
        path = gm.temporary("surface.gtn")
        writer = gm.write(surface, path, KeepOrder=KEEP_ALL, **options)
        assert gm.statistic(writer, "Cells") == surface.GetNumberOfCells()
        pd.assert_equal(surface, pd.read(path))
        gm.write(surface, path, **options)
        pd.assert_same_surface(surface, pd.read(path))

# Ids are of 64 bits if those of any list are.
path = gm.temporary("surface.gtn")
gm.write(narrow, path)
back = pd.read(path)
assert not gm.has_wide_ids(back.GetPolys()) and not gm.has_wide_ids(back.GetLines())
narrow.SetVerts(pd.cell_array([[3]]))
narrow.GetCellData().Initialize()
gm.write(narrow, path)
back = pd.read(path)
assert gm.has_wide_ids(back.GetPolys()) and gm.has_wide_ids(back.GetLines())

# Ghost cells are cells as all others.
surface = pd.add_arrays(pd.wave())
ghosts = np.zeros(surface.GetNumberOfCells(), np.uint8)
ghosts[:200] = 1
gm.add_array(surface.GetCellData(), ghosts, "vtkGhostType")
gm.write(surface, path, KeepOrder=KEEP_ALL)
back = pd.read(path)
assert pd.cells_of(back) == pd.cells_of(surface)
for name, expected in (("cell", np.arange(surface.GetNumberOfCells())), ("vtkGhostType", ghosts)):
    assert np.array_equal(gm.values_of(back.GetCellData().GetArray(name)).ravel(), expected)

# Only chosen arrays are written.
surface = pd.add_arrays(pd.wave())
writer = vtkGatunWriter()
writer.SetInputData(surface)
writer.SetFileName(path)
writer.GetPointDataArraySelection().SetUnknownArraySetting(0)
writer.GetCellDataArraySelection().SetUnknownArraySetting(0)
assert writer.Write() == 1
assert not pd.read(path).GetPointData().GetNumberOfArrays()

# What a filter of VTK makes of the surface is what it made before.
normals = []
for data in (surfaces["strips"], pd.read(path)):
    filter = vtkTriangleFilter()
    filter.SetInputData(data)
    of = vtkPolyDataNormals()
    of.SetInputConnection(filter.GetOutputPort())
    of.Update()
    normals.append(of.GetOutput().GetNumberOfPolys())
assert normals[0] == surfaces["sphere"].GetNumberOfPolys() and normals[1] > 0
