# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Opaque geometry in front of a volume hides it, in the middle of it ends the rays, and behind it is
seen through: with the optical depth that is in front of it."""

import numpy as np

import gatunVolumes as gv

OPACITY = 0.4  # over the unit distance, of the volume's color
UNIT = 0.5
WHITE = np.ones(3)
COLOR = np.array([0.2, 1, 0.2])


def expect(length, behind):
    through = (1 - OPACITY) ** (length / UNIT)
    return (1 - through) * COLOR + through * np.asarray(behind)


def make_scene(parallel, **options):
    scene = gv.Scene(
        gv.constant(), (101, 101), gv.make_property(((0, OPACITY), (1, OPACITY)), UNIT), **options)
    scene.look(parallel=parallel, distance=20)
    scene.camera.SetParallelScale(1)
    scene.camera.SetViewAngle(6)
    scene.camera.SetClippingRange(15, 25)
    return scene


def middle(picture, x=50, y=50):
    return picture[y, x, :3]


def require(found, expected):
    assert np.abs(found - expected).max() < 2.5 / 255, (255 * found, 255 * expected)


for parallel in (False, True):
    scene = make_scene(parallel)
    require(middle(scene.render()), expect(1, gv.BACKGROUND))
    # A thin plate, first in front of the cube from z = 0 to 1, seen from above.
    for z, length in ((1.2, 0), (0.75, 0.25), (0.5, 0.5), (0.1, 0.9), (-0.2, 1)):
        plate = gv.cube((-3, 3, -3, 0.6, z - 0.001, z))
        scene.renderer.AddActor(plate)
        picture = scene.render()
        require(middle(picture), expect(length, WHITE))
        require(middle(picture, y=65), expect(1, gv.BACKGROUND))  # beyond the plate's edge
        require(picture[2, 2, :3], WHITE)
        # Rays that are farther apart find it, too.
        scene.set(AutoAdjustSampleDistances=False, ImageSampleDistance=4)
        require(middle(scene.render()), expect(length, WHITE))
        scene.set(ImageSampleDistance=1)
        scene.renderer.RemoveActor(plate)
    require(middle(scene.render()), expect(1, gv.BACKGROUND))

# In the units of the volume's scale and in a part of the window, at an angle to the rays.
scene = make_scene(False, viewport=(0.5, 0, 1, 1))
scene.window.SetSize(202, 101)
scene.volume.SetScale(1, 1, 2)
scene.volume.SetPosition(0, 0, -0.5)
scene.renderer.AddActor(gv.cube((-3, 3, -3, 3, 0.249, 0.25)))
require(middle(scene.render(), x=151), expect(1.25, WHITE))
scene.renderer.AddActor(gv.cube((0.6, 3, -3, 3, 0.9, 1), (0, 0, 0)))
require(middle(scene.render(), x=151 + 15), expect(0.5, (0, 0, 0)))

# Without it, the volume is in front or behind as a whole, by its center.
scene = make_scene(True, IntermixIntersectingGeometry=False)
for z, expected in ((0.75, WHITE), (0.25, expect(1, WHITE))):
    plate = gv.cube((-3, 3, -3, 3, z - 0.001, z))
    scene.renderer.AddActor(plate)
    require(middle(scene.render()), expected)
    scene.renderer.RemoveActor(plate)
scene.renderer.AddActor(gv.cube((-3, 3, -3, 3, 0.749, 0.75)))
scene.mapper.IntermixIntersectingGeometryOn()
require(middle(scene.render()), expect(0.25, WHITE))
