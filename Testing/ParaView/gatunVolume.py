# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""A view to draw volumes in, and its pictures as numbers."""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter

from paraview import simple

import gatunSample as sample

SIZE = 200
COLORS = [-2.5, 0.23, 0.3, 0.75, 0.3, 0.87, 0.87, 0.87, 3, 0.71, 0.02, 0.15]
OPACITIES = [-2.5, 0, 0.5, 0, 3, 1, 0.5, 0]


def place_name(shown):
    """The property of a representation that moves it, named Position before ParaView 5.13."""
    return "Translation" if hasattr(shown, "Translation") else "Position"


def make_view():
    view = simple.CreateRenderView()
    view.ViewSize = [SIZE, SIZE]
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [0.2, 0.3, 0.4]
    look(view, 2.9, 2.2, 2.6)
    return view


def look(view, x, y, z):
    """At the middle of the mesh, from a place in units of its side."""
    view.CameraPosition = [sample.SIDE * f for f in (x, y, z)]
    view.CameraFocalPoint = [sample.SIDE / 2] * 3
    view.CameraViewUp = [0, 0, 1]
    view.CameraViewAngle = 30


def color(shown, view, array="wave", colors=COLORS, opacities=OPACITIES, association="POINTS"):
    simple.ColorBy(shown, (association, array))
    shown.SetScalarBarVisibility(view, False)
    table = simple.GetColorTransferFunction(array)
    table.ColorSpace = "RGB"
    table.RGBPoints = colors
    simple.GetOpacityTransferFunction(array).Points = opacities


def show(source, view, representation="Gatun Volume"):
    """The representation, colored by "wave"."""
    shown = simple.Show(source, view)
    shown.SetRepresentationType(representation)
    color(shown, view)
    if hasattr(shown, "ScalarOpacityUnitDistance"):
        shown.ScalarOpacityUnitDistance = 3
    return shown


def draw(view):
    """Red, green and blue of each pixel, 0 to 255, from below."""
    # Without FXAA, which finds other edges where several ranks have not been blended over the
    # background yet. Other views turn it on again.
    view.UseFXAA = 1
    view.UseFXAA = 0
    simple.Render(view)
    picture = view.SMProxy.CaptureWindow(1)
    width, height, _ = picture.GetDimensions()
    pixels = vtk_to_numpy(picture.GetPointData().GetScalars()).reshape(height, width, -1)
    return pixels.astype(int)


def seen(view):
    """The same of what the window shows now, without drawing it anew."""
    grab = vtkWindowToImageFilter()
    grab.SetInput(view.GetRenderWindow())
    grab.ShouldRerenderOff()
    grab.ReadFrontBufferOff()
    grab.Update()
    width, height, _ = grab.GetOutput().GetDimensions()
    pixels = vtk_to_numpy(grab.GetOutput().GetPointData().GetScalars()).reshape(height, width, -1)
    return pixels[:, :, :3].astype(int)


def ranges(source, array, association="PointData"):
    """Of an array of a source: of the length of its tuples, if they are any, and its components."""
    source.UpdatePipeline()
    found = getattr(source, association)[array]
    components = found.GetNumberOfComponents()
    return [found.GetRange(c) for c in range(-1 if components > 1 else 0, components)]


def differing(one, other, by=2):
    """How many pixels are more than that apart."""
    return int((np.abs(one - other).max(2) > by).sum())


def require_same(one, other, by=2, pixels=0):
    assert one.shape == other.shape
    count = differing(one, other, by)
    assert count <= pixels, (count, int(np.abs(one - other).max()))


def require_other(one, other):
    """That the pictures show different things."""
    count = differing(one, other, 10)
    assert count > 0.01 * SIZE * SIZE, count
