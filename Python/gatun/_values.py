# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Arrays of VTK from values of NumPy, and back."""

from __future__ import annotations

import numpy as np
from vtkmodules.util.numpy_support import get_vtk_array_type, vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_BIT, VTK_UNSIGNED_CHAR, vtkDataArray, vtkStringArray

from ._numbers import as_numbers


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
    array = as_numbers(values, what)
    if array.dtype.kind == "U":
        result = _to_texts(array, what)
    else:
        result = vtkDataArray.CreateDataArray(get_vtk_array_type(array.dtype))
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
