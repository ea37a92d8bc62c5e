# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Meshes are simplified where the view needs little of them: by an error in pixels and within a
time; from a file with base meshes, from one without, and from memory."""

import numpy as np

import gatunMeshes as gm
import gatunVolumes as gv
from gatun.vtk import vtkGatunRayCaster, vtkGatunReader

AT_REST = 0.0001  # pictures a second
IN_MOTION = 20.0
N = 20
POINTS = (N + 1) ** 3

mesh = gv.wave(N)
files = [gm.temporary(f"detail{i}.gtn") for i in range(2)]
gm.write(mesh, files[0], ChunkSize=800, Hierarchy=True, Levels=5)
gm.write(mesh, files[1], ChunkSize=800, Hierarchy=True)


def make_reader(path):
    reader = vtkGatunReader()
    reader.SetFileName(path)
    return reader


def make(source, distance=2.0, **options):
    scene = gv.Scene(source, (200, 200), **options)
    scene.look(0.3, 0.4, distance=distance)
    return scene


def at(scene, rate):
    scene.window.SetDesiredUpdateRate(rate)
    return scene.render()


def rms(a, b):
    return np.sqrt(np.mean((np.asarray(a, float) - np.asarray(b, float)) ** 2))


for source in mesh, make_reader(files[0]), make_reader(files[1]):
    full = at(make(source), AT_REST)

    # The error of the picture follows the error in pixels, and so does the number of points.
    before, last = POINTS, 0.0
    for pixels in 0.2, 2, 20:
        scene = make(source, PixelError=pixels)
        picture = at(scene, AT_REST)
        points = gm.statistic(scene.mapper, "DrawnPoints")
        error = rms(picture, full)
        assert 0 < points < before and error > last, (pixels, points, error)
        before, last = points, error
        # Nothing is made anew for the same picture, whatever was drawn between.
        scene.look(0.9, 0.1, distance=1.5)
        at(scene, AT_REST)
        scene.look(0.3, 0.4, distance=2.0)
        gv.require_same(at(scene, AT_REST), picture)
        assert gm.statistic(scene.mapper, "DrawnPoints") == points
    assert last > 0.01

    # From farther away, fewer points have the same error; from near by more.
    counts = []
    for distance in 1.0, 2.0, 8.0, 30.0:
        scene = make(source, distance, PixelError=2)
        at(scene, AT_REST)
        counts.append(gm.statistic(scene.mapper, "DrawnPoints"))
    assert counts[0] > counts[1] > counts[2] > counts[3], counts

    # In motion the mesh follows the view; at rest it is whole.
    scene = make(source, JustInTime=True, TimeBudget=1e-6)
    at(scene, AT_REST)
    assert scene.mapper.PrepareSimplification()
    for turn in range(6):
        scene.look(0.3 + 0.02 * turn, 0.4, distance=2.0)
        at(scene, IN_MOTION)
        assert scene.mapper.PrepareSimplification()
    followed = gm.statistic(scene.mapper, "DrawnPoints")
    assert 300 <= followed < POINTS / 2, followed
    scene.look(0.3, 0.4, distance=2.0)
    assert gv.difference(at(scene, AT_REST), full) <= 2 / 255
    scene.mapper.GetDetailPolicy().SetViewDependent(False)
    for _ in range(3):
        at(scene, IN_MOTION)
        assert scene.mapper.PrepareSimplification()
    assert gm.statistic(scene.mapper, "DrawnPoints") == 500
    # In motion, too, there is an error that need not be less.
    scene.mapper.GetDetailPolicy().SetViewDependent(True)
    scene.mapper.GetDetailPolicy().SetTimeBudget(100)
    scene.mapper.GetDetailPolicy().SetPixelError(1e6)
    for _ in range(3):
        at(scene, IN_MOTION)
        assert scene.mapper.PrepareSimplification()
    assert gm.statistic(scene.mapper, "DrawnPoints") < 500

    # By the ray caster.
    camera = dict(Camera=scene.camera, Property=scene.volume.GetProperty(), Size=(90, 90))
    whole = gv.draw(source, **camera)[0]
    last = 0.0
    for pixels in 0.2, 2, 20:
        picture = gv.draw(source, PixelError=pixels, **camera)[0]
        error = rms(picture, whole)
        assert error > last, (pixels, error)
        last = error
    some = gv.draw(source, JustInTime=True, TimeBudget=1e-5, **camera)[0]
    alike = gv.draw(
        source, JustInTime=True, TimeBudget=1e-5, ViewDependent=False, **camera)[0]
    assert rms(some, whole) > 0 and rms(some, alike) > 0
    assert rms(gv.draw(source, TimeBudget=1e-5, **camera)[0], whole) == 0

# Numbers out of range and numbers that are none.
scene = make(make_reader(files[0]))
full = at(scene, AT_REST)
scene.mapper.GetDetailPolicy().SetPixelError(-1)
assert scene.mapper.GetDetailPolicy().GetPixelError() == 0
nan = float("nan")
other = make(make_reader(files[0]), PixelError=nan)
messages = gm.Errors(other.mapper)
at(other, AT_REST)
assert "PixelError" in str(messages), str(messages)
caster = vtkGatunRayCaster()
reader = make_reader(files[0])
caster.SetInputConnection(reader.GetOutputPort())
caster.SetCamera(scene.camera)
caster.SetProperty(scene.volume.GetProperty())
caster.GetDetailPolicy().SetPixelError(nan)
messages = gm.Errors(caster)
caster.Update()
assert "PixelError" in str(messages), str(messages)

# Cameras where perspective ends: within the mesh, on a point, and without perspective.
for place in ([0.51] * 3, [0.5] * 3, [0, 0, 0]):
    scene = make(make_reader(files[0]), PixelError=2)
    scene.camera.SetPosition(place)
    scene.camera.SetFocalPoint(1, 0.5, 0.3)
    scene.camera.SetClippingRange(0.001, 4)
    at(scene, AT_REST)
    assert scene.mapper.GetErrorCode() == 0 and gm.statistic(scene.mapper, "DrawnPoints") > 0
scene = make(make_reader(files[0]), PixelError=2)
scene.camera.ParallelProjectionOn()
at(scene, AT_REST)
assert scene.mapper.GetErrorCode() == 0 and 0 < gm.statistic(scene.mapper, "DrawnPoints") < POINTS
