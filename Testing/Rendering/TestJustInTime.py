# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""While somebody interacts, the mesh is as simple as the time asks for; at rest all of it is drawn,
to the last bit, and at any time a part of its points if only that is wanted."""

import math

import gatunMeshes as gm
import gatunVolumes as gv
from gatun.vtk import vtkGatunSimplify

AT_REST = 0.0001  # pictures a second
IN_MOTION = 20.0
POINTS = 17 ** 3


def make(source, **options):
    scene = gv.Scene(source, (200, 200), **options)
    scene.look(0.3, 0.4, distance=2)
    return scene


def at(scene, rate):
    scene.window.SetDesiredUpdateRate(rate)
    picture = scene.render()
    return gm.statistic(scene.mapper, "DrawnPoints"), picture


mesh = gv.wave(16)
assert mesh.GetNumberOfPoints() == POINTS
plain = make(mesh)
_, full = at(plain, AT_REST)
assert gm.statistic(plain.mapper, "DrawnPoints") == 0
assert not plain.mapper.PrepareSimplification()  # nobody wants to simplify anything

# --------------------------------------------------------------------------------------------------
# In motion and at rest

scene = make(mesh, JustInTime=True, ViewDependent=False)
mapper = scene.mapper
points, picture = at(scene, AT_REST)
assert points in (0, POINTS) and gv.difference(picture, full) == 0
assert mapper.PrepareSimplification()
points, picture = at(scene, AT_REST)
assert points == POINTS and gv.difference(picture, full) == 0

# No time: as simple, and as coarse, as can be.
mapper.GetDetailPolicy().SetTimeBudget(1e-6)
for _ in range(4):
    points, picture = at(scene, IN_MOTION)
    assert mapper.PrepareSimplification()  # waits for the background, too
assert points == 500, points
assert mapper.GetImageSampleDistance() == 10
assert gv.difference(picture, full) > 0.02
points, picture = at(scene, AT_REST)
assert points == POINTS and gv.difference(picture, full) == 0
assert mapper.GetImageSampleDistance() == 1

# All rays where they are not to be adjusted: the mesh alone is simplified.
mapper.AutoAdjustSampleDistancesOff()
points, picture = at(scene, IN_MOTION)
assert points == 500 and mapper.GetImageSampleDistance() == 1
assert 0.01 < gv.difference(picture, full) < 0.5
mapper.AutoAdjustSampleDistancesOn()

# Time enough: all of it. What is allocated counts where there is no budget.
mapper.GetDetailPolicy().SetTimeBudget(1000)
for _ in range(4):
    points, picture = at(scene, IN_MOTION)
assert points == POINTS and gv.difference(picture, full) == 0
mapper.GetDetailPolicy().SetTimeBudget(0)
for _ in range(4):
    points, _ = at(scene, 1e6)
    mapper.PrepareSimplification()
assert points == 500, points
for _ in range(4):
    points, picture = at(scene, 1 / 9)
    mapper.PrepareSimplification()
assert points == POINTS and gv.difference(picture, full) == 0

# Off: rays only, as ever.
mapper.GetDetailPolicy().JustInTimeOff()
points, _ = at(scene, 1e6)
assert points == 0

# --------------------------------------------------------------------------------------------------
# A part of the points

fixed = make(mesh, SimplificationRatio=0.75)
progress = []
fixed.mapper.AddObserver("ProgressEvent", lambda mapper, _: progress.append(mapper.GetProgress()))
points, picture = at(fixed, AT_REST)
assert points == POINTS - math.floor(0.75 * POINTS), points
assert progress[-1] == 1
simplify = vtkGatunSimplify()
simplify.SetInputDataObject(mesh)
simplify.SetSimplificationRatio(0.75)
_, expected = at(make(simplify), AT_REST)
# Equal costs may be in another order there.
assert abs(picture - expected).mean() < 0.2 * abs(picture - full).mean()
fixed.mapper.GetDetailPolicy().SetSimplificationRatio(1)
points, _ = at(fixed, AT_REST)
assert 0 < points < 100
fixed.mapper.GetDetailPolicy().SetSimplificationRatio(1e-9)
points, picture = at(fixed, AT_REST)
assert points == POINTS and gv.difference(picture, full) == 0
# Another ratio: only what it changes is drawn, and it looks as if all were.
drawn = []
for ratio in 0.3, 0.3002, 0.3004, 0.31, 0.3, 0.3:
    fixed.mapper.GetDetailPolicy().SetSimplificationRatio(ratio)
    _, picture = at(fixed, AT_REST)
    drawn.append(gm.statistic(fixed.mapper, "RedrawnFraction"))
    _, expected = at(make(mesh, SimplificationRatio=ratio), AT_REST)
    assert gv.difference(picture, expected) == 0
assert 0 < drawn[1] < 0.8 and 0 < drawn[2] < 0.8, drawn
assert drawn[-1] == 0, drawn
# Whatever else changes, all of it is drawn.
fixed.volume.GetProperty().SetScalarOpacityUnitDistance(0.3)
at(fixed, AT_REST)
assert gm.statistic(fixed.mapper, "RedrawnFraction") == 1
fixed.volume.GetProperty().SetScalarOpacityUnitDistance(0.2)
fixed.camera.Azimuth(1)
at(fixed, AT_REST)
assert gm.statistic(fixed.mapper, "RedrawnFraction") == 1
fixed.camera.Azimuth(-1)

# In motion no more than that.
fixed.mapper.GetDetailPolicy().SetSimplificationRatio(0.5)
fixed.mapper.GetDetailPolicy().JustInTimeOn()
fixed.mapper.GetDetailPolicy().SetTimeBudget(1000)
points, half = at(fixed, IN_MOTION)
for _ in range(4):
    points, half = at(fixed, IN_MOTION)
    fixed.mapper.PrepareSimplification()
assert points == POINTS - POINTS // 2
points, again = at(fixed, AT_REST)
assert points == POINTS - POINTS // 2 and gv.difference(half, again) == 0

# --------------------------------------------------------------------------------------------------
# Other values, other meshes

cells = gm.make_grid(*gm.lattice(8))
gm.add_array(cells.GetCellData(), [i % 11 / 11 for i in range(cells.GetNumberOfCells())], "cell")
cells.GetCellData().SetActiveScalars("cell")
_, expected = at(make(cells), AT_REST)
scene = make(cells, JustInTime=True, ViewDependent=False)
_, picture = at(scene, AT_REST)
assert gv.difference(picture, expected) == 0
scene.mapper.PrepareSimplification()
scene.mapper.GetDetailPolicy().SetTimeBudget(1e-6)
for _ in range(3):
    points, _ = at(scene, IN_MOTION)
    scene.mapper.PrepareSimplification()
assert points == 500, points

# The input changes while simpler meshes are made of it.
scene = make(mesh, JustInTime=True, TimeBudget=0.001)
for n in 16, 5, 9, 16:
    scene.mapper.SetInputDataObject(gv.wave(n))
    for _ in range(3):
        points, picture = at(scene, IN_MOTION)
        assert points <= (n + 1) ** 3
    points, picture = at(scene, AT_REST)
    assert points in (0, (n + 1) ** 3)
assert gv.difference(picture, full) == 0

# Pictures that are stopped: nothing of them is shown, and the next one is right. So it is where the
# first picture waits for the background, which goes on.
tag = scene.mapper.AddObserver("ProgressEvent", lambda *_: scene.window.SetAbortRender(1))
_, picture = at(scene, AT_REST)
assert gv.difference(picture, full) > 0.02
scene.mapper.RemoveObserver(tag)
_, picture = at(scene, AT_REST)
assert gv.difference(picture, full) == 0

scene = make(gv.wave(40), SimplificationRatio=0.9)
tag = scene.mapper.AddObserver("ProgressEvent", lambda *_: scene.window.SetAbortRender(1))
assert at(scene, AT_REST)[0] == 0
scene.mapper.RemoveObserver(tag)
assert at(scene, AT_REST)[0] == 41 ** 3 - math.floor(0.9 * 41 ** 3)

# No mesh that could be simplified: all that there is.
empty = gm.make_grid(*gm.lattice(1))
gm.add_array(empty.GetPointData(), [i / 7 for i in range(8)], "wave")
empty.GetPointData().SetActiveScalars("wave")
scene = make(empty, SimplificationRatio=1.0)
points, _ = at(scene, AT_REST)
assert 4 <= points <= 8

# --------------------------------------------------------------------------------------------------
# What cannot be

scene = make(mesh)
for ratio, clamped in (-0.1, 0), (1.1, 1), (math.inf, 1):
    scene.mapper.GetDetailPolicy().SetSimplificationRatio(ratio)
    assert scene.mapper.GetDetailPolicy().GetSimplificationRatio() == clamped, ratio
errors = gm.Errors(scene.mapper)
scene.mapper.GetDetailPolicy().SetSimplificationRatio(math.nan)
at(scene, AT_REST)
assert "SimplificationRatio is not a number" in str(errors), str(errors)
scene.mapper.GetDetailPolicy().SetSimplificationRatio(0)
_, picture = at(scene, AT_REST)
assert gv.difference(picture, full) == 0

reader = gv.write(mesh, "just-in-time.gtn", 2000)
_, expected = at(make(reader), AT_REST)
scene = make(reader, JustInTime=True)
warnings = []
scene.mapper.AddObserver("WarningEvent", lambda *_: warnings.append(1))
for rate in AT_REST, IN_MOTION, AT_REST:
    points, picture = at(scene, rate)
    assert points == 0
assert len(warnings) == 1
assert gv.difference(picture, expected) == 0
assert not scene.mapper.PrepareSimplification()
