# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Strange meshes and transfer functions look as they should in vtkGatunRayCaster, vtkGatunVolumeMapper
and gtn render: what has no volume or no place is not there, and what is there twice is seen twice."""

import json
import os
import subprocess

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.util.vtkConstants import (
    VTK_HEXAHEDRON, VTK_PYRAMID, VTK_TETRA, VTK_TRIANGLE, VTK_VOXEL, VTK_WEDGE)
from vtkmodules.vtkCommonDataModel import vtkDataSetAttributes as Attributes, vtkPiecewiseFunction
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkVolumeProperty

import gatunVolumes as gv

SIZE = (64, 48)
EVEN = ((-5, 0.3), (5, 0.3))  # the same opacity everywhere
WHITE = ((-5, (1, 1, 1)), (5, (1, 1, 1)))
OPTIONS = {"OpacityLimit": 0}

camera = gv.Scene(gv.constant(), SIZE)  # VTK keeps the camera as long as its scene
EYE = camera.camera


def make(points, tets, values=None):
    grid = gv.gm.make_grid(points, tets)
    if values is None:
        values = 0.2 + 0.6 * np.sin(3 * np.nan_to_num(points[:, 0], posinf=0, neginf=0)) ** 2
    gv.gm.add_array(grid.GetPointData(), values.astype(np.float32), "values")
    grid.GetPointData().SetActiveScalars("values")
    return grid


def cast(grid, prop):
    """By vtkGatunRayCaster, over the background."""
    return gv.draw(grid, Camera=EYE, Property=prop, Size=SIZE, **OPTIONS)[0]


def in_window(grid, prop):
    scene = gv.Scene(grid, SIZE, prop, **OPTIONS)
    errors = gv.gm.Errors(scene.mapper)
    scene.renderer.SetActiveCamera(EYE)
    picture = scene.render()[..., :3]
    assert not errors.messages, str(errors)
    return picture


def check(name, grid, expected, prop=None):
    """Expected: red, green, blue and opacity."""
    prop = prop or gv.make_property()
    assert gv.difference(cast(grid, prop), expected) <= 1 / 255, name
    assert gv.difference(in_window(grid, prop), gv.over(expected)) <= 2 / 255 + 1e-9, name
    if grid.GetNumberOfCells() and np.isfinite(gv.gm.coordinates(grid)).all():
        reader = gv.write(grid, "strange.gtn", 100)
        assert gv.difference(cast(reader, prop), expected) <= 1 / 255, name


points, tets = gv.gm.lattice(4)
points = points.astype(np.float64)
plain = make(points, tets)
whole = cast(plain, gv.make_property())
assert 0.2 < (whole[..., 3] > 0.1).mean() < 0.9

# --------------------------------------------------------------------------------------------------
# Tetrahedra

# One: as the part of it that a mesh of four has.
corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [0.2, 0.2, 0.2]])
one = cast(make(corners[:4], [[0, 1, 2, 3]]), gv.make_property(EVEN))
assert 0.02 < (one[..., 3] > 0.05).mean() < 0.5
four = [[4, 1, 2, 3], [0, 4, 2, 3], [0, 1, 4, 3], [0, 1, 2, 4]]
even = gv.make_property(EVEN, colors=WHITE)
for grid in (make(corners[:4], [[0, 1, 2, 3]]), make(corners[:4], [[1, 0, 2, 3]]), make(corners, four)):
    check("one", grid, cast(make(corners, four), even), even)

# Without a volume: four points in a plane, a point twice, two points in one place, all the same.
more = np.concatenate([points, points[tets[0, :1]]])
flat = np.array([
    [tets[0, 0], tets[0, 1], tets[0, 2], tets[0, 2]], [tets[5, 0]] * 4,
    [len(points), tets[0, 0], tets[0, 1], tets[0, 2]]])
plane = np.argwhere(points[:, 2] == 0)[:, 0]
flat = np.concatenate([flat, plane[: len(plane) // 4 * 4].reshape(-1, 4)])
check("flat", make(more, np.concatenate([flat, tets, flat])), whole)
assert not cast(make(more, flat), gv.make_property()).any()

# Twice or three times, and a soup in which more than two share a face: light is let through by all.
light = 1 - cast(plain, even)[..., 3:]
for times in (2, 3):
    check("twice", make(points, np.concatenate([tets] * times)), 1 - light**times * np.ones(4), even)
rng = np.random.default_rng(4)
soup = tets[rng.permutation(len(tets))[:60]].copy()
soup[:, 3] = rng.integers(0, len(points), 60)
soup = soup[[len(set(tet)) == 4 for tet in soup]]
alone = 1 - cast(make(points, soup), even)[..., 3:]
assert alone.min() < 0.9
check("soup", make(points, np.concatenate([soup, tets])), 1 - light * alone * np.ones(4), even)

# Points that have no place take their tetrahedra with them.
for strange in (np.nan, np.inf, -np.inf):
    bad = rng.permutation(len(points))[:5]
    moved = points.copy()
    moved[bad, rng.integers(0, 3, 5)] = strange
    rest = tets[~np.isin(tets, bad).any(1)]
    expected = cast(make(points, rest), even)
    check("no place", make(moved, tets), expected, even)
    values = np.full(len(points), 0.5)
    values[bad] = strange
    check("no value", make(points, tets, values), expected, even)
assert not cast(make(np.full_like(points, np.nan), tets), even).any()

# Those that are hidden, or belong to another piece.
for flag in (Attributes.DUPLICATECELL, Attributes.HIDDENCELL, Attributes.REFINEDCELL):
    ghosts = np.where(np.arange(len(tets)) % 3 == 0, flag, 0).astype(np.uint8)
    expected = cast(make(points, tets[ghosts == 0]), even)
    for everything in (False, True):
        grid = make(points, tets)
        gv.gm.add_array(
            grid.GetCellData(), np.full_like(ghosts, flag) if everything else ghosts,
            Attributes.GhostArrayName())
        found = cast(grid, even)
        assert gv.difference(found, 0 * expected if everything else expected) <= 1 / 255
        found = in_window(grid, even)
        expected_there = gv.over(0 * expected if everything else expected)
        assert gv.difference(found, expected_there) <= 2 / 255 + 1e-9
ghosts = np.zeros(len(points), np.uint8)
ghosts[::7] = Attributes.HIDDENPOINT
grid = make(points, tets)
gv.gm.add_array(grid.GetPointData(), ghosts, Attributes.GhostArrayName())
expected = cast(make(points, tets[(ghosts[tets] == 0).all(1)]), even)
assert gv.difference(cast(grid, even), expected) <= 1 / 255

# Cells of other types that are solid: a wedge, a pyramid, a voxel and a hexahedron fill two cubes.
box = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 0.5, 1)], float)
mixed = make(box, [])
mixed.Allocate(4)
mixed.InsertNextCell(VTK_VOXEL, 8, [0, 1, 3, 4, 6, 7, 9, 10])
mixed.InsertNextCell(VTK_WEDGE, 6, [1, 2, 4, 7, 8, 10])
mixed.InsertNextCell(VTK_TETRA, 4, [2, 5, 4, 11])
mixed.InsertNextCell(VTK_PYRAMID, 5, [2, 4, 10, 8, 11])
bricks = make(box, [])
bricks.Allocate(2)
for at in (0, 1):
    bricks.InsertNextCell(
        VTK_HEXAHEDRON, 8, [at + i for i in (0, 1, 4, 3, 6, 7, 10, 9)])
cube = cast(gv.constant(), even)
for grid in (mixed, bricks):
    assert gv.difference(cast(grid, even), cube) <= 1 / 255
    assert gv.difference(in_window(grid, even), gv.over(cube)) <= 2 / 255 + 1e-9

# --------------------------------------------------------------------------------------------------
# Transfer functions


def with_functions(opacity, colors=WHITE, clamp=True):
    prop = vtkVolumeProperty()
    function = vtkPiecewiseFunction()
    function.SetAllowDuplicateScalars(True)
    function.SetClamping(clamp)
    for value, amount in opacity:
        function.AddPoint(value, amount)
    color_function = vtkColorTransferFunction()
    color_function.SetAllowDuplicateScalars(True)
    color_function.SetClamping(clamp)
    for value, color in colors:
        color_function.AddRGBPoint(value, *color)
    prop.SetScalarOpacity(function)
    prop.SetColor(color_function)
    prop.SetScalarOpacityUnitDistance(0.2)
    return prop


def same(one, other):
    expected = cast(plain, other)
    check("function", plain, expected, one)
    return expected


# Nodes that are all beyond the values, on either side: what is at the nearest counts, or nothing.
for side in (-1, 1):
    nodes = sorted([(side * 9, 0.8), (side * 8, 0.3)])
    assert same(with_functions(nodes), with_functions(EVEN))[..., 3].max() > 0.3
    assert not same(with_functions(nodes, clamp=False), with_functions(((-9, 0), (9, 0)))).any()
# Without nodes there is nothing; with one, its opacity is everywhere.
assert not same(with_functions(()), with_functions(((-9, 0), (9, 0)))).any()
same(with_functions(((0.5, 0.3),)), with_functions(EVEN))
# Several nodes in one place: a step.
step = ((0, 0.1), (0.5, 0.1), (0.5, 0.6), (1, 0.6))
steep = ((0, 0.1), (0.4999999, 0.1), (0.5000001, 0.6), (1, 0.6))
found = same(with_functions(step), with_functions(steep))
assert gv.difference(found, cast(plain, with_functions(((0, 0.1), (1, 0.6))))) > 0.02
same(with_functions(((0.5, 0.3), (0.5, 0.3), (0.5, 0.3))), with_functions(EVEN))
# Opacities and colors that are none.
same(with_functions(((0, 7), (1, 7))), with_functions(((0, 1), (1, 1))))
assert not same(with_functions(((0, -7), (1, -7))), with_functions(((0, 0), (1, 0)))).any()

# --------------------------------------------------------------------------------------------------
# The same by gtn render

LOOK = gv.gm.temporary("strange-camera.json")
with open(LOOK, "w") as file:
    json.dump(
        {"position": EYE.GetPosition(), "focalPoint": EYE.GetFocalPoint(),
         "viewUp": EYE.GetViewUp()}, file)


def render(grid, code=0):
    """The picture, as bytes; None and a message where there is none."""
    mesh, picture = gv.gm.temporary("strange.vtu"), gv.gm.temporary("strange.png")
    writer = vtkXMLUnstructuredGridWriter()
    writer.SetInputData(grid)
    writer.SetFileName(mesh)
    writer.Write()
    run = subprocess.run(
        [os.environ["GATUN_TEST_GTN"], "render", "-q", "--size", "%dx%d" % SIZE, "--array", "values",
         "--range", "0,1", "--unit-distance", "0.2", "--camera", LOOK, mesh, picture],
        stderr=subprocess.PIPE, check=False, timeout=60, universal_newlines=True)
    assert run.returncode == code, run
    assert bool(run.stderr) == bool(code) and run.stderr.startswith("gtn: " if code else ""), run
    if code:
        assert not os.path.exists(picture) and mesh in run.stderr, run
        return None
    reader = vtkPNGReader()
    reader.SetFileName(picture)
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(int)


expected = render(plain)
assert expected.max() > 100
for grid in (make(more, np.concatenate([flat, tets, flat])), make(points, tets[::-1])):
    assert np.abs(render(grid) - expected).max() <= 1
assert render(make(corners[:4], [[0, 1, 2, 3]]))[:, 3].max() > 20
assert render(make(points, np.concatenate([tets, tets]))).max() > 100
assert render(mixed).max() > 100
bad = points.copy()
bad[3, 1] = np.nan
rest = render(make(points, tets[~(tets == 3).any(1)]))
assert np.abs(render(make(bad, tets)) - rest).max() <= 1
triangle = make(points, [])
triangle.Allocate(1)
triangle.InsertNextCell(VTK_TRIANGLE, 3, [0, 1, 2])
render(triangle, code=1)
