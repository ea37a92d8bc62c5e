# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Surfaces that cannot be written, files that a reader does not read, and damaged files: a code, a
message that names the trouble, and nothing else."""

import os

import numpy as np
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkCommonMisc import vtkErrorCode

import gatunMeshes as gm
import gatunPolyData as pd
from gatun.vtk import vtkGatunErrorCode, vtkGatunReader, vtkGatunSurfaceReader, vtkGatunWriter

INVALID = vtkGatunErrorCode.InvalidInputError
folder = os.path.join(os.environ["GATUN_TEST_TEMP"], "surface-errors")
os.makedirs(folder, exist_ok=True)
for name in os.listdir(folder):
    os.remove(os.path.join(folder, name))
path = os.path.join(folder, "surface.gtn")


def refuse(surface, *texts, **options):
    writer = vtkGatunWriter()
    errors = gm.Errors(writer)
    writer.SetInputDataObject(surface)
    writer.SetFileName(path)
    gm.set_options(writer, **options)
    assert writer.Write() == 0 and writer.GetErrorCode() == INVALID, writer.GetErrorCode()
    assert len(errors.messages) == 1, str(errors)
    for text in (path, *texts):
        assert text in str(errors), (text, str(errors))
    assert os.listdir(folder) == []


points = np.random.default_rng(0).random((10, 3))
refuse(pd.make(points, Polys=[[0, 1, 10]]), "the polygons are wrong", "names point 10 of 10")
refuse(pd.make(points, Polys=[[0, 1, 2]], Strips=[[0, 1, -1]]), "the strips are wrong", "point -1")
refuse(pd.make(points, Lines=[[0, 99]]), "the lines are wrong", "point 99")
no_points = vtkPolyData()
no_points.SetVerts(pd.cell_array([[0]]))
refuse(no_points, "the vertices are wrong", "names point 0 of 0")
wrong = pd.make(points, Polys=[[0, 1, 2], [2, 1, 3]])
wrong.GetPolys().GetOffsetsArray().SetValue(1, 7)
refuse(wrong, "the polygons are wrong", "offsets")
good = pd.make(points, Polys=[[0, 1, 2], [2, 1, 3]])
for attributes, place in ((vtkPolyData.GetPointData, "point"), (vtkPolyData.GetCellData, "cell")):
    long = pd.make(points, Polys=[[0, 1, 2], [2, 1, 3]])
    gm.add_array(attributes(long), np.zeros(3, np.float32), "short one")
    refuse(long, "the %s array 'short one' has 3 tuples" % place)
texts = vtkStringArray()
texts.SetName("texts")
texts.SetNumberOfValues(10)
good.GetPointData().AddArray(texts)
refuse(good, "texts")
good.GetPointData().Initialize()
gm.add_array(good.GetPointData(), np.arange(10.0), "number")
refuse(good, "hierarchy of a surface needs the whole", Hierarchy=True, NumberOfPieces=2)
refuse(good, "surface", "no 3D cells", SplitCells=True)
refuse(good, "layers are made of tetrahedra", Layers="number")
refuse(good, "must be absolute, relative", PointTolerance=(3, 0.5))
refuse(good, "finite", PointTolerance=(1, float("nan")))
refuse(good, "whole mesh", PointTolerance=(4, 4), NumberOfPieces=2)


# Each reader names the other one.
def fails(reader, name, code, *texts):
    errors = gm.Errors(reader)
    reader.SetFileName(name)
    reader.Update()
    assert reader.GetErrorCode() == code, reader.GetErrorCode()
    for text in (name, *texts):
        assert text in str(errors), (text, str(errors))
    assert reader.GetOutput().GetNumberOfPoints() == 0
    assert reader.GetOutput().GetNumberOfCells() == 0


gm.write(pd.add_arrays(pd.mixed()), path)
grid = os.path.join(folder, "grid.gtn")
gm.write(gm.block(), grid)
fails(vtkGatunReader(), path, INVALID, "holds a surface", "vtkGatunSurfaceReader")
fails(vtkGatunSurfaceReader(), grid, INVALID, "holds a grid", "vtkGatunReader")
for reader, mine, other in ((vtkGatunReader(), grid, path), (vtkGatunSurfaceReader(), path, grid)):
    assert reader.CanReadFile(mine) == 1 and reader.CanReadFile(other) == 0
    assert reader.CanReadFile(__file__) == 0 and reader.CanReadFile(None) == 0
    assert reader.CanReadFile(os.path.join(folder, "missing.gtn")) == 0

# Damaged and cut files.
whole = open(path, "rb").read()
damaged = os.path.join(folder, "damaged.gtn")
cut = len(whole) // 2
open(damaged, "wb").write(whole[:cut])
fails(vtkGatunSurfaceReader(), damaged, vtkErrorCode.PrematureEndOfFileError)
assert vtkGatunSurfaceReader().CanReadFile(damaged) == 0
assert vtkGatunReader().CanReadFile(damaged) == 1  # which then tells what is wrong
at = whole.index(b"SURF") + 24
for change in (at, 200, cut):
    open(damaged, "wb").write(whole[:change] + bytes([whole[change] ^ 5]) + whole[change + 1:])
    fails(vtkGatunSurfaceReader(), damaged, vtkErrorCode.FileFormatError)
