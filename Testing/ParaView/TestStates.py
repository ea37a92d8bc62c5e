# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""States, as .pvsm files and as Python scripts, and traces of a session show the same picture again."""

import os

import gatunSample as sample
import gatunVolume as drawing
from gatunParaView import load_plugin

from paraview import smstate, smtrace

simple = load_plugin()
grid = sample.temporary("states.gtn")
simple.SaveData(grid, proxy=sample.make_source(), ChunkSize=300, Hierarchy=1, WriteBoundary=1)
for made in list(simple.GetSources().values()):
    simple.Delete(made)


def arrange(view):
    """What a trace does not record of a view."""
    view.ViewSize = [drawing.SIZE] * 2
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [0.2, 0.3, 0.4]
    drawing.look(view, 2.9, 2.2, 2.6)


def session():
    """What a user does: opens a file, chooses Gatun Volume, and contours it. All of it in calls that
    a trace records."""
    reader = simple.GatunReader(FileNames=[grid], LargeMesh=0)
    view = simple.CreateView("RenderView")
    arrange(view)
    shown = simple.Show(reader, view)
    shown.SetRepresentationType("Gatun Volume")
    contour = simple.GatunContour(Input=reader, ContourBy=["POINTS", "wave"], Isosurfaces=[1.5])
    simple.ColorBy(simple.Show(contour, view), None)
    return view, shown


def forget():
    """Everything of the session, transfer functions, too."""
    simple.ResetSession()
    assert not simple.GetSources() and not simple.GetRenderViews()


def require_again(way, picture):
    views = simple.GetRenderViews()
    assert len(views) == 1, (way, views)
    arrange(views[0])
    again = drawing.draw(views[0])
    count = drawing.differing(again, picture)
    assert count == 0, (way, count)


smtrace.start_trace()
first, shown = session()
trace = smtrace.stop_trace()
picture = drawing.draw(first)
assert drawing.differing(picture, drawing.draw(first)) == 0
empty = drawing.make_view()
drawing.require_other(picture, drawing.draw(empty))
simple.Delete(empty)
simple.SetActiveView(first)

# Another array, a range that is narrower than that of the array, which nothing must undo, and more.
simple.ColorBy(shown, ("POINTS", "wave"))
shown.SetScalarBarVisibility(first, False)
for function in simple.GetColorTransferFunction("wave"), simple.GetOpacityTransferFunction("wave"):
    function.RescaleTransferFunction(-1, 2)
shown.ScalarOpacityUnitDistance = 3
shown.SimplificationRatio = 0.25
narrow = drawing.draw(first)
drawing.require_other(narrow, picture)
state = sample.temporary("states.pvsm")
simple.SaveState(state)
script = smstate.get_state()

forget()
simple.LoadState(state)
require_again("state", narrow)
forget()
exec(compile(script, "state.py", "exec"), {})  # noqa: S102
require_again("script", narrow)
forget()
exec(compile(trace, "trace.py", "exec"), {})  # noqa: S102
require_again("trace", picture)
os.remove(state)
