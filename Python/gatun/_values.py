# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Arrays of VTK from values of NumPy, and back."""

from __future__ import annotations

import numpy as np
from vtkmodules.util.numpy_support import get_vtk_array_type, vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_BIT, VTK_UNSIGNED_CHAR, vtkDataArray, vtkStringArray

from ._errors import warn

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


def _to_texts(array, what):
    result = vtkStringArray()
    result.SetNumberOfComponents(int(np.prod(array.shape[1:])))
    result.SetNumberOfTuples(len(array))
    for i, text in enumerate(array.ravel()):
        if "\0" in text:
            raise ValueError(f"{what}: text {i} has a zero, at which VTK ends it")
        result.SetValue(i, str(text))
    return result


def to_vtk(values, name, what):
    """A VTK array with a copy of the values.

    VTK allocates the memory: arrays of VTK share theirs with shallow copies, which would outlive an
    array of NumPy.
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
        result = _to_texts(array, what)
    elif kind.kind not in "iuf" or kind.itemsize > 8:
        remedy = _REMEDIES.get(kind.kind, "convert it to numbers or texts")
        raise ValueError(f"{what}: arrays of type {array.dtype} are not supported; {remedy}")
    else:
        result = vtkDataArray.CreateDataArray(get_vtk_array_type(kind))
        result.SetNumberOfComponents(int(np.prod(array.shape[1:])))
        result.SetNumberOfTuples(len(array))
        if array.size:
            vtk_to_numpy(result).reshape(array.shape)[...] = array
    result.SetName(name)
    return result


def to_numpy(array, copy=True):
    """The numbers or texts of an array of VTK.

    Args:
        array: the array.
        copy: whether the values are copied. Otherwise they share the memory of the array where they
            can, which ends when the array is resized.
    """
    if not isinstance(array, vtkDataArray):
        count = array.GetNumberOfValues()
        texts = np.array([array.GetVariantValue(i).ToString() for i in range(count)], str)
        components = array.GetNumberOfComponents()
        return texts.reshape(-1, components) if components > 1 else texts
    is_bits = array.GetDataType() == VTK_BIT
    if is_bits or not array.HasStandardMemoryLayout():
        own = vtkDataArray.CreateDataArray(VTK_UNSIGNED_CHAR if is_bits else array.GetDataType())
        own.DeepCopy(array)
        return vtk_to_numpy(own)
    values = vtk_to_numpy(array)
    return values.copy() if copy else values
