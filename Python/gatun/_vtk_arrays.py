# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Arrays of VTK for what is in files.

VTK allocates their memory, which the library fills: arrays of VTK share theirs with shallow copies, which would
outlive an array of NumPy.
"""

import functools

import numpy as np
from vtkmodules import vtkCommonCore
from vtkmodules.vtkCommonCore import VTK_BIT, vtkDataArray, vtkStringArray, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkDataSetAttributes

from ._description import decode_field
from ._exceptions import Error
from ._fields import take_values
from ._piece import make_array
from ._vtk_keys import set_keys

_NUMERIC = (
    "CHAR SIGNED_CHAR UNSIGNED_CHAR SHORT UNSIGNED_SHORT INT UNSIGNED_INT LONG UNSIGNED_LONG LONG_LONG "
    "UNSIGNED_LONG_LONG ID_TYPE FLOAT DOUBLE"
)
_NUMERIC = {getattr(vtkCommonCore, "VTK_" + name) for name in _NUMERIC.split()}
_FLOATS = (vtkCommonCore.VTK_FLOAT, vtkCommonCore.VTK_DOUBLE)


@functools.lru_cache(maxsize=None)
def _get_dtype(vtk_type):
    """The type of NumPy that the values of a type of VTK are stored as; None if they are no numbers."""
    if vtk_type == VTK_BIT:
        return np.dtype(np.uint8)
    if vtk_type not in _NUMERIC:
        return None
    array = vtkDataArray.CreateDataArray(vtk_type)
    kind = "f" if vtk_type in _FLOATS else "i" if array.GetDataTypeMin() < 0 else "u"
    return np.dtype(f"{kind}{array.GetDataTypeSize()}")


def _choose_type(description):
    """The type in VTK of an array of a file: that which it had, if it fits the values."""
    known = _get_dtype(description.vtk_type)
    if known is not None and known == description.dtype:  # NumPy takes None for a float
        return description.vtk_type
    kind = {"i": "Int", "u": "UInt", "f": "Float"}[description.dtype.kind]
    return getattr(vtkCommonCore, f"vtkType{kind}{8 * description.dtype.itemsize}Array")().GetDataType()


def allocate(array, dtype, shape):
    """Sets the size of an array. Returns its values.

    Args:
        array: of VTK, empty.
        dtype: the type of NumPy of the values.
        shape: of the values: tuples, or tuples and components.
    """
    make_array(shape, dtype)  # or MemoryError, where VTK would end the process
    array.SetNumberOfComponents(shape[1] if len(shape) > 1 else 1)
    array.SetNumberOfTuples(shape[0])
    if 0 in shape:
        return np.empty(shape, dtype)
    return np.frombuffer(array, dtype).reshape(shape)


def set_names(array, name, component_names):
    """Sets the names of an array and its components, which may be any text."""
    encode = functools.partial(str.encode, encoding="utf-8", errors="surrogateescape")
    array.SetName(encode(name) if name else None)
    for i, component in enumerate(component_names):
        if component:
            array.SetComponentName(i, encode(component))


class Filler:
    """A new array of VTK with the names and keys of one of a file.

    Args:
        description: of the array, a ``gatun.Array``.
        shape: of its values.

    Attributes:
        description: of the array.
        values: to be filled, before ``finish``.
    """

    def __init__(self, description, shape):
        self.description = description
        vtk_type = _choose_type(description)
        self._array = vtkDataArray.CreateDataArray(vtk_type)
        # Bits get their values from bytes.
        self._bytes = vtkUnsignedCharArray() if vtk_type == VTK_BIT else None
        filled = self._array if self._bytes is None else self._bytes
        self.values = allocate(filled, description.dtype, shape)

    def finish(self):
        """Returns the array."""
        if self._bytes is not None:
            self._array.DeepCopy(self._bytes)
        set_names(self._array, self.description.name, self.description.component_names)
        set_keys(self._array, self.description.keys)
        return self._array


def add_array(attributes, array, roles=0):
    """Adds an array, also if there is one of its name.

    Args:
        attributes: vtkFieldData, or those of points or cells.
        array: to add.
        roles: bit i is set for the active attribute i.
    """
    name = array.GetName()
    is_taken = bool(name) and bool(attributes.HasArray(name))
    if is_taken:
        array.SetName(None)  # AddArray would replace the other one
    index = attributes.AddArray(array)
    if is_taken:
        array.SetName(name)
    for role in range(vtkDataSetAttributes.NUM_ATTRIBUTES):
        if roles >> role & 1:
            attributes.SetActiveAttribute(index, role)


def make_field(field):
    """An array of VTK for a field array of the library."""
    description = decode_field(field)
    components, values = field.components, take_values(field)
    if components == 0 or len(values) % components:
        raise Error(
            f"the field array {description.name!r} is not a whole number of tuples", 20005, "FileFormatError"
        )
    if isinstance(values, np.ndarray):
        shape = (len(values) // components, components)
        filler = Filler(description, shape)
        filler.values[...] = values.reshape(shape)
        return filler.finish()
    array = vtkStringArray()
    array.SetNumberOfComponents(components)
    array.SetNumberOfValues(len(values))
    for i, text in enumerate(values):
        array.SetValue(i, text.encode("utf-8", "surrogateescape"))
    set_names(array, description.name, description.component_names)
    set_keys(array, description.keys)
    return array
