# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Colors and opacities of values."""

import math

import numpy as np
from vtkmodules.vtkCommonCore import vtkScalarsToColors
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkVolumeProperty

_NODES = 64  # of a function that is sampled

# From dark to light, for all kinds of color vision: place, red, green, blue.
_COLORS = (
    (0, 0.30, 0.10, 0.45),
    (0.3, 0.23, 0.36, 0.60),
    (0.6, 0.13, 0.62, 0.54),
    (0.85, 0.60, 0.83, 0.25),
    (1, 0.99, 0.91, 0.20),
)
_OPACITIES = ((0, 0.01), (0.3, 0.06), (1, 0.45))


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


def check_range(values, what):
    """Returns the smallest and the largest value to map; a lone value gets the middle.

    Raises ValueError, with the name of what has the values, if they are no range.
    """
    low, high = map(float, values)
    if not (math.isfinite(low) and math.isfinite(high) and low <= high):
        raise ValueError(f"{what}: {low:g} to {high:g} is no finite range of values")
    if low == high:
        margin = max(0.5, abs(low) / 100)
        low, high = low - margin, high + margin
    return low, high


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


def make_colors(colors, low, high):
    """Returns a color function over a range."""
    if isinstance(colors, vtkScalarsToColors):
        return colors
    function = vtkColorTransferFunction()
    if colors is None:
        function.SetColorSpaceToLab()
        nodes = _COLORS
    else:
        if isinstance(colors, str) or callable(colors):
            colors = _call(colors)
        table = np.asarray(colors, float)
        if table.ndim != 2 or table.shape[1] not in (3, 4) or len(table) < 2:
            raise ValueError("colors: need two colors or more, of red, green and blue from 0 to 1")
        nodes = np.column_stack([np.linspace(0, 1, len(table)), table[:, :3]])
    for place, red, green, blue in nodes:
        function.AddRGBPoint(low * (1 - place) + high * place, red, green, blue)
    return function


def make_opacity(opacity, low, high):
    """Returns an opacity function over a range."""
    if isinstance(opacity, vtkPiecewiseFunction):
        return opacity
    if callable(opacity):
        opacity = [opacity(value) for value in np.linspace(low, high, _NODES)]
    given = np.asarray(opacity, float)
    if given.ndim == 0:
        nodes = [(low * (1 - x) + high * x, min(o * float(given), 1)) for x, o in _OPACITIES]
    elif given.ndim == 1 and len(given) > 0:
        nodes = np.column_stack([np.linspace(low, high, len(given)), given])
    elif given.ndim == 2 and given.shape[1] == 2 and len(given) > 0:
        nodes = given
    else:
        raise ValueError("opacity: is a factor, a list of opacities, or one of values and opacities")
    if not all(0 <= o <= 1 for _, o in nodes):
        raise ValueError("opacity: opacities are from 0 to 1, and factors 0 or more")
    function = vtkPiecewiseFunction()
    function.AllowDuplicateScalarsOn()
    for value, o in nodes:
        function.AddPoint(value, o)
    return function


def make_property(colors, opacity, values, unit_distance):
    """Returns a vtkVolumeProperty; the opacities are those of a length of unit_distance."""
    if not 0 < unit_distance < math.inf:
        raise ValueError(f"unit_distance: {unit_distance} is not above 0")
    made = vtkVolumeProperty()
    made.SetColor(make_colors(colors, *values))
    made.SetScalarOpacity(make_opacity(opacity, *values))
    made.SetScalarOpacityUnitDistance(unit_distance)
    return made
