# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""vtkGatunRayCaster: the picture is the same from memory and from the file, whatever the chunks, the
threads and the order of the cells; the file is not read where nothing is seen; what cannot be drawn
is told."""

import numpy as np
from vtkmodules.vtkCommonCore import vtkSMPTools
from vtkmodules.vtkCommonDataModel import (
    VTK_HEXAHEDRON, vtkPlane, vtkPlaneCollection, vtkUnstructuredGrid)
from vtkmodules.vtkCommonMath import vtkMatrix4x4

import gatunVolumes as gv


def check_same(a, b, bound=1 / 255):
    assert gv.difference(a[0], b[0]) <= bound, gv.difference(a[0], b[0])


grid = gv.box()
expected = gv.draw(grid)
colors, depths = expected
assert 0.2 < (colors[..., 3] > 0.01).mean() < 0.9
assert (colors[..., :3] <= colors[..., 3:] + 1e-6).all(), "not premultiplied"

# Depth: between the nearest and the farthest point of the box from the eye.
seen = np.isfinite(depths)
assert (seen == (colors[..., 3] > 0)).all()
corners = np.array([[x, y, z] for x in (0, 10) for y in (0, 10) for z in (0, 10)])
distances = np.linalg.norm(corners - np.array(gv.box_camera().GetPosition()), axis=1)
assert depths[seen].min() > distances.min() - 10 and depths[seen].max() < distances.max()

# The same whatever the order, the chunks and the threads.
check_same(expected, gv.draw(gv.box(order=np.random.default_rng(1))))
check_same(expected, gv.draw(grid, MemoryBudget=0))
for threads in (8, 3, 2, 1):  # TBB does not take more than it had at first
    vtkSMPTools.Initialize(threads)
    check_same(expected, gv.draw(grid))
vtkSMPTools.Initialize(0)
for chunk in (1000, 65536):
    reader = gv.write(grid, "cast%d.gtn" % chunk, chunk)
    for budget in (0, 512):
        reader.SetMemoryBudget(budget)
        caster = gv.make_caster(reader)
        check_same(expected, gv.picture_of(caster))
        caster.GetCamera().Azimuth(40)
        turned = gv.draw(grid, Camera=gv.box_camera(azimuth=30))  # a camera of its own
        check_same(turned, expected, 0)
        check_same(gv.picture_of(caster), gv.draw(grid, Camera=caster.GetCamera()))
    # The reader was never asked for its mesh.
    assert reader.GetOutput().GetNumberOfCells() == 0

# From the file only what is seen.
fine = gv.box(20)
caster = gv.make_caster(gv.write(fine, "fine.gtn", 500))
caster.GetCamera().Zoom(4)
caster.Update()
assert gv.gm.statistic(caster, "SkippedChunks") > 0
whole = gv.make_caster(fine, Camera=caster.GetCamera())
check_same(gv.picture_of(caster), gv.picture_of(whole))

# Arrays, components, modes.
for options in ({"ArrayName": "vector", "ArrayComponent": -1}, {"ArrayName": "cell"},
                {"ArrayName": "vector", "ArrayComponent": 2}, {"BlendMode": 1},
                {"BlendMode": 101}):
    there = gv.draw(grid, **options)
    assert (there[0][..., 3] > 0.01).mean() > 0.1, options
    check_same(there, gv.draw(reader, **options))
length = gv.draw(grid, ArrayName="vector", ArrayComponent=-1)
component = gv.draw(grid, ArrayName="vector", ArrayComponent=0)
assert np.abs(length[0] - component[0]).max() > 0.02  # sqrt(3) times as large

# Where the volume is put: a turn of it is a turn of the camera the other way, and twice its size is
# half of the distances.
matrix = vtkMatrix4x4()
for i in range(3):
    matrix.SetElement(i, i, 2)
half = gv.box_camera()
half.SetFocalPoint(10, 10, 10)
half.SetPosition(*(2 * np.array(gv.box_camera().GetPosition())))
check_same(
    expected, gv.draw(grid, VolumeMatrix=matrix, Camera=half, Property=gv.box_property(unit=2)))

# A clipping plane cuts the box in two parts, which together let through what the box does.
parts = []
for sign in (1, -1):
    plane = vtkPlane()
    plane.SetOrigin(5, 5, 5)
    plane.SetNormal(0.3 * sign, 0.5 * sign, sign)
    planes = vtkPlaneCollection()
    planes.AddItem(plane)
    parts.append(1 - gv.draw(grid, ClippingPlanes=planes)[0][..., 3])
np.testing.assert_allclose(parts[0] * parts[1], 1 - colors[..., 3], atol=1e-5)

# Hexahedra are split.
hexahedra = vtkUnstructuredGrid()
hexahedra.SetPoints(grid.GetPoints())
hexahedra.GetPointData().ShallowCopy(grid.GetPointData())
row = 11
for z in range(10):
    for y in range(10):
        for x in range(10):
            def corner(i, j, k):
                return ((x + i) * row + y + j) * row + z + k
            hexahedra.InsertNextCell(VTK_HEXAHEDRON, 8, [
                corner(i, j, k) for k in (0, 1) for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))])
split = gv.draw(hexahedra)
assert np.abs(split[0] - colors).mean() < 0.01

print("all good")
