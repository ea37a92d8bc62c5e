# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Colors and opacities of values."""

import math

import numpy as np
from vtkmodules.vtkCommonCore import vtkScalarsToColors
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkVolumeProperty

from ._classes import get_class
from ._colors import check_range, list_colors, list_opacities, widen


def _make_colors(colors, low, high):
    """Returns a color function over a range."""
    if isinstance(colors, vtkScalarsToColors):
        return colors
    function = vtkColorTransferFunction()
    if colors is None:
        get_class("vtkGatunDefaults").MakeColors(low, high, function)
        return function
    for value, red, green, blue in list_colors(colors, low, high):
        function.AddRGBPoint(value, red, green, blue)
    return function


def _make_opacity(opacity, low, high):
    """Returns an opacity function over a range."""
    if isinstance(opacity, vtkPiecewiseFunction):
        return opacity
    function = vtkPiecewiseFunction()
    function.AllowDuplicateScalarsOn()
    for value, o in list_opacities(opacity, low, high):
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
        values = widen(*(values or _get_values(scene)))
        get_class("vtkGatunDefaults").MakeRamp(*values, made)
    else:
        if values:
            defaults.SetRange(widen(*values))
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
    return check_range(scene.values, f"{scene.name}, array {scene.array!r}")


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
        values = check_range(values, "range")
    elif scene.time is not None:
        values = _get_values(scene)  # of all steps, so that images of a series have one scale
    if isinstance(opacity, (int, float, np.number)):
        if defaults:
            defaults.SetUnitDistance(unit_distance)
        opacity, values = _make_default_opacity(scene, defaults, float(opacity), values)
    else:
        values = widen(*(values or _get_values(scene)))
    made = vtkVolumeProperty()
    made.SetColor(_make_colors(colors, *values))
    made.SetScalarOpacity(_make_opacity(opacity, *values))
    made.SetScalarOpacityUnitDistance(unit_distance)
    return made
