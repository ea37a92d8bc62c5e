# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Arrays of numbers and texts in the types that meshes have."""

from __future__ import annotations

import numpy as np

from ._warnings import warn

# What to do with types of numbers that VTK does not have, by their kind in NumPy.
_REMEDIES = {
    "c": "give the real and the imaginary part as two arrays",
    "f": "convert it with astype('float64')",
    "m": "convert it with astype('int64')",
    "M": "convert it with astype('int64')",
    "S": "decode it with numpy.char.decode",
    "V": "give each of its fields as an array",
}


def fill_masked(values, what):
    """Values as an array without a mask, which no array of VTK has.

    Args:
        values: the values.
        what: they are, for messages.
    """
    if isinstance(values, (list, tuple)) and any(map(np.ma.is_masked, values)):
        values = np.ma.stack(values)
    if not isinstance(values, np.ma.MaskedArray):
        return np.asarray(values)
    masked = np.ma.count_masked(values)
    if not masked:
        return values.data
    if values.dtype.kind != "f":
        raise ValueError(
            f"{what}: has {masked} masked values, and {values.dtype} has no NaN for them; use filled()"
        )
    warn(f"{what}: {masked} masked values become NaN")
    return values.filled(np.nan)


def as_numbers(values, what):
    """Values as an array of numbers or texts, of a type that a file can have.

    Args:
        values: the values.
        what: they are, for messages.
    """
    array = fill_masked(values, what)
    if array.dtype.kind == "O" and array.size and all(isinstance(v, str) for v in array.flat):
        array = array.astype(str)
    if array.dtype == np.float16:
        array = array.astype(np.float32)
    if 0 in array.shape[1:]:
        raise ValueError(f"{what}: has no values in a row")
    kind = np.dtype(np.uint8) if array.dtype == bool else array.dtype.newbyteorder("=")
    if kind.kind == "U":
        return array
    if kind.kind not in "iuf" or kind.itemsize > 8:
        remedy = _REMEDIES.get(kind.kind, "convert it to numbers or texts")
        raise ValueError(f"{what}: arrays of type {array.dtype} are not supported; {remedy}")
    return array.astype(kind, copy=False)


def check_box(box):
    """A box as six numbers."""
    box = tuple(map(float, box))
    if len(box) != 6:
        raise ValueError("box: has to be xmin, xmax, ymin, ymax, zmin, zmax")
    if not all(low <= high for low, high in zip(box[::2], box[1::2])):
        raise ValueError(f"box: {box} has a minimum above its maximum")
    return box
