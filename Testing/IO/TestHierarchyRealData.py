# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Meshes of all kinds are read from files with a hierarchy, at many numbers of points: tetrahedron for
tetrahedron what vtkGatunSimplify leaves of them."""

import glob
import os

import numpy as np
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

import gatunMeshes as gm
from gatun.vtk import vtkGatunReader, vtkGatunSimplify

files = sorted(glob.glob(os.path.join(gm.data_folder(), "*.vtu")))
assert files
path = gm.temporary("real-hierarchy.gtn")
for file in files:
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(file)
    reader.Update()
    grid = reader.GetOutput()
    if grid.GetCells().GetNumberOfConnectivityIds() != 4 * grid.GetNumberOfCells():
        continue
    gm.add_array(grid.GetCellData(), np.arange(grid.GetNumberOfCells()), "cell id")
    simplify = vtkGatunSimplify()
    simplify.SetInputDataObject(grid)
    points = grid.GetNumberOfPoints()
    gm.write(grid, path, ChunkSize=20000, KeepOrder=7, Hierarchy=True)
    kept = vtkGatunReader()
    kept.SetFileName(path)
    for ratio in (1e-4, 0.1, 0.5, 0.9, 0.99, 1):
        simplify.SetSimplificationRatio(ratio)
        simplify.Update()
        kept.SetSimplificationRatio(ratio)
        kept.Update()
        expected, got = simplify.GetOutput(), kept.GetOutput()
        assert got.GetNumberOfPoints() == expected.GetNumberOfPoints()
        np.testing.assert_array_equal(gm.coordinates(got), gm.coordinates(expected))
        corners = [np.sort(gm.connectivity(g).reshape(-1, 4)) for g in (got, expected)]
        np.testing.assert_array_equal(*corners)
        gm.assert_same_arrays(got.GetPointData(), expected.GetPointData())
        gm.assert_same_arrays(got.GetCellData(), expected.GetCellData())
    # Without the order, from base meshes, in one mesh as in parts.
    simplify.SetSimplificationRatio(0.8)
    simplify.Update()
    expected = np.sort(gm.values_of(simplify.GetOutput().GetCellData().GetArray("cell id")).ravel())
    gm.write(grid, path, ChunkSize=5000, Hierarchy=True, Levels=8)
    plain = vtkGatunReader()
    plain.SetFileName(path)
    plain.SetSimplificationRatio(0.8)
    for pieces in (1, 3):
        ids = []
        for piece in range(pieces):
            plain.UpdatePiece(piece, pieces, 0)
            ids.append(gm.values_of(plain.GetOutput().GetCellData().GetArray("cell id")).ravel())
        np.testing.assert_array_equal(np.sort(np.concatenate(ids)), expected)
    print(f"{os.path.basename(file)}: {points} points")
