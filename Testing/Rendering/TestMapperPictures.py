# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""A window shows the picture that vtkGatunRayCaster makes, in front of the background: in every
projection, place and mode."""

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkPlane, vtkPlaneCollection
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkRenderingVolume import vtkVolumeMapper

import gatunVolumes as gv

MESH = gv.wave()
MODES = {"Composite": 0, "MaximumIntensity": 1, "XRay": 101}


def compare(scene, **options):
    size = scene.window.GetSize()
    picture = scene.render()
    gv.require_same(picture[..., :3], gv.over(gv.cast(scene, MESH, size, **options)))
    return picture


# Projections and shapes of the window.
for size in ((160, 120), (90, 200), (301, 77)):
    for parallel in (False, True):
        scene = gv.Scene(MESH, size)
        scene.look(0.4, 0.9, parallel=parallel)
        compare(scene)

# From within the mesh, all of the window is full.
scene = gv.Scene(MESH)
scene.look(0.4, 0.9, distance=0.1)
scene.camera.SetClippingRange(1e-5, 10)
compare(scene)

# Every mode; and back.
scene = gv.Scene(MESH)
for name, mode in [*MODES.items(), ("Composite", 0)]:
    getattr(scene.mapper, "SetBlendModeTo" + name)()
    assert scene.mapper.GetBlendMode() == mode, name
    compare(scene, BlendMode=mode)

# Both classes number the modes alike, and as vtkVolumeMapper does. Modes that they do not have, such
# as its MINIMUM_INTENSITY_BLEND, are refused.
for one in (scene.mapper, gv.make_caster(MESH)):
    errors = gv.gm.Errors(one).messages
    for name, mode in MODES.items():
        getattr(one, "SetBlendModeTo" + name)()
        assert one.GetBlendMode() == mode, name
    for mode in (-1, vtkVolumeMapper.MINIMUM_INTENSITY_BLEND, 100, 102):
        before = one.GetMTime()
        one.SetBlendMode(mode)
        assert len(errors) == 1 and "not supported" in errors.pop(), mode
        assert one.GetBlendMode() == MODES["XRay"] and one.GetMTime() == before, mode
assert scene.mapper.MAXIMUM_INTENSITY_BLEND == vtkVolumeMapper.MAXIMUM_INTENSITY_BLEND

# Where the volume is: its own position, orientation and scale, and a matrix on top of it.
scene = gv.Scene(MESH)
scene.volume.SetPosition(0.2, -0.1, 0.3)
scene.volume.SetOrientation(20, 30, 40)
scene.volume.SetScale(0.8, 0.5, 1.1)
compare(scene)
matrix = vtkMatrix4x4()
matrix.SetElement(0, 1, 0.3)
matrix.SetElement(1, 3, 0.2)
scene.volume.SetUserMatrix(matrix)
compare(scene)

# A renderer in a part of the window draws there and nowhere else.
scene = gv.Scene(MESH, (200, 200), viewport=(0.25, 0.5, 0.85, 1))
picture = scene.render()
part = picture[100:, 50:170, :3]
gv.require_same(part, gv.over(gv.cast(scene, MESH, (120, 100))))
picture[100:, 50:170] = 0
assert not picture[..., :3].any()

# In stereo the volume is where a surface of the same shape is, for each eye.
def silhouette(picture):
    return np.abs(picture[..., :3] - gv.BACKGROUND).max(-1) > 0.1


box = gv.Scene(gv.constant(), (200, 150), gv.make_property(((0, 1), (1, 1)), 0.01))
box.camera.SetEyeAngle(10)
surface = gv.Scene(gv.constant(), (200, 150))
surface.renderer.RemoveVolume(surface.volume)
surface.renderer.AddActor(gv.cube())
surface.renderer.SetActiveCamera(box.camera)
for parallel in (False, True):
    box.look(0.3, 0.4, parallel=parallel)
    box.window.StereoRenderOff()
    seen = [silhouette(box.render())]
    for eye in "Left", "Right":
        for scene in (box, surface):
            getattr(scene.window, "SetStereoTypeTo" + eye)()
            scene.window.StereoRenderOn()
        seen.append(silhouette(box.render()))
        assert (seen[-1] != silhouette(surface.render())).sum() < 150
    assert (seen[1] != seen[2]).sum() > 1000 or parallel
    assert (seen[1] != seen[0]).sum() > 500 or parallel

# What is seen through is part of a window's alpha.
scene = gv.Scene(MESH)
scene.window.AlphaBitPlanesOn()
scene.renderer.SetBackground(0, 0, 0)
scene.renderer.SetBackgroundAlpha(0)
picture = scene.render()
rgba = gv.cast(scene, MESH, scene.window.GetSize())
assert picture[0, 0, 3] == 0 and picture[..., 3].max() > 0.5
gv.require_same(picture, rgba)

# The camera's clipping range.
scene = gv.Scene(MESH)
scene.look()
scene.camera.SetClippingRange(2.9, 10)
picture = scene.render()
plane = vtkPlane()
plane.SetOrigin(0.5, 0.5, 0.6)
plane.SetNormal(0, 0, -1)
planes = vtkPlaneCollection()
planes.AddItem(plane)
expected = gv.over(gv.cast(scene, MESH, (160, 120), ClippingPlanes=planes))
gv.require_same(picture[..., :3], expected)

# Clipping planes, in world coordinates.
scene = gv.Scene(MESH)
scene.volume.SetPosition(0.1, 0, 0)
whole = scene.render()
plane = vtkPlane()
plane.SetOrigin(0.5, 0.5, 0.5)
plane.SetNormal(1, 0.5, 0)
scene.mapper.AddClippingPlane(plane)
clipped = compare(scene, ClippingPlanes=scene.mapper.GetClippingPlanes())
assert gv.difference(whole, clipped) > 0.1
plane.SetNormal(-1, 0.5, 0)
assert gv.difference(clipped, compare(scene, ClippingPlanes=scene.mapper.GetClippingPlanes())) > 0.1
scene.mapper.RemoveAllClippingPlanes()
assert gv.difference(whole, scene.render()) == 0

# Rays two pixels apart: in between they are interpolated, and nothing is moved.
scene = gv.Scene(gv.wave(3), (160, 120), AutoAdjustSampleDistances=False)
full = scene.render()
scene.set(ImageSampleDistance=2)
half = scene.render()
assert scene.mapper.GetImageSampleDistance() == 2
assert 0 < np.abs(full - half).mean() < 0.006
# A box is as large as it was: of what it covers, little changes at its outline.
scene = gv.Scene(
    gv.constant(), (160, 120), gv.make_property(((0, 1), (1, 1)), 0.01),
    AutoAdjustSampleDistances=False)
scene.renderer.SetBackground(0, 0, 0)
scene.look(0.3, 0.5, distance=1.7)
full = scene.render()[..., 1].sum()
for distance in (2, 3, 8):
    scene.set(ImageSampleDistance=distance)
    assert abs(scene.render()[..., 1].sum() / full - 1) < 0.01

# New values, colors and cameras show at once.
scene = gv.Scene(MESH)
compare(scene)
scene.volume.SetProperty(gv.make_property(((0, 0.5), (1, 0.0))))
compare(scene)
scene.look(2, 0.1, 2)
compare(scene)
MESH.GetPointData().GetArray("wave").SetValue(0, 0.25)
MESH.GetPointData().GetArray("wave").Modified()
compare(scene)
