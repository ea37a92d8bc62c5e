# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Directions of cameras."""

import math


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


def find_view(azimuth, elevation, zoom, direction, up):
    """The direction to the eye and the direction up, of parameters of ``render``."""
    if direction is None:
        if up is not None:
            raise ValueError("up: needs a direction")
        eye, up = _turn(azimuth, elevation)
    else:
        eye, up = _look_along(tuple(map(float, direction)), up)
    if not 0 < zoom < math.inf:
        raise ValueError(f"zoom: {zoom} is not above 0")
    return eye, up


def roll_up(eye, up, angle):
    """The direction up after a turn about the direction of the view, as vtkCamera::Roll makes it."""
    length = math.hypot(*eye)
    x, y, z = (-value / length for value in eye)
    sine, cosine = math.sin(math.radians(angle)), math.cos(math.radians(angle))
    along = (x * up[0] + y * up[1] + z * up[2]) * (1 - cosine)
    across = (y * up[2] - z * up[1], z * up[0] - x * up[2], x * up[1] - y * up[0])
    return tuple(u * cosine + c * sine + a * along for u, c, a in zip(up, across, (x, y, z)))
