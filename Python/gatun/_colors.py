# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Colors and opacities of values as numbers."""

import math

import numpy as np

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


def check_range(values, what):
    """Raises ValueError, with the name of what has the values, if they are no range."""
    low, high = map(float, values)
    if not (math.isfinite(low) and math.isfinite(high) and low <= high):
        raise ValueError(f"{what}: {low:g} to {high:g} is no finite range of values")
    return low, high


def widen(low, high):
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


def _sample(function, size):
    """Values at which a function of VTK has nodes, those between them included, and the nodes."""
    nodes = []
    for i in range(function.GetSize() if hasattr(function, "GetNodeValue") else 0):
        nodes.append([0.0] * size)
        function.GetNodeValue(i, nodes[-1])
    return np.union1d(np.linspace(*function.GetRange(), 4 * _NODES), [node[0] for node in nodes]), nodes


def list_colors(colors, low, high):
    """Rows of value, red, green and blue of colors over a range, which those of VTK have."""
    if hasattr(colors, "GetColor"):
        return np.array([[value, *colors.GetColor(value)] for value in _sample(colors, 6)[0]])
    if isinstance(colors, str) or callable(colors):
        colors = _call(colors)
    table = np.asarray(colors, float)
    if table.ndim != 2 or table.shape[1] not in (3, 4) or len(table) < 2:
        raise ValueError("colors: need two colors or more, of red, green and blue from 0 to 1")
    return np.column_stack([np.linspace(low, high, len(table)), table[:, :3]])


def list_opacities(opacity, low, high):
    """Rows of value and opacity of opacities over a range, which those of VTK have."""
    if hasattr(opacity, "GetNodeValue"):
        values, nodes = _sample(opacity, 4)
        if all(node[2:] == [0.5, 0.0] for node in nodes):  # midpoint and sharpness of straight lines
            return np.array([node[:2] for node in nodes])
        return np.array([[value, opacity.GetValue(value)] for value in values])
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
    return nodes
