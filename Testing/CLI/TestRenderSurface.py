# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""gtn render draws surfaces: from a .gtn file as from other formats, in colors by the values, at
the place where they are, over nothing or a background; and says why it cannot."""

import json
import os

import numpy as np
from vtkmodules.vtkFiltersCore import vtkElevationFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOPLY import vtkPLYWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

from gatunCli import enter_folder, gtn
from gatunPictures import read_exr, read_png

enter_folder("render-surface")
SIZE = 120
VIEW = ("--size", f"{SIZE}x{SIZE}", "--parallel", "-q")

# A ball with a radius of 1, whose array is its height.
ball = vtkSphereSource()
ball.SetRadius(1)
ball.SetThetaResolution(150)
ball.SetPhiResolution(75)
height = vtkElevationFilter()
height.SetInputConnection(ball.GetOutputPort())
height.SetLowPoint(0, -1, 0)
height.SetHighPoint(0, 1, 0)
height.SetScalarRange(-1, 1)
for writer, name in ((vtkXMLPolyDataWriter(), "ball.vtp"), (vtkPLYWriter(), "ball.ply")):
    writer.SetInputConnection((height if name == "ball.vtp" else ball).GetOutputPort())
    writer.SetFileName(name)
    writer.Write()
gtn("pack", "-q", "--chunk-size", "500", "--levels", "2", "ball.vtp", "ball.gtn")

ARRAY = ("--array", "Elevation", "--range", "-1,1")
gtn("render", *VIEW, *ARRAY, "ball.vtp", "vtp.png")
gtn("render", *VIEW, *ARRAY, "ball.gtn", "gtn.png")
from_vtp, from_gtn = read_png("vtp.png"), read_png("gtn.png")
assert from_vtp.shape == (SIZE, SIZE, 4)
# The order of chunks plays a role at edges only.
different = np.abs(from_vtp - from_gtn).max(2) > 3
assert different.mean() < 0.01, different.mean()

# A disk, opaque inside and nothing outside.
alpha = from_gtn[:, :, 3]
rows, columns = np.nonzero(alpha > 127)
radius = np.sqrt(len(rows) / np.pi)
assert SIZE / 6 < radius < SIZE / 2, radius
center = np.array([rows.mean(), columns.mean()])
assert np.abs(center - (SIZE - 1) / 2).max() < 1, center
distance = np.hypot(*(np.indices(alpha.shape) - (SIZE - 1) / 2))
assert (alpha[distance < radius - 2] == 255).all()
assert (alpha[distance > radius + 2] == 0).all()

# Lighter where the value is larger: upwards.
gtn("render", *VIEW, *ARRAY, "--elevation", "0", "ball.gtn", "side.png")
side = read_png("side.png")
middle = SIZE // 2
low, high = (side[int(middle + f * radius), middle, :3].mean() for f in (-0.5, 0.5))
assert high > 1.3 * low, (low, high)

# Over a background, and as an .exr file with premultiplied colors.
gtn("render", *VIEW, *ARRAY, "--background", "#00ff00", "ball.gtn", "green.png")
green = read_png("green.png")
assert green.shape[2] == 3
assert (green[0, 0] == (0, 255, 0)).all()
assert (np.abs(green - from_gtn[:, :, :3]).max(2)[distance < radius - 2] <= 1).all()
gtn("render", *VIEW, *ARRAY, "ball.gtn", "ball.exr")
exr = read_exr("ball.exr", SIZE, SIZE)
assert (exr[0, 0] == 0).all()
assert (np.abs(255 * exr[:, :, :3] - from_gtn[:, :, :3]).max(2)[distance < radius - 2] <= 1).all()

# Coarser, and without an array.
gtn("render", *VIEW, *ARRAY, "--ratio", "0.9", "ball.gtn", "coarse.png")
coarse = read_png("coarse.png")
assert 0.8 < (coarse[:, :, 3] > 127).sum() / len(rows) < 1
said = json.loads(gtn("render", *VIEW, *ARRAY, "--pixel-error", "0.5", "--json", "ball.gtn", "near.png"))
points = said["statistics"]["drawnPoints"]
assert 0 < points < ball.GetOutput().GetNumberOfPoints() / 2, said
near = read_png("near.png")
assert np.abs(near[:, :, :3] - from_gtn[:, :, :3]).mean() < 3
assert (np.abs(near[:, :, 3] - alpha) > 127).mean() < 0.005
gtn("render", *VIEW, "--array", "Normals", "--component", "magnitude", "ball.gtn", "normals.png")
said = json.loads(gtn("render", "--size", "60x60", "--json", "ball.gtn", "json.png"))
assert said["cells"] == ball.GetOutput().GetNumberOfCells(), said
gtn("render", *VIEW, "ball.ply", "ply.png")
assert (np.abs(read_png("ply.png")[:, :, 3] - alpha) > 127).mean() < 0.02

# What cannot be.
refused = "for volumes"
gtn("render", "--mode", "mip", "ball.gtn", "no.png", code=1, says=refused)
gtn("render", "--budget", "1", "ball.gtn", "no.png", code=1, says=refused)
gtn("render", "--array", "nothing", "ball.gtn", "no.png", code=1, says="nothing")
gtn("render", "--pixel-error", "-1", "ball.gtn", "no.png", code=2)
gtn("render", "--pixel-error", "nan", "ball.gtn", "no.png", code=1, says="PixelError")
gtn("render", "--pixel-error", "1", "ball.ply", "no.png", code=1, says="no hierarchy")
gtn("pack", "-f", "ball.ply", "plain.gtn")
gtn("render", "--pixel-error", "1", "plain.gtn", "no.png", code=1, says="hierarchy")
without = {name: value for name, value in os.environ.items() if name != "DISPLAY"}
gtn("render", "ball.gtn", "no.png", code=1, says="xvfb-run", env=without)
with open("ball.gtn", "rb") as file:
    data = bytearray(file.read())
for i in range(1, 8):
    data[len(data) * i // 8] ^= 255
with open("bad.gtn", "wb") as file:
    file.write(data)
gtn("render", "bad.gtn", "no.png", code=1)
assert not os.path.exists("no.png")
