# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Isosurfaces of real meshes: every point array at many values, from memory, from files and from
simplified ones, as vtkContourGrid has them; and section by section those of the mesh as it was."""

import glob
import os

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkContourGrid
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

import gatunContours as gc
import gatunMeshes as gm
from gatun.vtk import vtkGatunWriter

QUANTILES = (0, 0.02, 0.25, 0.5, 0.75, 0.98, 1)

files = sorted(glob.glob(os.path.join(gm.data_folder(), "*.vtu")))
assert files


def scalars_of(mesh, name, component):
    values = vtk_to_numpy(mesh.GetPointData().GetArray(name)).astype(np.float64)
    if values.ndim == 1:
        return values
    if component >= 0:
        return values[:, component]
    sums = np.zeros(len(values))
    for i in range(values.shape[1]):
        sums += values[:, i] * values[:, i]
    return np.sqrt(sums)


def area_of(output):
    a, b, d = np.moveaxis(gc.points_of(output)[gc.triangles_of(output)], 1, 0)
    return np.linalg.norm(np.cross(b - a, d - a), axis=1).sum() / 2


def exact_points(mesh, name, component, isovalues):
    """Of type double, those that vtkContourGrid may miss by a little."""
    if gm.coordinates(mesh).dtype != np.float64:
        return ()
    found = gm.coordinates(mesh)[np.isin(scalars_of(mesh, name, component), isovalues)]
    return found if len(found) < 300 else None


def check(source, mesh, name, component, isovalues):
    vertices = exact_points(mesh, name, component, isovalues)
    if vertices is None:
        return 0
    output = gc.contour_of(source, isovalues, name, ArrayComponent=component)
    if output.GetNumberOfCells():
        gc.assert_whole(output)
    return gc.assert_same(output, gc.reference(mesh, isovalues, name, component), vertices=vertices)


for file in files:
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(file)
    reader.Update()
    grid = reader.GetOutput()
    gm.add_array(grid.GetCellData(), np.arange(grid.GetNumberOfCells()), "cell")
    wave = np.sin(vtk_to_numpy(grid.GetPoints().GetData()) * 20 / grid.GetLength()).sum(1)
    gm.add_array(grid.GetPointData(), wave.astype(np.float32), "wave")
    if grid.GetCells().GetNumberOfConnectivityIds() != 4 * grid.GetNumberOfCells():
        # Other cells: the triangles of the tetrahedra that they are split to. VTK has others of
        # hexahedra, but not far away.
        path = gm.temporary("contour-real-cells.gtn")
        writer = vtkGatunWriter()
        writer.AddObserver("WarningEvent", lambda *_: None)
        writer.SetInputDataObject(grid)
        writer.SetFileName(path)
        writer.SetKeepOrderToAll()
        assert writer.Write() == 1
        contour = gc.contour_of(grid, 0.3, "wave")
        assert gc.assert_same(contour, gc.reference(gm.read(path, SplitCells=True), 0.3, "wave")) > 100
        theirs = vtkContourGrid()
        theirs.SetInputDataObject(grid)
        theirs.SetInputArrayToProcess(0, 0, 0, 0, "wave")
        theirs.SetValue(0, 0.3)
        theirs.Update()
        assert abs(area_of(contour) / area_of(theirs.GetOutput()) - 1) < 0.03
        print("%s: %d triangles" % (os.path.basename(file), contour.GetNumberOfCells()))
        continue
    arrays = [(a.GetName(), component) for a in gm.arrays_of(grid.GetPointData())
              for component in ((-1, 0) if a.GetNumberOfComponents() > 1 else (-1,))]
    sources = [(grid, grid)]
    for kind, options in gc.kinds_of_files(arrays[0][0]).items():
        path = gm.temporary("contour-real-%s.gtn" % kind)
        gm.write(grid, path, ChunkSize=10000, Hierarchy=True, Levels=3, **options)
        sources.append((gc.open_file(path), gm.read(path)))
        for ratio in (0.4, 0.9):
            sources.append((gc.open_file(path, SimplificationRatio=ratio),
                            gm.read(path, SimplificationRatio=ratio)))
    triangles = 0
    for number, (name, component) in enumerate(arrays):
        values = [float(v) for v in np.quantile(scalars_of(grid, name, component), QUANTILES)]
        between = [v + 1e-4 * (values[-1] - values[0]) for v in values[1:-1]]
        # In memory, and from files of both kinds, with one ratio after the other.
        for source, mesh in sources[:1] + sources[1 + number % 3::3]:
            for isovalues in (values[2:5], [between[2]], [values[0]], [values[-1]]):
                triangles += check(source, mesh, name, component, isovalues)
        if np.isin(scalars_of(grid, name, component), between).any():
            continue
        # The mesh as it was, but for diagonals.
        ours = gc.polygons(gc.contour_of(sources[1][0], between[2], name, ArrayComponent=component))
        theirs = gc.polygons(gc.reference(grid, between[2], name, component))
        assert ours[0] == theirs[0]
        np.testing.assert_array_equal(ours[1], theirs[1])
    print("%s: %d arrays, %d triangles" % (os.path.basename(file), len(arrays), triangles))
    assert triangles > 0
