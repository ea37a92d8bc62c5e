# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Cameras that see a whole object."""

from vtkmodules.vtkRenderingCore import vtkCamera

from ._views import find_view


def make_camera(
    scene, defaults, aspect, *, azimuth, elevation, roll, zoom, direction, up, parallel
):
    """Returns a camera from which a scene just fits into the image, if the zoom is 1."""
    eye, up = find_view(azimuth, elevation, zoom, direction, up)
    camera = vtkCamera()
    camera.SetFocalPoint(0, 0, 0)
    camera.SetPosition(eye)
    camera.SetViewUp(up)
    camera.SetParallelProjection(bool(parallel))
    camera.Roll(roll)
    with scene.raising(defaults):
        defaults.FitCamera(camera, aspect)
    camera.Zoom(zoom)
    return camera
