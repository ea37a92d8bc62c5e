# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Arrays of whole meshes, from files and for them."""

from __future__ import annotations

import ctypes

import numpy as np

from . import _library as _c
from ._description import make_key
from ._library import library
from ._numbers import as_numbers

_VTK_STRING = 13


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


def take_values(field):
    """The numbers or texts of a field array, of all tuples and components."""
    return _take_numbers(field) if field.type else _take_texts(field)


def _take_field(field):
    """The values of a field array: one for each tuple, or a row."""
    values, components = take_values(field), field.components
    if components <= 1 or len(values) % components:
        return values
    if field.type:
        return values.reshape(-1, components)
    return [values[i : i + components] for i in range(0, len(values), components)]


def visit_fields(handle, step):
    """Yields the field arrays of a step, which are valid until the next one."""
    fields, count = ctypes.c_void_p(), ctypes.c_uint32()
    handle.get(library.gatun_get_fields, step, ctypes.byref(fields), ctypes.byref(count))
    try:
        for i in range(count.value):
            field = _c.Field()
            _c.check(library.gatun_get_field(fields, i, ctypes.byref(field)))
            yield field
    finally:
        library.gatun_free_fields(fields)


def read_fields(handle, step):
    """The field data of a step by name."""
    found = {}
    for i, field in enumerate(visit_fields(handle, step)):
        found[make_key(_c.decode_text(field.name), i, found)] = _take_field(field)
    return found


class Fields:
    """Field data for the library, with the memory that they refer to.

    Args:
        data: arrays of numbers, texts or lists of texts by name.
    """

    def __init__(self, data):
        self._kept = []
        made = [self._give(name, values) for name, values in (data or {}).items()]
        self.list = (_c.Field * len(made))(*made)

    def _give(self, name, values):
        what = f"field_data {name!r}"
        # NumPy drops zeros at the ends of texts.
        array = self._as_texts(values)
        if array is None:
            array = np.ascontiguousarray(np.atleast_1d(as_numbers(values, what)))
        components = int(np.prod(array.shape[1:], dtype=int))
        field = _c.Field(name=_c.encode_text(name, what), components=components, count=array.size)
        if array.dtype.kind in "OU":
            texts = [str(text).encode("utf-8", "surrogateescape") for text in array.flat]
            buffers = [ctypes.create_string_buffer(text) for text in texts]
            field.vtk_type = _VTK_STRING
            field.texts = (ctypes.c_void_p * len(texts))(*map(ctypes.addressof, buffers))
            field.text_bytes = (ctypes.c_uint64 * len(texts))(*map(len, texts))
            self._kept += [buffers, field.texts, field.text_bytes]
        else:
            field.type = _c.TYPES[array.dtype.name]
            field.values = array.ctypes.data
            self._kept.append(array)
        return field

    @staticmethod
    def _as_texts(values):
        """Texts, or lists of them, as an array of objects; None if it is something else."""
        if isinstance(values, str):
            values = [values]
        if not isinstance(values, (list, tuple)):
            return None
        flat = [text for row in values for text in (row if isinstance(row, (list, tuple)) else [row])]
        if not flat or not all(isinstance(text, str) for text in flat):
            return None
        return np.array(values, dtype=object)
