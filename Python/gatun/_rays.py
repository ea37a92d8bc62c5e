# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Images of meshes by the library."""

import ctypes
import math

import numpy as np

from . import _library as _c
from ._colors import check_range, list_colors, list_opacities, widen
from ._library import library
from ._piece import to_buffer
from ._pixels import check_size
from ._views import find_view, roll_up

_MODES = {"composite": 0, "mip": 2, "xray": 3}


def _set_camera(image, *, azimuth, elevation, roll, zoom, direction, up, parallel, camera):
    if camera is not None:
        image.position[:] = camera.GetPosition()
        image.focal_point[:] = camera.GetFocalPoint()
        image.view_up[:] = camera.GetViewUp()
        image.view_angle = camera.GetViewAngle()
        image.parallel_scale = camera.GetParallelScale() if camera.GetParallelProjection() else 0.0
        return
    eye, up = find_view(azimuth, elevation, zoom, direction, up)
    image.direction[:] = [-x for x in eye]
    image.view_up[:] = roll_up(eye, up, roll)
    image.zoom = zoom
    image.parallel_scale = 1.0 if parallel else 0.0  # of which the library makes what fits


def _set_rows(image, member, rows):
    """Makes rows of numbers a transfer function. Returns what has to be kept."""
    table = np.ascontiguousarray(rows, float)
    table = table[np.argsort(table[:, 0], kind="stable")]
    plural = {"color": "colors", "opacity": "opacities"}[member]
    setattr(image, plural, table.ctypes.data_as(ctypes.POINTER(ctypes.c_double)))
    setattr(image, member + "_count", len(table))
    return table


def _take_factor(image, opacity):
    """Sets the factor of the default opacities if it is one. Returns opacities in place of the default, or
    None."""
    if not isinstance(opacity, (int, float, np.number)):
        return opacity
    if not 0 <= opacity < math.inf:
        raise ValueError(f"opacity: a factor is 0 or more, not {opacity}")
    image.opacity_scale = opacity
    return None if opacity else [0.0]  # 0 stands for the default there


def draw_mesh(file, handle, size, what, view, transfer, progress):
    """Draws a mesh. Returns height x width x 4 floats, the top row first.

    Args:
        file: the File.
        handle: its handle.
        size: width and height.
        what: numbers of array, component and step, ratio and level.
        view: parameters of the camera.
        transfer: colors, opacity, range, blend, unit_distance and shade, as of ``File.render``.
        progress: as for ``File.read``.
    """
    width, height = check_size(size)
    number, component, step, ratio, level = what
    blend = transfer["blend"]
    if blend not in _MODES:
        raise ValueError(f"blend: {blend!r} is not known; there are {', '.join(map(repr, _MODES))}")
    image = _c.Image(width=width, height=height, step=step, array=number, component=component)
    image.ratio, image.level, image.blend = ratio, level, _MODES[blend]
    _set_camera(image, **view)
    distance = transfer["unit_distance"]
    if distance is not None:
        if not 0 < distance < math.inf:
            raise ValueError(f"unit_distance: {distance} is not above 0")
        image.unit_distance = distance
    image.shade = bool(transfer["shade"])
    kept = []
    colors, opacity = transfer["colors"], _take_factor(image, transfer["opacity"])
    values = transfer["range"]
    if values is not None:
        values = widen(*check_range(values, "range"))
    elif opacity is not None or file.has_time:  # images of a series have one scale
        values = widen(*check_range(file.find_range(number, component), f"array {file.arrays[number].key!r}"))
    if values is not None:
        image.range[:] = values
    if colors is not None:
        image.spread_colors = not hasattr(colors, "GetColor")  # those of VTK have values
        kept.append(_set_rows(image, "color", list_colors(colors, 0, 1)))
    if opacity is not None:
        kept.append(_set_rows(image, "opacity", list_opacities(opacity, *values)))
    pixels = np.empty((height, width, 4), np.float32)
    buffer = to_buffer(pixels)
    handle.call(library.gatun_render, ctypes.byref(image), ctypes.byref(buffer), progress=progress)
    del kept
    return pixels[::-1]
