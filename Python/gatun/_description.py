# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""What a file of a mesh holds."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np

from . import _library as _c

#: Kinds of keys whose numbers are the bits of doubles.
KINDS_OF_DOUBLES = (2, 7, 9)


@dataclasses.dataclass(frozen=True)
class Array:
    """An array of a file.

    Attributes:
        name: as it is in the file.
        key: the name in the dictionaries of a ``Grid``, which does not repeat.
        is_cell: whether its values are of cells.
        dtype: of its values.
        components: the number of values of a point or cell.
        component_names: their names, which may be empty.
        roles: bit i is set for the active attribute i of vtkDataSetAttributes.
        vtk_type: its type in VTK, or 0.
        keys: information keys of VTK, as tuples of location, name, kind and values.
    """

    name: str
    key: str
    is_cell: bool
    dtype: np.dtype
    components: int
    component_names: tuple[str, ...] = ()
    roles: int = 0
    vtk_type: int = 0
    keys: tuple[tuple[str, str, int, tuple[Any, ...]], ...] = ()


@dataclasses.dataclass(frozen=True)
class Step:
    """A time step: its time (or None), the number of its mesh, its points, cells and bounds."""

    time: float | None
    mesh: int
    points: int
    cells: int
    bounds: tuple[float, ...]


@dataclasses.dataclass(frozen=True)
class Level:
    """A coarser mesh in a file: the numbers of its points and cells."""

    points: int
    cells: int


def decode_texts(texts, count):
    """A list of texts of the library as a tuple."""
    return tuple(_c.decode_text(texts[i]) for i in range(count)) if texts else ()


def decode_keys(keys, count):
    """Keys of the library as tuples of location, name, kind and values."""
    found = []
    for key in (keys[i] for i in range(count)):
        if key.texts or not key.numbers:
            values = decode_texts(key.texts, key.count)
        else:
            # The bits of doubles, or else of integers.
            bits = np.array(key.numbers[: key.count], np.uint64)
            values = tuple(bits.view(np.float64 if key.kind in KINDS_OF_DOUBLES else np.int64).tolist())
        found.append((_c.decode_text(key.location), _c.decode_text(key.name), key.kind, values))
    return tuple(found)


def decode_array(array, key):
    return Array(
        _c.decode_text(array.name),
        key,
        bool(array.is_cell),
        np.dtype(_c.DTYPES[array.type]),
        array.components,
        decode_texts(array.component_names, array.components),
        array.roles,
        array.vtk_type,
        decode_keys(array.keys, array.key_count),
    )


def make_key(name, number, taken):
    """A key for an array: its name, unless that is empty or taken."""
    plain = name or f"array {number}"
    key, count = plain, 1
    while key in taken:
        count += 1
        key = f"{plain} ({count})"
    return key
