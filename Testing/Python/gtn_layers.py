# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Layers of values in `.gtn` files: section 14 of Documentation/format.md.

Part of gtn_decoder, which is written from that text alone.
"""

import math
from types import SimpleNamespace as Record

from gtn_bytes import require
from gtn_tables import POINTS

MAX_LAYERS = 4096


def read_layers(table, meta, layout):
    """A section LAYR (14.1)."""
    layers = Record(array=table.varint(), component=table.varint(), spacing=table.number("B"))
    require(layers.array < len(meta.arrays), "array of the layers")
    array = meta.arrays[layers.array]
    require(array.where == POINTS, "layers of an array on cells")
    require(layers.component < array.components + (array.components > 1), "component of the layers")
    layers.count = table.varint()
    require(1 <= layers.count <= MAX_LAYERS, "number of layers")
    layers.bounds = [table.number("d") for _ in range(layers.count - 1)]
    require(all(map(math.isfinite, layers.bounds)), "bound of a layer")
    require(all(a < b for a, b in zip(layers.bounds, layers.bounds[1:])), "order of bounds")
    layers.chunks = [(table.varint(), table.varint()) for _ in layout.chunks]
    require(all(first <= last < layers.count for first, last in layers.chunks), "layers of a chunk")
    table.end()
    return layers


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
