# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Arrays of whole meshes, from files."""

from __future__ import annotations

import ctypes

import numpy as np

from . import _library as _c
from ._description import make_key
from ._library import library


def _take_numbers(field):
    values = np.empty(field.count, _c.DTYPES[field.type])
    if values.nbytes:
        ctypes.memmove(values.ctypes.data, field.values, values.nbytes)
    return values


def _take_texts(field):
    texts = []
    for i in range(field.count):
        data = ctypes.string_at(field.texts[i], field.text_bytes[i])
        texts.append(data.decode("utf-8", "surrogateescape"))
    return texts


def _take_field(field):
    """The values of a field array: one for each tuple, or a row."""
    values = _take_numbers(field) if field.type else _take_texts(field)
    components = field.components
    if components <= 1 or len(values) % components:
        return values
    if field.type:
        return values.reshape(-1, components)
    return [values[i : i + components] for i in range(0, len(values), components)]


def read_fields(handle, step):
    """The field data of a step by name."""
    fields, count = ctypes.c_void_p(), ctypes.c_uint32()
    handle.get(library.gatun_get_fields, step, ctypes.byref(fields), ctypes.byref(count))
    try:
        found = {}
        for i in range(count.value):
            field = _c.Field()
            _c.check(library.gatun_get_field(fields, i, ctypes.byref(field)))
            found[make_key(_c.decode_text(field.name), i, found)] = _take_field(field)
        return found
    finally:
        library.gatun_free_fields(fields)
