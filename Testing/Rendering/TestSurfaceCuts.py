# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Surfaces of files that are finer where the view needs it: while somebody interacts, and with an error
in pixels in all images."""

import numpy as np

import gatunMeshes as gm
import gatunPolyData as pd
from gatunSurfaceScene import Scene, ball, covered

path = gm.temporary("cuts.gtn")
surface = ball(160)
points = surface.GetNumberOfPoints()
gm.write(surface, path, ChunkSize=2000, Hierarchy=True, Levels=3)


def make(**options):
    scene = Scene(pd.reader_of(path, LargeMesh=0))
    gm.set_options(scene.mapper, **options)
    scene.look(30, 20)
    scene.window.SetDesiredUpdateRate(0.001)
    return scene


def far(one, other):
    return np.abs(one - other).mean()


# An error of 0 is all of the surface.
scene = make(PixelError=0)
full = scene.render()
assert gm.statistic(scene.mapper, "DrawnPoints") == 0
assert np.array_equal(make(ViewDependent=False).render(), full)

# The larger the error, the fewer points, and the image is not far from that of all.
drawn = []
for error in 0.02, 0.2, 2, 20:
    scene = make(PixelError=error)
    picture = scene.render()
    drawn.append(gm.statistic(scene.mapper, "DrawnPoints"))
    assert covered(picture) > 0.95 * covered(full), error
    assert far(picture, full) < 3 + error, (error, far(picture, full))
assert drawn == sorted(drawn, reverse=True) and points > drawn[0] > 4 * drawn[-1] > 0, drawn

# Nearer than the uniform surface with as many points, from near, and with fewer triangles behind.
near = make()
near.look(30, 20, zoom=12)
whole = near.render()
near.mapper.GetDetailPolicy().SetPixelError(1)
cut = near.render()
count = gm.statistic(near.mapper, "DrawnPoints")
near.mapper.GetDetailPolicy().SetPixelError(0)
near.mapper.GetDetailPolicy().SetSimplificationRatio(1 - count / points)
uniform = near.render()
assert abs(gm.statistic(near.mapper, "DrawnPoints") - count) < 10
assert far(cut, whole) < 0.5 * far(uniform, whole), (far(cut, whole), far(uniform, whole))

# The way does not matter: somewhere and back is the same image, of which only chunks that change are
# made again.
scene = make(PixelError=0.5)
first = scene.render()
decoded = gm.statistic(scene.mapper, "DecodedChunks")
assert np.array_equal(scene.render(), first)
assert gm.statistic(scene.mapper, "DecodedChunks") == decoded
for azimuth, elevation, zoom in (60, 0, 1), (200, 40, 5), (30, 20, 9):
    scene.look(azimuth, elevation, zoom)
    scene.render()
scene.look(30, 20)
assert np.array_equal(scene.render(), first)
before = gm.statistic(scene.mapper, "DecodedChunks")
scene.camera.Azimuth(0.01)
scene.render()
assert gm.statistic(scene.mapper, "DecodedChunks") - before < gm.statistic(scene.mapper, "DrawnChunks")
other = make(PixelError=0.5)
assert np.array_equal(other.render(), first)

# Representations, culling, opacity, places of the actor, other colors; with and without them, the same
# image again.
for change, back in (
        (lambda p: p.SetRepresentationToWireframe(), lambda p: p.SetRepresentationToSurface()),
        (lambda p: p.BackfaceCullingOn(), lambda p: p.BackfaceCullingOff()),
        (lambda p: p.FrontfaceCullingOn(), lambda p: p.FrontfaceCullingOff()),
        (lambda p: p.SetOpacity(0.5), lambda p: p.SetOpacity(1))):
    change(scene.actor.GetProperty())
    scene.look(30, 20)
    assert covered(scene.render()) > 0.5 * covered(full)
    back(scene.actor.GetProperty())
    assert np.array_equal(scene.render(), first)
scene.actor.SetScale(100)
scene.look(30, 20)
assert far(scene.render(), full) < 4
scene.actor.SetScale(1)
scene.look(30, 20)
scene.mapper.ScalarVisibilityOff()
plain = scene.render()
assert covered(plain) > 0.95 * covered(full) and not np.array_equal(plain, first)
scene.mapper.ScalarVisibilityOn()
assert np.array_equal(scene.render(), first)

# Parallel projections; an eye on a point, and inside; nothing in the view.
scene.camera.ParallelProjectionOn()
scene.look(30, 20)
assert covered(scene.render()) > 0.9 * covered(full)
scene.camera.ParallelProjectionOff()
scene.camera.SetPosition(surface.GetPoint(1000))
scene.camera.SetFocalPoint(0, 0, 0)
scene.renderer.ResetCameraClippingRange()
assert covered(scene.render()) > 0.9
scene.camera.SetPosition(0.1, 0.2, 0.1)
scene.renderer.ResetCameraClippingRange()
assert covered(scene.render()) > 0.99
scene.camera.SetPosition(9, 0, 0)
scene.camera.SetFocalPoint(19, 0, 0)
scene.renderer.ResetCameraClippingRange()
assert covered(scene.render()) == 0

# An actor without extent.
scene.actor.SetScale(1e-200)
scene.render()
assert scene.mapper.GetErrorCode() == 0

# Without room for a base mesh, all of the surface.
scene = make(PixelError=2, MemoryBudget=1)
assert np.array_equal(scene.render(), full) and gm.statistic(scene.mapper, "DrawnPoints") == 0


# While somebody interacts: the surface follows the view, and ends up at the same one.
def move(one, frames):
    one.window.SetDesiredUpdateRate(10)
    for _ in range(frames):
        picture = one.render()
        one.mapper.WaitForPreparation()
    return picture


scene = make(JustInTime=True, TimeBudget=1e-6)
drawn = set()
for _ in range(40):
    settled = move(scene, 1)
    drawn.add(gm.statistic(scene.mapper, "DrawnPoints"))
# Fewer than the coarsest base mesh has.
assert 0 < min(drawn) < points / 9, drawn
assert covered(settled) > 0.9 * covered(full) and far(settled, full) < 15
decoded = gm.statistic(scene.mapper, "DecodedChunks")
move(scene, 5)
assert gm.statistic(scene.mapper, "DecodedChunks") - decoded < 100
# Camera changes before anything is ready, and while it is made.
for turn in range(60):
    scene.camera.Azimuth(7)
    scene.window.Render()
    if turn % 7 == 0:
        scene.mapper.GetDetailPolicy().SetViewDependent(turn % 2 == 0)
    assert scene.mapper.GetErrorCode() == 0
scene.mapper.GetDetailPolicy().SetViewDependent(True)
scene.look(30, 20)
assert far(move(scene, 20), settled) < 10
scene.window.SetDesiredUpdateRate(0.001)
scene.look(30, 20)
assert np.array_equal(scene.render(), full)

# Errors that are none.
policy = scene.mapper.GetDetailPolicy()
errors = gm.Errors(scene.mapper)
for name in "PixelError", "TimeBudget", "SimplificationRatio":
    gm.set_options(scene.mapper, **{name: float("nan")})
    scene.render()
    assert f"{name} is not a number" in str(errors) and scene.mapper.GetErrorCode() != 0, errors
    gm.set_options(scene.mapper, **{name: 0})
    assert np.array_equal(scene.render(), full) and scene.mapper.GetErrorCode() == 0
policy.SetPixelError(-1)
assert policy.GetPixelError() == 0
policy.SetPixelError(float("inf"))
scene.render()
assert 0 < gm.statistic(scene.mapper, "DrawnPoints") < points / 50
assert scene.mapper.GetErrorCode() == 0

# Points that are nowhere stay, and do not matter.
strange = ball(60)
for i in range(2000, 2040):
    strange.GetPoints().SetPoint(i, *3 * [float("nan")])
gm.write(strange, path, ChunkSize=2000, Hierarchy=True, Levels=1)
scene = Scene(pd.reader_of(path, LargeMesh=0))
scene.look(30, 20, bounds=surface.GetBounds())
scene.mapper.GetDetailPolicy().SetPixelError(1)
assert covered(scene.render()) > 0.9 * covered(full) and gm.statistic(scene.mapper, "DrawnPoints") > 0

# A damaged file: an error, once, and never more than that.
gm.write(surface, path, ChunkSize=2000, Hierarchy=True, Levels=3)
with open(path, "rb") as file:
    content = file.read()
failed = 0
for place in range(1, 20):
    data = bytearray(content)
    data[len(data) * place // 20] ^= 255
    with open(path, "wb") as file:
        file.write(data)
    scene = Scene(pd.reader_of(path, LargeMesh=0))
    errors = gm.Errors(scene.mapper)
    scene.look(30, 20, bounds=surface.GetBounds())
    scene.window.SetDesiredUpdateRate(0.001)
    scene.mapper.GetDetailPolicy().SetPixelError(0.3)
    scene.render()
    failed += scene.mapper.GetErrorCode() != 0
    scene.mapper.GetDetailPolicy().SetPixelError(0)
    scene.mapper.GetDetailPolicy().JustInTimeOn()
    scene.mapper.GetDetailPolicy().SetTimeBudget(1e-6)
    move(scene, 8)
    assert scene.mapper.GetErrorCode() == 0 or str(errors)
assert failed > 2, failed
with open(path, "wb") as file:
    file.write(content)

# Without a hierarchy, an error in pixels is an error.
gm.write(surface, path, ChunkSize=2000)
scene = Scene(pd.reader_of(path, LargeMesh=0))
scene.look(30, 20)
errors = gm.Errors(scene.mapper)
scene.mapper.GetDetailPolicy().SetPixelError(1)
scene.render()
assert "hierarchy" in str(errors) and scene.mapper.GetErrorCode() != 0, errors
scene.mapper.GetDetailPolicy().SetPixelError(0)
assert np.array_equal(scene.render(), full)
