# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Descriptions as in gatunGolden of what gtn_decoder makes of a file."""

import gatunGolden as golden
import numpy as np
from gtn_container import POINTS, SIZES
from gtn_decoder import Decoder

WHERE = ("points", "cells")


def describe(array):
    return golden.describe_array(
        array.name, array.vtk_type, array.components, list(array.component_names))


def describe_field_array(array):
    result = describe(array)
    if array.type == 0:
        result["sha256"] = golden.sha256_of_texts(array.values)
    else:
        result["sha256"] = golden.sha256(np.frombuffer(array.values, np.uint8))
    assert array.type == 0 or len(array.values) % (SIZES[array.type] * array.components) == 0
    return result


def hashes(decoder, order, restore):
    """order: numbers of the arrays, those of points first."""
    points = decoder.points(restore)
    return {
        "points_type": points.dtype.name if len(points) else None,
        "points": golden.sha256(points) if len(points) else None,
        "tets": golden.sha256(decoder.tets(restore)),
        "arrays": [
            [golden.sha256(decoder.array(step, i, restore)) for i in order]
            for step in range(max(1, len(decoder.steps)))
        ],
    }


def describe_decoded(data):
    decoder = Decoder(data)
    decoder.container.verify_layout()
    meta = decoder.meta
    order = sorted(range(len(meta.arrays)), key=lambda i: meta.arrays[i].where)
    roles = {where: {} for where in WHERE}
    for role in range(32):
        for array in meta.arrays:
            if array.roles >> role & 1:
                roles[WHERE[array.where]][str(role)] = array.name
    return {
        "times": [step.time for step in decoder.steps] if meta.has_time else [],
        "wide_ids": meta.wide_ids != 0 if meta.tets else None,
        "arrays": [
            dict(describe(meta.arrays[i]), where=WHERE[meta.arrays[i].where != POINTS])
            for i in order
        ],
        "roles": roles,
        "field_data": [
            [describe_field_array(array) for array in decoder.field_data(step)]
            for step in range(len(decoder.steps))
        ],
        "file_order": hashes(decoder, order, False),
        "input_order": hashes(decoder, order, True),
    }
