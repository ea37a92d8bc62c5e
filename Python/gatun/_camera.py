# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Cameras that see a whole object."""

import math

from vtkmodules.vtkRenderingCore import vtkCamera


def _turn(azimuth, elevation):
    """The direction to the eye and the direction up, from angles in degrees."""
    a, e = math.radians(azimuth), math.radians(elevation)
    eye = (math.sin(a) * math.cos(e), math.sin(e), math.cos(a) * math.cos(e))
    up = (-math.sin(a) * math.sin(e), math.cos(e), -math.cos(a) * math.sin(e))
    return eye, up


def _look_along(direction, up):
    length = math.hypot(*direction)
    if not 0 < length < math.inf:
        raise ValueError(f"direction: {tuple(direction)} is no direction")
    eye = tuple(-x / length for x in direction)
    if up is None:
        # z, where one looks along y.
        up = (0.0, 1.0, 0.0) if abs(eye[1]) < 0.999 else (0.0, 0.0, 1.0)
    across = (
        eye[1] * up[2] - eye[2] * up[1],
        eye[2] * up[0] - eye[0] * up[2],
        eye[0] * up[1] - eye[1] * up[0],
    )
    if not math.hypot(*across) > 1e-6 * math.hypot(*up) > 0:
        raise ValueError(f"up: {tuple(up)} has no direction across the view")
    return eye, up


def make_camera(
    scene, defaults, aspect, *, azimuth, elevation, roll, zoom, direction, up, parallel
):
    """Returns a camera from which a scene just fits into the image, if the zoom is 1."""
    if direction is None:
        if up is not None:
            raise ValueError("up: needs a direction")
        eye, up = _turn(azimuth, elevation)
    else:
        eye, up = _look_along(tuple(map(float, direction)), up)
    if not 0 < zoom < math.inf:
        raise ValueError(f"zoom: {zoom} is not above 0")
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
