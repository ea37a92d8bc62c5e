# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Colors and opacities of values."""

import math

import numpy as np
from vtkmodules.vtkCommonCore import vtkScalarsToColors
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkVolumeProperty

from ._classes import get_class

_NODES = 64  # of a function that is sampled


def parse_color(color):
    """Returns red, green and blue from 0 to 1 of a color such as "white", "#202830" or numbers."""
    if isinstance(color, str):
        digits = {"black": "#000000", "white": "#ffffff"}.get(color, color)
        try:
            if len(digits) != 7 or digits[0] != "#":
                raise ValueError
            return tuple(int(digits[i : i + 2], 16) / 255 for i in (1, 3, 5))
        except ValueError:
            raise ValueError(f"background: {color!r} is not #RRGGBB, black or white") from None
    color = tuple(map(float, color))
    if len(color) != 3 or not all(0 <= x <= 1 for x in color):
        raise ValueError(f"background: {color} is not red, green and blue, 0 to 1 each")
    return color


def _check_range(values, what):
    """Raises ValueError, with the name of what has the values, if they are no range."""
    low, high = map(float, values)
    if not (math.isfinite(low) and math.isfinite(high) and low <= high):
        raise ValueError(f"{what}: {low:g} to {high:g} is no finite range of values")
    return low, high


def _widen(low, high):
    """The values to map; a lone value gets the middle."""
    margin = max(0.5, abs(low) / 100) if low == high else 0
    return low - margin, high + margin


def _call(colors):
    """The colors of a color map of Matplotlib, which is a function of 0 to 1."""
    if isinstance(colors, str):
        try:
            from matplotlib import colormaps
        except ImportError:
            raise ValueError(
                f"colors: {colors!r} is a color map of Matplotlib, which is not installed"
            ) from None
        if colors not in colormaps:
            raise ValueError(f"colors: Matplotlib has no color map {colors!r}")
        colors = colormaps[colors]
    return [colors(float(x)) for x in np.linspace(0, 1, _NODES)]


def _make_colors(colors, low, high):
    """Returns a color function over a range."""
    if isinstance(colors, vtkScalarsToColors):
        return colors
    function = vtkColorTransferFunction()
    if colors is None:
        get_class("vtkGatunDefaults").MakeColors(low, high, function)
        return function
    if isinstance(colors, str) or callable(colors):
        colors = _call(colors)
    table = np.asarray(colors, float)
    if table.ndim != 2 or table.shape[1] not in (3, 4) or len(table) < 2:
        raise ValueError("colors: need two colors or more, of red, green and blue from 0 to 1")
    for value, (red, green, blue) in zip(np.linspace(low, high, len(table)), table[:, :3]):
        function.AddRGBPoint(value, red, green, blue)
    return function


def _make_opacity(opacity, low, high):
    """Returns an opacity function over a range."""
    if isinstance(opacity, vtkPiecewiseFunction):
        return opacity
    if callable(opacity):
        opacity = [opacity(value) for value in np.linspace(low, high, _NODES)]
    given = np.asarray(opacity, float)
    if given.ndim == 1 and len(given) > 0:
        nodes = np.column_stack([np.linspace(low, high, len(given)), given])
    elif given.ndim == 2 and given.shape[1] == 2 and len(given) > 0:
        nodes = given
    else:
        raise ValueError("opacity: is a factor, a list of opacities, or one of values and opacities")
    if not all(0 <= o <= 1 for _, o in nodes):
        raise ValueError("opacity: opacities are from 0 to 1")
    function = vtkPiecewiseFunction()
    function.AllowDuplicateScalarsOn()
    for value, o in nodes:
        function.AddPoint(value, o)
    return function


def _make_default_opacity(scene, defaults, factor, values):
    """Returns the default opacities times a factor, and the range that they are for.

    Without defaults they are a ramp. Values: the range to use, or None.
    """
    if not 0 <= factor < math.inf:
        raise ValueError(f"opacity: a factor is 0 or more, not {factor}")
    made = vtkPiecewiseFunction()
    if defaults is None:
        values = _widen(*(values or _get_values(scene)))
        get_class("vtkGatunDefaults").MakeRamp(*values, made)
    else:
        if values:
            defaults.SetRange(_widen(*values))
        else:
            _get_values(scene)  # or an error
        with scene.raising(defaults):
            defaults.MakeFunctions(None, made)
        values = made.GetRange()
    node = [0.0] * 4  # value, opacity, midpoint, sharpness
    for i in range(made.GetSize()):
        made.GetNodeValue(i, node)
        node[1] = min(node[1] * factor, 1.0)
        made.SetNodeValue(i, node)
    return made, values


def _get_values(scene):
    return _check_range(scene.values, f"{scene.name}, array {scene.array!r}")


def make_property(scene, defaults, colors, opacity, values, unit_distance):
    """Returns a vtkVolumeProperty.

    Args:
        scene: what is drawn.
        defaults: of the scene, or None if lengths of rays do not matter.
        colors, opacity: as of ``render``.
        values: the range to map, or None.
        unit_distance: the length of which the opacities are.
    """
    if not 0 < unit_distance < math.inf:
        raise ValueError(f"unit_distance: {unit_distance} is not above 0")
    if values is not None:
        values = _check_range(values, "range")
    elif scene.time is not None:
        values = _get_values(scene)  # of all steps, so that images of a series have one scale
    if isinstance(opacity, (int, float, np.number)):
        if defaults:
            defaults.SetUnitDistance(unit_distance)
        opacity, values = _make_default_opacity(scene, defaults, float(opacity), values)
    else:
        values = _widen(*(values or _get_values(scene)))
    made = vtkVolumeProperty()
    made.SetColor(_make_colors(colors, *values))
    made.SetScalarOpacity(_make_opacity(opacity, *values))
    made.SetScalarOpacityUnitDistance(unit_distance)
    return made
