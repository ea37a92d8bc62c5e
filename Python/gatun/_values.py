# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Arrays of VTK from values of NumPy, and back."""

from __future__ import annotations

import numpy as np
from vtkmodules.util.numpy_support import get_vtk_array_type, vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_BIT, vtkDataArray, vtkStringArray, vtkUnsignedCharArray

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


def get_values(array):
    """The numbers of an array, in its memory if its tuples lie in it one by one."""
    if array.GetDataType() == VTK_BIT:
        values = vtkUnsignedCharArray()
        values.DeepCopy(array)
    elif array.HasStandardMemoryLayout():
        values = array
    else:
        values = vtkDataArray.CreateDataArray(array.GetDataType())
        values.SetNumberOfComponents(array.GetNumberOfComponents())
        values.SetNumberOfTuples(array.GetNumberOfTuples())
        if array.GetNumberOfValues() == 1:
            # VTK 9.6 does not export a single value of an implicit array.
            values.SetTuple(0, 0, array)
        elif array.GetNumberOfValues() > 0:
            array.ExportToVoidPointer(vtk_to_numpy(values))  # no DeepCopy, which may go through doubles
    return vtk_to_numpy(values)


def get_types(grid):
    """The types of the cells. From VTK 9.6 on they need not be an array of bytes."""
    try:
        types = grid.GetCellTypes()
    except TypeError:  # with VTK 9.5 and before, this has a parameter
        types = grid.GetCellTypesArray()
    return np.empty(0, np.uint8) if types is None else get_values(types)


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
    values = get_values(array)
    is_shared = array.GetDataType() != VTK_BIT and array.HasStandardMemoryLayout()
    return values.copy() if copy and is_shared else values
