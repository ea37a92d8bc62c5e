# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Gatun Surface draws a surface from its file as Surface draws it from memory: colors, styles, light,
opacity, places and time, on one rank and on several; other inputs are those of Surface."""

import gatunSample as sample
import gatunVolume as drawing
from gatunParaView import load_plugin, rank_and_ranks

simple = load_plugin()
rank, ranks = rank_and_ranks()
view = drawing.make_view()
sphere = simple.Sphere(ThetaResolution=160, PhiResolution=120, Radius=0.5 * sample.SIDE,
                       Center=[0.5 * sample.SIDE] * 3)
waves = simple.Calculator(Input=sphere, ResultArrayName="wave", Function="sin(9*coordsX)+coordsY")
waves.UpdatePipeline()
path = sample.temporary("drawn.gtn")
simple.SaveData(path, proxy=waves, ChunkSize=500)

whole = simple.OpenDataFile(path)
whole.LargeMesh = -1
file = simple.OpenDataFile(path)
file.LargeMesh = 0
theirs = simple.Show(whole, view)
simple.Hide(whole, view)
ours = simple.Show(file, view)
assert ours.Representation == "Gatun Surface", ours.Representation
theirs.Representation = "Surface"
view.ResetCamera(False)
view.CameraFocalPoint = [0.5 * sample.SIDE] * 3
view.CameraPosition = [sample.SIDE * f for f in (2.4, 1.9, 2.2)]
view.ResetCamera(False)


def count(name):
    proxy = ours.SMProxy
    proxy.UpdatePropertyInformation()
    return proxy.GetProperty(name).GetElement(0)


def pictures():
    """From the file and from memory."""
    made = []
    for shown, hidden in ((file, whole), (whole, file)):
        simple.Show(shown, view)
        simple.Hide(hidden, view)
        made.append(drawing.draw(view))
    simple.Show(file, view)
    simple.Hide(whole, view)
    return made


def require(what, by=2, pixels=0):
    one, other = pictures()
    try:
        drawing.require_same(one, other, by, pixels)
    except AssertionError as failure:
        raise AssertionError((what, *failure.args)) from failure
    return one


file.UpdatePipeline()
assert file.GetDataInformation().GetNumberOfCells() == 12
plain = require("plain")
drawn = count("DrawnChunks")
assert drawn > 20 / ranks, drawn
decoded = count("DecodedChunks")
drawing.draw(view)
drawing.draw(view)
assert count("DecodedChunks") == decoded, (decoded, count("DecodedChunks"))

for shown in ours, theirs:
    simple.ColorBy(shown, ("POINTS", "wave"))
    shown.SetScalarBarVisibility(view, False)
table = simple.GetColorTransferFunction("wave")
table.RescaleTransferFunction(-1, 2)
colored = require("colored")
drawing.require_other(colored, plain)
table.ApplyPreset("Black-Body Radiation", True)
drawing.require_other(require("other colors"), colored)

ours.Style = "Surface With Edges"
theirs.Representation = "Surface With Edges"
drawing.require_other(require("edges"), colored)
ours.Style = theirs.Representation = "Points"
ours.PointSize = theirs.PointSize = 3
drawing.require_other(require("points"), colored)
ours.Style = theirs.Representation = "Surface"
for shown in ours, theirs:
    shown.Specular = 0.8
    shown.Interpolation = "Flat"
    setattr(shown, drawing.place_name(shown), [0.1, 0, 0.2])
    shown.Orientation = [20, 30, 0]
require("moved")
for shown in ours, theirs:
    shown.BackfaceRepresentation = "Cull Frontface"
require("inside")
for shown in ours, theirs:
    shown.BackfaceRepresentation = "Wireframe"
# Lines that two ranks draw lie in front of each other in another order.
require("faces of two styles", pixels=0 if ranks == 1 else 400)
for shown in ours, theirs:
    shown.BackfaceRepresentation = "Follow Frontface"
    shown.Opacity = 0.5
if ranks == 1:
    # Without the order of processes.
    require("translucent", 3)
for shown in ours, theirs:
    shown.Opacity = 1
require("opaque again")
view.SMProxy.InteractiveRender()

# Changes of the reader, and of the file.
ours.MemoryBudget = 0
require("without memory")
file.LargeMesh = -1
require("in memory")
assert count("DrawnChunks") == 0
file.LargeMesh = 0
require("on demand again")
assert count("DrawnChunks") > 0
simple.Hide(file, view)

# Anything else is as with Surface.
other = simple.Show(waves, view)
other.Representation = "Surface"
expected = drawing.draw(view)
other.Representation = "Gatun Surface"
drawing.require_same(drawing.draw(view), expected)

# Coarser while somebody interacts, if the file tells how.
simple.SaveData(path, proxy=waves, ChunkSize=500, Hierarchy=1, Levels=3)
simple.ReloadFiles(file)
ours = simple.Show(file, view)
simple.Hide(waves, view)
view.ImageReductionFactor = 1
ours.JustInTime = 1
ours.ViewDependent = 0
ours.TimeBudget = 1e-6
full = drawing.draw(view)
assert count("DrawnPoints") == 0
view.SMProxy.InteractiveRender()
in_motion = count("DrawnPoints")
assert in_motion > 0
moving = drawing.seen(view)
drawing.require_same(drawing.draw(view), full)
assert count("DrawnPoints") == 0
ours.MemoryBudget = 512
ours.PixelError = 5
coarse = drawing.draw(view)
drawing.require_other(coarse, full)
assert count("DrawnPoints") > 0
ours.ViewDependent = 1
drawing.require_same(drawing.draw(view), coarse)
ours.PixelError = 0
drawing.require_same(drawing.draw(view), full)
# All ranks have drawn the same level: the surface in motion is that with as many points.
ours.SimplificationRatio = 0.5
drawing.draw(view)
ours.SimplificationRatio = 1 - in_motion / (2 * count("DrawnPoints"))
coarse = drawing.draw(view)
assert abs(count("DrawnPoints") - in_motion) <= 1, (count("DrawnPoints"), in_motion)
drawing.require_same(moving, coarse)
ours.SimplificationRatio = 0.9
drawing.require_other(drawing.draw(view), full)
assert count("DrawnPoints") > 0
