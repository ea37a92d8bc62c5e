# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Isosurfaces and boundaries of real meshes come back bit by bit, as triangles, with normals and as
strips."""

import os

from vtkmodules.vtkFiltersCore import vtkContourFilter, vtkPolyDataNormals, vtkStripper
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

import gatunMeshes as gm
import gatunPolyData as pd

MESHES = ("comb_tets.vtu", "bluntfin_tets.vtu", "fire_ug.vtu", "can.vtu")
KEEP_ALL = 7
path = gm.temporary("real.gtn")
checked = 0


def check(algorithm):
    global checked
    algorithm.Update()
    surface = algorithm.GetOutput()
    assert surface.GetNumberOfCells() > 100
    writer = gm.write(surface, path, KeepOrder=KEEP_ALL)
    pd.assert_equal(surface, pd.read(path))
    print(surface.GetNumberOfCells(), "cells", gm.statistic(writer, "FileBytes"), "bytes")
    checked += 1


folder = gm.data_folder()
for name in MESHES:
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(os.path.join(folder, name))
    reader.Update()
    boundary = vtkDataSetSurfaceFilter()
    boundary.SetInputConnection(reader.GetOutputPort())
    check(boundary)
    data = reader.GetOutput().GetPointData()
    arrays = [data.GetArray(i) for i in range(data.GetNumberOfArrays()) if data.GetArray(i)]
    scalars = [array for array in arrays if array.GetNumberOfComponents() == 1
               and array.GetRange()[0] < array.GetRange()[1]]
    if not scalars:
        continue
    contour = vtkContourFilter()
    contour.SetInputConnection(reader.GetOutputPort())
    contour.SetInputArrayToProcess(0, 0, 0, 0, scalars[0].GetName())
    contour.SetValue(0, sum(scalars[0].GetRange()) / 2)
    contour.Update()
    if contour.GetOutput().GetNumberOfPolys() < 100:
        continue
    check(contour)
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(contour.GetOutputPort())
    check(normals)
    strips = vtkStripper()
    strips.SetInputConnection(boundary.GetOutputPort())
    check(strips)
assert checked >= 7, checked
