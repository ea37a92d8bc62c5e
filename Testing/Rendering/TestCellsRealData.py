# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Real grids of hexahedra, wedges, pyramids, polyhedra and quadratic cells: their tetrahedra fit, have the
volume that VTK measures, and look the same from memory and from a file."""

import os
import sys

import numpy as np
from vtkmodules.util import vtkConstants as c
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import VTK_POLYHEDRON, vtkUnstructuredGrid
from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter
from vtkmodules.vtkIOLegacy import vtkUnstructuredGridReader
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
from vtkmodules.vtkRenderingCore import vtkCamera

import gatunMeshes as gm
import gatunVolumes as gv
from gatun.vtk import vtkGatunWriter

FOLDER = os.environ.get("GATUN_CELLS_DIR")
if not FOLDER:
    print("GATUN_CELLS_DIR is not set")
    sys.exit(gm.SKIPPED)

# Of each file: faces that belong to one cell only inside the grid, as hanging nodes do, as a part of all.
FILES = ("bunny_hex.vtu", "comb_hex.vtu", "bluntfin_hex.vtu", "ac_room.vtu", "brick_prism.vtu",
         "brick_pyra.vtu", "notch_disp.vtu", "cylinder_quadratic.vtk", "polyhedron2.vtu")


def load(name):
    reader = vtkXMLUnstructuredGridReader() if name.endswith(".vtu") else vtkUnstructuredGridReader()
    reader.SetFileName(os.path.join(FOLDER, name))
    reader.Update()
    grid = vtkUnstructuredGrid()
    grid.CopyStructure(reader.GetOutput())
    points = gm.coordinates(grid).astype(float)
    span = np.ptp(points, 0).max()
    x, y, z = ((points - points.min(0)) / span).T
    gm.add_array(grid.GetPointData(), np.sin(9 * x + 4 * y) * np.cos(7 * z - y), "wave")
    grid.GetPointData().SetActiveScalars("wave")
    return grid


def write(grid, name):
    writer = vtkGatunWriter()
    writer.AddObserver("WarningEvent", lambda *_: None)
    writer.SetInputDataObject(grid)
    writer.SetFileName(gm.temporary(name))
    writer.SetKeepOrderToAll()
    assert writer.Write() == 1
    return writer.GetFileName()


def volumes_of(places):
    a, b, d, e = np.moveaxis(places, 1, 0)
    return np.einsum("ij,ij->i", np.cross(b - a, d - a), e - a) / 6


def camera_of(points):
    low, high = points.min(0), points.max(0)
    middle = (low + high) / 2
    camera = vtkCamera()
    camera.SetFocalPoint(*middle)
    camera.SetPosition(*(middle + np.linalg.norm(high - low) * np.array([0.9, 1.1, 1.3])))
    camera.SetViewUp(0, 0, 1)
    return camera


def faces_of_grid(grid):
    """The faces of all cells as sorted corners, filled up, and how many cells have each."""
    faces = []
    for i in range(grid.GetNumberOfCells()):
        cell = grid.GetCell(i)
        for f in range(cell.GetNumberOfFaces()):
            face = cell.GetFace(f)
            faces.append(tuple(sorted(face.GetPointId(k) for k in range(face.GetNumberOfPoints()))))
    seen = {}
    for face in faces:
        seen[face] = seen.get(face, 0) + 1
    return seen


for name in FILES:
    grid = load(name)
    path = write(grid, "real-cells.gtn")
    tets = gm.read(path, SplitCells=True)
    ids = gm.connectivity(tets)
    points = gm.coordinates(tets).astype(float)
    volumes = volumes_of(points[ids])

    # Each triangle is in two tetrahedra if the face that it is of is in two cells, else in one.
    triangles = np.sort(ids[:, [[1, 2, 3], [0, 2, 3], [0, 1, 3], [0, 1, 2]]].reshape(-1, 3), 1)
    _, counts = np.unique(triangles, axis=0, return_counts=True)
    types = set(np.unique(gm.cell_types(grid)).tolist())
    if not types & {c.VTK_QUADRATIC_TETRA, c.VTK_QUADRATIC_HEXAHEDRON, c.VTK_QUADRATIC_WEDGE}:
        faces = faces_of_grid(grid)
        assert max(faces.values()) == 2, name
        once = sum(len(face) - 2 for face, number in faces.items() if number == 1)
        # A polyhedron may have the same triangle in two of its faces, where a face of a neighbor is
        # divided.
        slack = 0.001 * len(counts) if VTK_POLYHEDRON in types else 0
        assert counts.max() == 2 or VTK_POLYHEDRON in types, name
        assert abs((counts == 1).sum() - once) <= slack, (name, (counts == 1).sum(), once)

        size = vtkCellSizeFilter()
        size.SetInputDataObject(grid)
        size.Update()
        theirs = np.abs(vtk_to_numpy(size.GetOutput().GetCellData().GetArray("Volume"))).sum()
        assert abs(abs(volumes.sum()) / theirs - 1) < 0.01, (name, volumes.sum(), theirs)

    options = {"Camera": camera_of(points), "Property": gv.make_property(
        ((-1, 0), (0, 0.05), (1, 0.3)), np.ptp(points, 0).max() / 10,
        ((-1, (0.1, 0.2, 0.9)), (0, (0.3, 0.9, 0.3)), (1, (0.9, 0.3, 0.1))))}
    memory = gv.draw(grid, **options)[0]
    assert (memory[..., 3] > 0.01).mean() > 0.02, name
    from_file = gv.draw(tets, **options)[0]
    assert gv.difference(memory, from_file) <= 1 / 255, (name, gv.difference(memory, from_file))
    print(name, grid.GetNumberOfCells(), "cells,", len(ids), "tetrahedra,",
          (volumes * np.sign(volumes.sum()) <= 0).mean(), "flat or turned over")
