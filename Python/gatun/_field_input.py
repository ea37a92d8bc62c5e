# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Arrays of whole meshes, for files."""

from __future__ import annotations

import collections.abc
import ctypes

import numpy as np

from . import _library as _c
from ._description import Array
from ._meshes import describe
from ._numbers import as_numbers

_VTK_STRING = 13


class Fields:
    """Field data for the library, with the memory that they refer to.

    Args:
        data: arrays of numbers, texts or lists of texts by name; or pairs of a description and values, where
            texts are of dtype object and may be bytes.
    """

    def __init__(self, data):
        self._kept = []
        if data is None or isinstance(data, collections.abc.Mapping):
            data = [self._describe(name, values) for name, values in (data or {}).items()]
        made = [self._give(array, values) for array, values in data]
        self.list = (_c.Field * len(made))(*made)

    def _describe(self, name, values):
        # NumPy drops zeros at the ends of texts.
        array = self._as_texts(values)
        if array is None:
            array = np.ascontiguousarray(np.atleast_1d(as_numbers(values, f"field_data {name!r}")))
        is_text = array.dtype.kind in "OU"
        components = int(np.prod(array.shape[1:], dtype=int))
        dtype = np.dtype(object) if is_text else array.dtype
        described = Array(name, name, False, dtype, components, vtk_type=_VTK_STRING if is_text else 0)
        return described, list(array.flat) if is_text else array

    def _give(self, array, values):
        own = describe(array)
        field = _c.Field(
            name=own.structure.name,
            components=array.components,
            vtk_type=array.vtk_type,
            component_names=own.structure.component_names,
            keys=own.structure.keys,
            key_count=own.structure.key_count,
        )
        self._kept.append(own)
        if array.dtype.kind == "O":
            texts = [
                text if isinstance(text, bytes) else str(text).encode("utf-8", "surrogateescape")
                for text in values
            ]
            buffers = [ctypes.create_string_buffer(text) for text in texts]
            field.count = len(texts)
            field.texts = (ctypes.c_void_p * len(texts))(*map(ctypes.addressof, buffers))
            field.text_bytes = (ctypes.c_uint64 * len(texts))(*map(len, texts))
            self._kept += [buffers, field.texts, field.text_bytes]
        else:
            values = np.ascontiguousarray(values)
            field.type = _c.TYPES[array.dtype.name]
            field.count = values.size
            field.values = values.ctypes.data
            self._kept.append(values)
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
