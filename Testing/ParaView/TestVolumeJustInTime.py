# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Gatun Volume just in time: fewer points while somebody interacts, all of them at rest, and a part of
them if that is wanted."""

import time

import gatunSample as sample
import gatunVolume as drawing
from gatunParaView import load_plugin

simple = load_plugin()
view = drawing.make_view()
source = sample.make_source()
shown = drawing.show(source, view)
full = drawing.draw(view)


def drawn_points():
    proxy = shown.SMProxy
    proxy.UpdatePropertyInformation()
    return proxy.GetProperty("DrawnPoints").GetElement(0)


assert drawn_points() in (0, sample.POINTS)

# Off: all of it in motion, too.
assert shown.JustInTime == 1
shown.JustInTime = 0
view.SMProxy.InteractiveRender()
assert drawn_points() == 0

shown.JustInTime = 1
shown.TimeBudget = 1e-6
drawing.require_same(drawing.draw(view), full)
simplest = sample.POINTS
for _ in range(100):
    view.SMProxy.InteractiveRender()
    simplest = drawn_points() or simplest
    if simplest < sample.POINTS:
        break
    time.sleep(0.1)  # it may not be known yet how to simplify
assert 0 < simplest < sample.POINTS, simplest
drawing.require_same(drawing.draw(view), full)
assert drawn_points() in (0, sample.POINTS)

# The points follow the slider.
shown.JustInTime = 0
before = sample.POINTS
for ratio in 0.2, 0.5, 0.98:
    shown.SimplificationRatio = ratio
    picture = drawing.draw(view)
    points = drawn_points()
    assert points == sample.POINTS - int(sample.POINTS * ratio) and points < before, points
    before = points
drawing.require_other(picture, full)
shown.SimplificationRatio = 0
drawing.require_same(drawing.draw(view), full)

# So they do with the error.
before = sample.POINTS
for pixels in 0.1, 1, 10:
    shown.PixelError = pixels
    drawing.draw(view)
    assert 0 < drawn_points() < before, (pixels, drawn_points())
    before = drawn_points()
shown.PixelError = 0
drawing.require_same(drawing.draw(view), full)
