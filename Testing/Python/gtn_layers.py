# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Layers of values in `.gtn` files: section 14 of Documentation/format.md.

Part of gtn_decoder, which is written from that text alone.
"""

import math

from gtn_container import require


def layer_of(layers, value):
    """The number of the layer that a value is in (14.1)."""
    return sum(bound <= value for bound in layers.bounds)


def check_layers(decoder):
    """Whether chunks have values of just the layers that they should have (14.2), and base meshes
    as well. Values are those that were decoded, not the ranges in the tables."""
    layers = decoder.container.layers
    if layers is not None and decoder.steps:
        values = decoder.array(0, layers.array)
        for c, chunk in enumerate(decoder.chunks):
            first = decoder.first_own[c]
            points = [*chunk.shared_points, *range(first, first + len(chunk.own))]
            numbers = [number_of(layers, values[point]) for point in points]
            numbers = [number for number in numbers if not math.isnan(number)]
            if numbers:
                span = layer_of(layers, min(numbers)), layer_of(layers, max(numbers))
                require(span == layers.chunks[c], "values outside of the layers of their chunk")
    if decoder.container.tree is not None:
        for i in range(len(decoder.container.tree.levels)):
            check_layers(decoder.level(i))


def number_of(layers, row):
    """A component, or the length of a tuple (3.1)."""
    if layers.component < len(row):
        return float(row[layers.component])
    total = 0.0
    for x in row:
        total += float(x) * float(x)
    return math.sqrt(total)
