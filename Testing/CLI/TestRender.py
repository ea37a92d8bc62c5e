# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""render writes what vtkGatunRayCaster draws, whatever the mesh comes from, as .png and .exr, over a
background or without."""

import json
import os

import numpy as np
from vtkmodules.vtkRenderingCore import vtkCamera, vtkVolumeProperty

from gatun.vtk import vtkGatunDefaults, vtkGatunRayCaster, vtkGatunReader
from gatunCli import enter_folder, gtn, standard_mesh, write
from gatunPictures import read_exr, read_png, run_oiiotool, to_array

enter_folder("render")
write(standard_mesh(8), "mesh.vtu")
gtn("pack", "-q", "--chunk-size", 500, "mesh.vtu", "mesh.gtn")
WIDTH, HEIGHT = 80, 60
position, focal_point, view_up = (14, 9, 19), (4, 4.5, 3.5), (0.1, 1, 0)
with open("camera.json", "w") as file:
    json.dump({"position": position, "focalPoint": focal_point, "viewUp": view_up}, file)
arguments = ["render", "-q", "--size", f"{WIDTH}x{HEIGHT}", "--array", "velocity", "--component", 0]
arguments += ["--camera", "camera.json", "--unit-distance", 0.3]


def draw(shade=False):
    """The same by vtkGatunRayCaster."""
    reader = vtkGatunReader()
    reader.SetFileName("mesh.gtn")
    defaults = vtkGatunDefaults()
    defaults.SetInputConnection(reader.GetOutputPort())
    defaults.SetArrayName("velocity")
    defaults.SetArrayComponent(0)
    look = vtkVolumeProperty()
    assert defaults.MakeProperty(look)
    look.SetScalarOpacityUnitDistance(0.3)
    look.SetShade(shade)
    camera = vtkCamera()
    camera.SetPosition(position)
    camera.SetFocalPoint(focal_point)
    camera.SetViewUp(view_up)
    caster = vtkGatunRayCaster()
    caster.SetInputConnection(reader.GetOutputPort())
    caster.SetArrayName("velocity")
    caster.SetArrayComponent(0)
    caster.SetSize(WIDTH, HEIGHT)
    caster.SetCamera(camera)
    caster.SetProperty(look)
    caster.Update()
    return to_array(caster.GetOutput(), "RGBA"), to_array(caster.GetOutput(), "Depth")[:, :, 0]


rgba, depth = draw()
alpha = rgba[:, :, 3:]
assert 0.1 < np.mean(alpha > 0) < 0.9 and alpha.max() > 0.5, "nothing to compare"
straight = np.where(alpha > 0, rgba[:, :, :3] / np.maximum(alpha, 1e-30), 0)
straight = np.concatenate([straight, alpha], axis=2)


def check(picture, expected, tolerance=1.01):
    difference = np.abs(picture - 255 * np.clip(expected, 0, 1))
    # Colors of what is hardly seen are quotients of tiny numbers.
    difference[:, :, :3] *= 1 if expected.shape[2] == 3 else alpha > 0.02
    assert difference.max() <= tolerance, difference.max()


# Transparent, with straight opacity; the rows are not upside down.
gtn(*arguments, "mesh.gtn", "file.png")
check(read_png("file.png"), straight)
gtn(*arguments, "mesh.vtu", "memory.png")
check(read_png("memory.png"), straight)

# In the light of the camera.
gtn(*arguments, "--shade", "mesh.gtn", "shaded.exr")
shaded = draw(shade=True)[0]
assert np.abs(read_exr("shaded.exr", WIDTH, HEIGHT)[:, :, :4] - shaded).max() < 1 / 255
assert np.abs(shaded - rgba).max() > 0.1

# Over a background.
gtn(*arguments, "--background", "#3366cc", "mesh.gtn", "over.png")
background = np.array([0x33, 0x66, 0xCC]) / 255
check(read_png("over.png"), rgba[:, :, :3] + (1 - alpha) * background)

# Floats, and depth.
gtn(*arguments, "mesh.gtn", "file.exr")
values = read_exr("file.exr", WIDTH, HEIGHT)
assert np.abs(values[:, :, :4] - rgba).max() < 1 / 255
assert (np.isinf(values[:, :, 4]) == np.isinf(depth)).all() and np.isinf(depth).any()
seen = np.isfinite(depth)
assert np.abs(values[:, :, 4][seen] - depth[seen]).max() < 0.02 * depth[seen].max()
gtn(*arguments, "--background", "white", "mesh.gtn", "over.exr")
values = read_exr("over.exr", WIDTH, HEIGHT)
assert np.abs(values[:, :, :3] - (rgba[:, :, :3] + 1 - alpha)).max() < 1 / 255
assert (values[:, :, 3] == 1).all()

# What the files tell of themselves; the camera can be used again.
for name in ("file.png", "file.exr"):
    info = run_oiiotool("--info", "-v", name)
    channels = "R, G, B, A" if name == "file.png" else "R, G, B, A, Z"
    for words in (f"channel list: {channels}\n", 'Software: "Gatun ', 'Gatun:input: "mesh.gtn"'):
        assert words in info, (words, info)
    command = [line for line in info.splitlines() if "Gatun:command" in line][0]
    assert "gtn render -q --size 80x60 " in command, command
camera = [line for line in info.splitlines() if "Gatun:camera" in line][0]
with open("again.json", "w") as file:
    file.write(camera.split(": ", 1)[1].strip()[1:-1])
os.replace("again.json", "camera.json")
gtn(*arguments, "mesh.gtn", "again.png")
check(read_png("again.png"), straight)

# Modes differ, and none of them is empty.
pictures = []
more = [["--mode", mode] for mode in ("composite", "mip", "xray")]
more += [["--component", "0"], ["--opacity", "3"], ["--zoom", "1.5"], ["--roll", "30"]]
more += [["--parallel"], ["--range", "0,1"], ["--elevation", "90"]]
for options in more:
    command = ["render", "-f", "-q", "--size", "40x30", "--array", "velocity", *options]
    gtn(*command, "mesh.gtn", "some.png")
    pictures.append(read_png("some.png"))
    assert pictures[-1][:, :, 3].max() > 20, options
    for other in pictures[:-1]:
        assert np.abs(pictures[-1] - other).max() > 3, options

# What it took.
size = ("--size", f"{WIDTH}x{HEIGHT}")
text = gtn("render", "-f", "--stats", *size, "mesh.gtn", "some.png", says="chunks skipped")
assert "tetrahedra of drawn chunks            3,072" in text, text
told = json.loads(gtn("render", "-f", "--json", *size, "mesh.gtn", "t.png"))
assert told["file"] == "t.png" and told["width"] == WIDTH and told["height"] == HEIGHT
assert told["array"] == "pressure" and told["tets"] == 3072
taken = told["statistics"]
assert taken["tets"] == 3072 and taken["chunks"] > 1 and 0 < taken["seenTets"] <= 3072
assert taken["bytesRead"] > 0
assert told["peakMemory"] > 1 << 20
bounds = json.loads(gtn("info", "--json", "mesh.gtn"))["bounds"]
diagonal = np.sqrt(sum((high - low) ** 2 for low, high in bounds))
assert abs(told["unitDistance"] - diagonal / 100) < 1e-9 * diagonal
camera = told["camera"]
arm = np.subtract(camera["position"], camera["focalPoint"])
assert 0.4 < np.linalg.norm(arm) / (diagonal / 2 / np.sin(np.radians(15))) < 1, "not as near as can be"
assert np.isclose(np.degrees(np.arcsin(arm[1] / np.linalg.norm(arm))), 20)
assert np.isclose(np.degrees(np.arctan2(arm[0], arm[2])), 30)
