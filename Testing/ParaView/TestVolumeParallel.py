# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Gatun Volume shows the same image on any number of ranks, however the cells are dealt out to them, with
geometry that other ranks have, in all modes. On one rank the images are written, on more they are
compared with those.
"""

import os
import time

import numpy as np

import gatunSample as sample
import gatunScatter as scatter
import gatunVolume as drawing
from gatunParaView import load_plugin, rank_and_ranks

simple = load_plugin()
rank, ranks = rank_and_ranks()
path = os.path.join(os.environ["GATUN_TEST_TEMP"], "TestVolumeParallel.npz")
expected = np.load(path) if ranks > 1 else None
images = {}


def check(name):
    """Draws, and compares with one rank: within 1 of 255 except for 0.01 % of the pixels."""
    image = drawing.draw(view)
    if rank != 0:
        return
    images[name] = image
    if ranks > 1:
        apart = np.abs(image - expected[name]).max(2)
        print("%s: %d pixels differ, %d by more than 1, at most by %d" % (
            name, (apart > 0).sum(), (apart > 1).sum(), apart.max()))
        failed.extend([name] if (apart > 1).sum() > 1e-4 * apart.size else [])


failed = []
view = drawing.make_view()
ball = scatter.make_ball()
shown_ball = simple.Show(ball, view)
simple.Hide(ball, view)

for mesh in ("Post", "Delaunay"):
    scattered = scatter.make_source(mesh)
    shown = drawing.show(scattered, view)
    # All cells are there, and the first rank has its share of them.
    cells = sample.counts(scattered)[1]
    images[mesh + "Cells"] = cells
    assert ranks == 1 or cells == expected[mesh + "Cells"], cells
    share = scatter.count_on_first(scattered) * ranks / cells
    assert 0.9 < share < 1.1, share
    for geometry in ("", "Ball"):
        if geometry:
            simple.Show(ball, view)
        for mode in (0, 1, 101):
            shown.BlendMode = mode
            check("%s%s%d" % (mesh, geometry, mode))
        shown.BlendMode = 0
    drawing.look(view, 0.52, 0.2, 0.61)
    check(mesh + "Inside")
    view.CameraParallelProjection = 1
    view.CameraParallelScale = 8
    check(mesh + "ParallelProjection")
    view.CameraParallelProjection = 0
    drawing.look(view, 2.9, 2.2, 2.6)
    # ParaView puts translucent geometry in order; the volume is drawn over it, as by one rank.
    shown_ball.Opacity = 0.4
    check(mesh + "Translucent")
    shown_ball.Opacity = 1
    simple.Hide(ball, view)
    # Nothing in view of some ranks, or of all.
    drawing.look(view, 1.5, 1.5, -3)
    check(mesh + "Away")
    drawing.look(view, 2.9, 2.2, 2.6)
    simple.Hide(scattered, view)

# Two meshes that overlap.
simple.Show(ball, view)
for mesh in ("Post", "Delaunay"):
    drawing.show(scatter.make_source(mesh), view)
check("Both")

simple.HideAll(view)

# A file, each rank with some of its chunks: as it is, and simplified.
file = sample.temporary("volume-parallel.gtn")
simple.SaveData(file, proxy=sample.make_source(), ChunkSize=300, Hierarchy=1, Levels=4)
reader = simple.GatunReader(FileNames=[file], LargeMesh=0)
shown = drawing.show(reader, view)
check("File")
simple.Show(ball, view)
check("FileBall")
for ratio in (0.3, 0.8):
    shown.SimplificationRatio = ratio
    check("File%g" % ratio)
shown.SimplificationRatio = 0
check("FileAgain")
for pixels in (0.5, 5):
    shown.PixelError = pixels
    check("FilePixels%g" % pixels)
shown.PixelError = 0
check("FileOnceMore")


def number(name):
    shown.SMProxy.UpdatePropertyInformation()
    return shown.SMProxy.GetProperty(name).GetElement(0)


# A few fragments for each pixel, and depths.
sent = number("BytesSent")
assert (sent == 0) == (ranks == 1) and sent < 100 * drawing.SIZE ** 2, sent

# Just in time.
shown.JustInTime = 1
shown.TimeBudget = 1e-6
check("FileAtRest")
simplest = sample.POINTS
for _ in range(100):
    view.SMProxy.InteractiveRender()
    simplest = number("DrawnPoints") or simplest
    if simplest < sample.POINTS:
        break
    time.sleep(0.1)  # it may not be known yet how to simplify
assert simplest < sample.POINTS, simplest
check("FileAtRestAgain")

if ranks == 1:
    np.savez_compressed(path, **images)
    drawing.require_other(images["Post0"], images["PostBall0"])
    drawing.require_other(images["FilePixels5"], images["FileAgain"])
    drawing.require_other(images["Post0"], images["Post1"])
    drawing.require_other(images["PostBall0"], images["PostTranslucent"])
    drawing.require_other(images["Post0"], images["Delaunay0"])
assert not failed, failed
