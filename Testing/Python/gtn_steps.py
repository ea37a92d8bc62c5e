# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Sections STEP of `.gtn` files, and field data: sections 3.4 and 3.5 of Documentation/format.md.

Part of gtn_decoder, which is written from that text alone.
"""

import math
from types import SimpleNamespace as Record

from gtn_bytes import COPY, SCALES, SIZES, require
from gtn_tables import POINTS, read_keys


def read_step(table, meta, layout, open_page):
    """A section STEP and its pages (3.4)."""
    step = Record(time=table.number("d"), key=table.number("B") != 0)
    require(not math.isnan(step.time), "time")
    step.field_data = table.reference()
    moves = table.number("B") if meta.points_move else 0
    require(moves <= 1, "motion of a step")
    step.moves = moves == 1
    step.arrays = []
    arrays = meta.all_arrays if step.moves else meta.arrays
    for array in arrays:
        values = Record(domains=[table.domain() for _ in range(array.components)])
        values.ranges = table.ranges(array.components + (array.components > 1))
        values.unused = table.reference()
        values.chunks, values.chunk_ranges, values.blocks = [], [], []
        step.arrays.append(values)
    check_copies(meta.arrays, step.arrays)
    for values in step.arrays[len(meta.arrays):]:
        require(all(d is None or d.kind in SCALES for d in values.domains), "domain of points")
    pages = [table.reference() for _ in layout.pages] if arrays else []
    table.end()
    for reference, place in zip(pages, layout.pages):
        page = open_page(reference)
        for array, values in zip(arrays, step.arrays):
            for _ in range(place.chunks):
                values.chunk_ranges.append(page.ranges(array.components + (array.components > 1)))
                values.chunks.append(page.reference())
            if array.where == POINTS:
                values.blocks += [page.reference() for _ in range(place.blocks)]
        page.end()
    return step


def is_copy(values):
    return values.domains[0] is not None and values.domains[0].kind == COPY


def check_copies(arrays, steps):
    """Copies of arrays at a step (3.1)."""
    for array, values in zip(arrays, steps):
        copies = [d for d in values.domains if d is not None and d.kind == COPY]
        if not copies:
            continue
        require(len(copies) == array.components, "components that are copies and others")
        source = copies[0].array
        require(all(d.array == source for d in copies), "copies of several arrays")
        require(source < len(arrays) and not is_copy(steps[source]), "source of a copy")
        other = arrays[source]
        require((other.where, other.type) == (array.where, array.type), "kind of a copy")
        require(all(d.component < other.components for d in copies), "component of a copy")


def read_field_array(table):
    """An array of the field data (3.5): values are bytes, or a list of texts (bytes as well)."""
    array = Record(name=table.string(), vtk_type=table.number("i"), components=table.varint())
    array.component_names = [table.string() for _ in range(table.varint())]
    mark = table.number("B")
    array.type = mark & 127
    array.keys = read_keys(table) if mark & 128 else []
    require(array.components < 1 << 31, "components of field data")
    if array.type == 0:
        array.values = [table.raw_string() for _ in range(table.varint())]
    else:
        require(array.type in SIZES, "type of field data")
        length = table.varint()
        require(length % SIZES[array.type] == 0, "bytes of field data")
        array.values = table.take(length)
    return array
