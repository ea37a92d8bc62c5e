# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Lights of a scene on a volume. Where values are linear, all has one normal, and the shaded picture
is the plain one in other colors."""

import numpy as np
from vtkmodules.vtkRenderingCore import vtkLight

import gatunMeshes as gm
import gatunVolumes as gv

NORMAL = np.array([2, -1, 2]) / 3
points, tets = gm.lattice(5, seed=2)
PLANES = gm.make_grid(points, tets)
values = points @ NORMAL
values = (values - values.min()) / (values.max() - values.min())
gm.add_array(PLANES.GetPointData(), values, "linear")
PLANES.GetPointData().SetActiveScalars("linear")


def make_property(tint=(1, 1, 1), ambient=1.0, diffuse=0.0, specular=0.0, shade=True):
    """Colors multiplied by a tint."""
    prop = gv.make_property()
    colors = prop.GetRGBTransferFunction()
    node = [0.0] * 6
    for i in range(colors.GetSize()):
        colors.GetNodeValue(i, node)
        node[1:4] = np.multiply(node[1:4], tint)
        colors.SetNodeValue(i, node)
    prop.SetShade(shade)
    prop.SetAmbient(ambient)
    prop.SetDiffuse(diffuse)
    prop.SetSpecular(specular)
    return prop


def show(prop, lights=(), mesh=PLANES, **options):
    scene = gv.Scene(mesh, prop=prop, **options)
    for light in lights:
        scene.renderer.AddLight(light)
    return scene.render()[..., :3], scene


def make_light(towards, positional=False, color=(1, 1, 1), intensity=1.0):
    light = vtkLight()
    light.SetLightTypeToSceneLight()
    light.SetPositional(positional)
    light.SetFocalPoint(7, 8, 9)
    light.SetPosition(*(np.array(towards, float) + ((0, 0, 0) if positional else (7, 8, 9))))
    light.SetDiffuseColor(*color)
    light.SetIntensity(intensity)
    return light


# A light at the camera, unless there are others: the same picture as without a window.
wave = gv.wave()
shaded, scene = show(make_property(ambient=0.2, diffuse=0.6, specular=0.4), mesh=wave)
gv.require_same(shaded, gv.over(gv.cast(scene, wave, scene.window.GetSize())))
plain, scene = show(make_property(shade=False), mesh=wave)
assert gv.difference(shaded, plain) > 0.1

# All ambient is as if not shaded.
gv.require_same(show(make_property(ambient=1.0))[0], show(make_property(shade=False))[0])

# Lights far away, from in front and from behind the surfaces: their cosines add up, in their colors.
directions = np.array([[1, 0, 0], [0, 3, 0], [-1, 2, 1]])
tints = np.array([[1, 1, 1], [0.2, 0.5, 1], [0.4, 0, 0.3]])
lights = [make_light(d, color=t) for d, t in zip(directions, tints)]
cosines = np.abs(directions @ NORMAL) / np.linalg.norm(directions, axis=1)
expected = 0.3 + 0.5 * cosines @ tints
gv.require_same(
    show(make_property(ambient=0.3, diffuse=0.5), lights)[0],
    show(make_property(expected, shade=False))[0])

# One that is off, and one that is dimmed.
lights[0].SwitchOff()
lights[1].SetIntensity(0.5)
expected = 0.3 + 0.5 * (0.5 * cosines[1] * tints[1] + cosines[2] * tints[2])
gv.require_same(
    show(make_property(ambient=0.3, diffuse=0.5), lights)[0],
    show(make_property(expected, shade=False))[0])

# A lamp far away is as a light from there; one nearby is not.
far = 1e4 * np.array([1, 1, 0.5])
lamp, _ = show(make_property(ambient=0.0, diffuse=0.8), [make_light(far, positional=True)])
light, _ = show(make_property(ambient=0.0, diffuse=0.8), [make_light(far)])
gv.require_same(lamp, light)
near = [make_light((2, 2, 1), positional=True)]
assert gv.difference(light, show(make_property(ambient=0.0, diffuse=0.8), near)[0]) > 0.05

# Where the surfaces mirror the light into the eye, it is white.
scene = gv.Scene(PLANES, prop=make_property(ambient=0.0, specular=1.0))
middle = np.array([0.5, 0.5, 0.5])
to_eye = np.array(scene.camera.GetPosition()) - middle
to_eye /= np.linalg.norm(to_eye)
scene.renderer.AddLight(make_light(2 * (NORMAL @ to_eye) * NORMAL - to_eye))
scene.volume.GetProperty().SetSpecularPower(1)
picture = scene.render()[60, 80, :3]
alpha = gv.cast(scene, PLANES, scene.window.GetSize())[60, 80, 3]
background = np.array(gv.BACKGROUND)
assert np.abs(picture - (alpha + (1 - alpha) * background)).max() < 0.02, (picture, alpha)

# Other modes are not shaded, and neither are values of cells.
for mode in "MaximumIntensity", "XRay":
    pictures = []
    for shade in False, True:
        scene = gv.Scene(PLANES, prop=make_property(ambient=0.1, diffuse=0.2, shade=shade))
        getattr(scene.mapper, "SetBlendModeTo" + mode)()
        pictures.append(scene.render())
    gv.require_same(*pictures)
cells = gm.make_grid(points, tets)
gm.add_array(cells.GetCellData(), np.linspace(0, 1, len(tets)), "cell")
cells.GetCellData().SetActiveScalars("cell")
gv.require_same(
    show(make_property(ambient=0.1), mesh=cells)[0],
    show(make_property(shade=False), mesh=cells)[0])
