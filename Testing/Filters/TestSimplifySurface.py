# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""vtkGatunSimplify of surfaces: what comes out of polygons, strips, lines and vertices; seams, pieces,
ghost cells, and errors."""

import math

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_UNSIGNED_CHAR, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkDataSetAttributes, vtkPolyData
from vtkmodules.vtkFiltersCore import (
    vtkAppendPolyData, vtkCleanPolyData, vtkFeatureEdges, vtkMassProperties, vtkStripper,
    vtkTriangleFilter)
from vtkmodules.vtkFiltersParallel import vtkExtractPolyDataPiece
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource

import gatunMeshes as gm
from gatun.vtk import vtkGatunSimplify


def make_simplifier(surface, **options):
    simplifier = vtkGatunSimplify()
    simplifier.SetInputDataObject(surface)
    gm.set_options(simplifier, **options)
    return simplifier


def simplify(surface, **options):
    simplifier = make_simplifier(surface, **options)
    simplifier.Update()
    assert simplifier.GetErrorCode() == 0
    return simplifier.GetOutput()


def update(filter, surface):
    filter.SetInputData(surface)
    filter.Update()
    return filter.GetOutput()


def count_border_edges(surface):
    edges = vtkFeatureEdges()
    edges.FeatureEdgesOff()
    edges.ManifoldEdgesOff()
    return update(edges, update(vtkCleanPolyData(), surface)).GetNumberOfCells()


def points_of(surface):
    return vtk_to_numpy(surface.GetPoints().GetData())


def triangles_of(surface):
    return vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def area_of(surface):
    p = points_of(surface).astype(float)[triangles_of(surface)]
    return np.linalg.norm(np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]), axis=1).sum() / 2


def make_plane(n):
    plane = vtkPlaneSource()
    plane.SetResolution(n, n)
    plane.Update()
    surface = vtkPolyData()
    surface.CopyStructure(plane.GetOutput())
    return surface


# Vertices and lines stay, with their points; polygons become triangles; data goes with all of them.
surface = make_plane(20)
verts, lines = vtkCellArray(), vtkCellArray()
verts.InsertNextCell(2, [25, 47])
verts.InsertNextCell(1, [110])
lines.InsertNextCell(4, [60, 61, 82, 103])
surface.SetVerts(verts)
surface.SetLines(lines)
gm.add_array(surface.GetPointData(), np.arange(441), "point id")
gm.add_array(surface.GetCellData(), np.arange(403), "cell id")
whole = points_of(surface).copy()
whole[:, 2] = 0.1 * np.sin(5 * whole[:, 0]) * np.cos(7 * whole[:, 1])
points_of(surface)[:] = whole
gm.add_array(surface.GetPointData(), whole[:, 2], "height")
surface.GetPointData().SetActiveScalars("height")
output = simplify(surface, SimplificationRatio=0.7)
ids = vtk_to_numpy(output.GetPointData().GetArray("point id"))
cells = vtk_to_numpy(output.GetCellData().GetArray("cell id"))
assert isinstance(output, vtkPolyData) and abs(output.GetNumberOfPoints() - 0.3 * 441) < 2
np.testing.assert_array_equal(points_of(output), whole[ids])
assert (np.diff(ids) > 0).all() and (np.diff(cells) >= 0).all()
assert list(cells[:3]) == [0, 1, 2] and len(cells) == output.GetNumberOfCells()
assert (output.GetNumberOfVerts(), output.GetNumberOfLines()) == (2, 1)
assert list(ids[vtk_to_numpy(output.GetVerts().GetConnectivityArray())]) == [25, 47, 110]
assert list(ids[vtk_to_numpy(output.GetLines().GetConnectivityArray())]) == [60, 61, 82, 103]
assert output.GetPolys().IsHomogeneous() == 3 and count_border_edges(output) > 0
# A triangle comes from a square that has one of its corners' points at least near: the first cell
# of each is the square itself if nothing is merged.
unmerged = simplify(surface, SimplificationRatio=0)
assert unmerged.GetNumberOfPolys() == 800
squares = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 4)
for triangle, cell in zip(triangles_of(unmerged),
                          vtk_to_numpy(unmerged.GetCellData().GetArray("cell id"))[3:]):
    assert set(triangle) <= set(squares[cell - 3])

# Polygons and strips of a plane have the same area as they had, as few points as can be, and their
# orientation.
octagon = vtkPolyData()
corners = vtkPoints()
polygon = vtkCellArray()
angles = [2 * math.pi * i / 8 for i in range(8)]
for a in angles:
    corners.InsertNextPoint(math.cos(a), math.sin(a), 0)
polygon.InsertNextCell(8, list(range(8)))
octagon.SetPoints(corners)
octagon.SetPolys(polygon)
strips = update(vtkStripper(), update(vtkTriangleFilter(), make_plane(9)))
assert strips.GetNumberOfStrips() > 0
for shape, area in ((make_plane(9), 1), (strips, 1), (octagon, 2 * math.sqrt(2))):
    for ratio in (0, 0.5, 0.8) if shape is not octagon else (0,):
        output = simplify(shape, SimplificationRatio=ratio)
        assert abs(area_of(output) - area) < 1e-5, (ratio, area_of(output))
        p = points_of(output).astype(float)[triangles_of(output)]
        assert (np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0])[:, 2] > 0).all()
assert simplify(octagon, SimplificationRatio=0).GetNumberOfPolys() == 6

# Seams of texture coordinates stay closed, whatever the target is.
u, v = np.meshgrid(np.arange(41), np.arange(25))
a, b = 2 * math.pi * (u.ravel() % 40) / 40, 2 * math.pi * (v.ravel() % 24) / 24
textured = vtkPolyData()
corners = vtkPoints()
for place in zip((2 + np.cos(b)) * np.cos(a), (2 + np.cos(b)) * np.sin(a), np.sin(b)):
    corners.InsertNextPoint(place)
triangles = vtkCellArray()
for at in (y * 41 + x for y in range(24) for x in range(40)):
    triangles.InsertNextCell(3, [at, at + 1, at + 42])
    triangles.InsertNextCell(3, [at, at + 42, at + 41])
textured.SetPoints(corners)
textured.SetPolys(triangles)
coordinates = numpy_to_vtk(np.stack([u.ravel() / 40, v.ravel() / 24], axis=1), deep=1)
textured.GetPointData().SetTCoords(coordinates)
assert count_border_edges(textured) == 0
simplifier = make_simplifier(textured)
for number in range(textured.GetNumberOfPoints(), 100, -7):
    simplifier.SetSimplificationNumberOfPoints(number)
    simplifier.Update()
    output = simplifier.GetOutput()
    assert number - 3 <= output.GetNumberOfPoints() <= number
    assert count_border_edges(output) == 0, number
    assert output.GetPointData().GetTCoords().GetNumberOfTuples() == output.GetNumberOfPoints()

# The order is found once: another target has no progress between.
events = []
simplifier = make_simplifier(surface, SimplificationRatio=0.5)
simplifier.AddObserver("ProgressEvent", lambda *_: events.append(simplifier.GetProgress()))
simplifier.Update()
assert any(0 < p < 0.95 for p in events), events
events.clear()
error = simplifier.GetOutputRMSError()
simplifier.SetSimplificationRatio(0.8)
simplifier.Update()
assert not any(0 < p < 0.95 for p in events), events
assert simplifier.GetOutputRMSError() > error > 0
simplifier.SetFeatureAngle(60)
simplifier.Update()
assert any(0 < p < 0.95 for p in events), events

# Pieces fit together.
append = vtkAppendPolyData()
for piece in range(4):
    source = vtkExtractPolyDataPiece()
    source.SetInputData(textured)
    simplifier = vtkGatunSimplify()
    simplifier.SetInputConnection(source.GetOutputPort())
    simplifier.SetSimplificationRatio(0.7)
    simplifier.UpdatePiece(piece, 4, 0)
    part = vtkPolyData()
    part.DeepCopy(simplifier.GetOutput())
    assert 0 < part.GetNumberOfPoints() < 200
    append.AddInputData(part)
append.Update()
assert count_border_edges(append.GetOutput()) == 0

# Ghost cells are left out, with their points.
surface = make_plane(8)
ghosts = np.zeros(64, dtype=np.uint8)
ghosts[:8] = vtkDataSetAttributes.DUPLICATECELL
array = numpy_to_vtk(ghosts, deep=1, array_type=VTK_UNSIGNED_CHAR)
array.SetName(vtkDataSetAttributes.GhostArrayName())
surface.GetCellData().AddArray(array)
output = simplify(surface, SimplificationRatio=0)
assert output.GetNumberOfPolys() == 112 and output.GetNumberOfPoints() == 72
assert abs(area_of(output) - 7 / 8) < 1e-6

# Volumes of closed surfaces hardly change; one filter takes meshes and surfaces in turn.
ball = vtkSphereSource()
ball.SetThetaResolution(60)
ball.SetPhiResolution(60)
ball.Update()
simplifier = make_simplifier(ball.GetOutput(), SimplificationRatio=0.8)
simplifier.Update()
mass = vtkMassProperties()
mass.SetInputData(simplifier.GetOutput())
full = vtkMassProperties()
full.SetInputData(ball.GetOutput())
assert abs(mass.GetVolume() / full.GetVolume() - 1) < 0.02
points, tets = gm.lattice(4, seed=3)
simplifier.SetInputDataObject(gm.make_grid(points, tets))
simplifier.Update()
assert simplifier.GetOutput().IsA("vtkUnstructuredGrid")
assert simplifier.GetOutput().GetNumberOfCells() > 0
simplifier.SetInputDataObject(ball.GetOutput())
simplifier.Update()
assert simplifier.GetOutput().IsA("vtkPolyData") and simplifier.GetOutput().GetNumberOfPolys() > 0

# Any cells: without points, with points twice, without an area or a place. No errors, and vertices
# and lines as they were.
random = np.random.default_rng(7)
for _ in range(60):
    number = random.integers(1, 40)
    places = random.integers(0, 4, (number, 3)).astype(float)
    places[random.random((number, 3)) < 0.03] = random.choice([math.nan, math.inf, 1e300])
    soup = vtkPolyData()
    corners = vtkPoints()
    corners.SetData(numpy_to_vtk(places, deep=1))
    soup.SetPoints(corners)
    for kind, most, count in (("Verts", 3, 3), ("Lines", 4, 3), ("Polys", 8, 60), ("Strips", 6, 4)):
        cells = vtkCellArray()
        for size in random.integers(0, most, random.integers(0, count)):
            cells.InsertNextCell(size, [int(i) for i in random.integers(0, number, size)])
        getattr(soup, "Set" + kind)(cells)
    for ratio in (0, 0.5, 1):
        output = simplify(soup, SimplificationRatio=ratio)
        assert output.GetNumberOfPoints() > 0 and output.GetNumberOfStrips() == 0
        assert output.GetNumberOfVerts() == soup.GetNumberOfVerts()
        assert output.GetNumberOfLines() == soup.GetNumberOfLines()

# Nothing in, nothing out; wrong input is an error.
assert simplify(vtkPolyData()).GetNumberOfPoints() == 0


def expect_error(surface, words, **options):
    simplifier = make_simplifier(surface, **options)
    if "Weight" in words or "weight" in words:
        simplifier.SetArrayWeight("missing", 1)
    errors = gm.Errors(simplifier)
    simplifier.Update()
    assert words in str(errors), (words, str(errors))
    assert simplifier.GetErrorCode() != 0 and simplifier.GetOutput().GetNumberOfPoints() == 0


expect_error(surface, "which has a weight")
expect_error(surface, "ratio", SimplificationRatio=math.nan)
expect_error(surface, "feature angle", FeatureAngle=math.nan)
for bad in ([0, 1, 999], [0, -2, 1]):
    wrong = make_plane(3)
    wrong.GetPolys().InsertNextCell(3, bad)
    expect_error(wrong, "does not exist")
assert "FeatureAngle: 30" in str(vtkGatunSimplify())
