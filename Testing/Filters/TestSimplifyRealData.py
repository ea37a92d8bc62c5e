# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Meshes of all kinds are simplified: orientations stay, the boundary stays, volumes nearly so, and the
mesh is that of merging one by one as numpy does it."""

import glob
import os

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

import gatunMeshes as gm
from gatun.vtk import vtkGatunSimplify


def volumes(points, tets):
    p = points[tets]
    return np.linalg.det(p[:, 1:] - p[:, :1]) / 6


def boundary_points(tets):
    faces = np.sort(np.concatenate([np.delete(tets, i, axis=1) for i in range(4)]), axis=1)
    unique, counts = np.unique(faces, axis=0, return_counts=True)
    return np.unique(unique[counts == 1])


files = sorted(glob.glob(os.path.join(gm.data_folder(), "*.vtu")))
assert files
for file in files:
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(file)
    reader.Update()
    grid = reader.GetOutput()
    if grid.GetCells().GetNumberOfConnectivityIds() != 4 * grid.GetNumberOfCells():
        continue
    gm.add_array(grid.GetPointData(), np.arange(grid.GetNumberOfPoints()), "point id")
    gm.add_array(grid.GetCellData(), np.arange(grid.GetNumberOfCells()), "cell id")
    points = vtk_to_numpy(grid.GetPoints().GetData()).astype(float)
    tets = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4)
    before = volumes(points, tets)
    on_boundary = np.zeros(len(points), bool)
    on_boundary[boundary_points(tets)] = True
    simplifier = vtkGatunSimplify()
    simplifier.SetInputDataObject(grid)
    for ratio in (0.5, 0.9, 0.98):
        simplifier.SetSimplificationRatio(ratio)
        simplifier.Update()
        output = simplifier.GetOutput()
        ids = vtk_to_numpy(output.GetPointData().GetArray("point id"))
        cells = vtk_to_numpy(output.GetCellData().GetArray("cell id"))
        new_tets = ids[vtk_to_numpy(output.GetCells().GetConnectivityArray()).reshape(-1, 4)]
        after = volumes(points, new_tets)
        turned = (before[cells] * after <= 0) & (before[cells] != 0)
        assert not turned.any(), (file, ratio, turned.sum())
        assert on_boundary[boundary_points(new_tets)].all(), (file, ratio)
        change = np.abs(after).sum() / np.abs(before).sum() - 1
        print(f"{os.path.basename(file)} {ratio}: {len(ids)} points, {len(cells)} tetrahedra, "
              f"volume {change:+.2e}, error {simplifier.GetOutputRMSError():.2e}")
        assert len(cells) < (1 - 0.7 * ratio) * len(tets), (file, ratio)
        # At 2 % of the points, a few merges decide how much of a thin part is left: rounding alone
        # moves that by a percent.
        assert abs(change) < (0.01 if ratio < 0.98 else 0.1), (file, ratio, change)
