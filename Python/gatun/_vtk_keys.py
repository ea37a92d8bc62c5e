# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Information keys of arrays of VTK, from those of files and for them."""

import ctypes
import itertools

import numpy as np
from vtkmodules import vtkCommonCore, vtkCommonDataModel
from vtkmodules.vtkCommonCore import (
    vtkAbstractArray,
    vtkDataArray,
    vtkInformationIterator,
    vtkInformationKeyLookup,
)
from vtkmodules.vtkCommonDataModel import vtkQuadratureSchemeDefinition

# The class of the keys of each kind of the file format: one value for the first five, then lists.
_CLASSES = {
    1: "vtkInformationIntegerKey",
    2: "vtkInformationDoubleKey",
    3: "vtkInformationIdTypeKey",
    4: "vtkInformationUnsignedLongKey",
    5: "vtkInformationStringKey",
    6: "vtkInformationIntegerVectorKey",
    7: "vtkInformationDoubleVectorKey",
    8: "vtkInformationStringVectorKey",
}
_LAST_SINGLE = 5
_UNSIGNED = 4
_INTEGERS = (1, 6)
_QUADRATURE = 9
_QUADRATURE_CLASS = "vtkInformationQuadratureSchemeDefinitionVectorKey"
_MOST_SCHEMES = 1024  # more than there are types of cells
_MOST_NODES = 1 << 15
_INT_RANGE = (-(1 << 31), (1 << 31) - 1)

# Keys whose values follow from those of the array, or steer the writer.
_COMPUTED = {
    "COMPONENT_RANGE",
    "L2_NORM_RANGE",
    "L2_NORM_FINITE_RANGE",
    "PER_COMPONENT",
    "PER_FINITE_COMPONENT",
    "DISCRETE_VALUES",
    "DISCRETE_VALUE_SAMPLE_PARAMETERS",
}


def _is_computed(location, name):
    return location == "vtkGatunWriter" or (
        location in ("vtkDataArray", "vtkAbstractArray") and name in _COMPUTED
    )


def _to_bytes(text):
    return text.encode("utf-8", "surrogateescape")


def _find_key(location, name, kind):
    """The key of a name, which is made if there is none; None if there is one of another class."""
    if kind == _QUADRATURE:
        wanted = getattr(vtkCommonDataModel, _QUADRATURE_CLASS)
    else:
        wanted = getattr(vtkCommonCore, _CLASSES[kind])
    names = _to_bytes(name), _to_bytes(location)
    found = vtkInformationKeyLookup.Find(*names)
    if found is None and kind != _QUADRATURE:
        key = wanted.MakeKey(*names)
        # One reference of Python and one of VTK, which has keys until it ends. VTK 9.6 forgets its own.
        key.SetReferenceCount(2)
        return key
    return found if isinstance(found, wanted) else None


def _convert(values, kind):
    if kind in _INTEGERS:
        return [int(np.clip(value, *_INT_RANGE)) for value in values]
    if kind == _UNSIGNED:
        return [value % (1 << 64) for value in values]
    return [_to_bytes(value) if isinstance(value, str) else value for value in values]


def _set_schemes(info, key, numbers):
    """Sets schemes of integration, as far as the numbers make sense: the place of each, the type of the
    cells, the numbers of nodes and of points, and the weights of both."""
    numbers = iter(numbers)
    while True:
        head = list(itertools.islice(numbers, 4))
        limits = (_MOST_SCHEMES, _MOST_SCHEMES, _MOST_NODES, _MOST_NODES)
        if len(head) < 4 or not all(0 <= number < limit for number, limit in zip(head, limits)):
            return
        place, cell_type, nodes, points = map(int, head)
        shape, weights = (list(itertools.islice(numbers, size)) for size in (nodes * points, points))
        if not nodes or not points or len(weights) < points:
            return
        scheme = vtkQuadratureSchemeDefinition()
        scheme.Initialize(cell_type, nodes, points, shape, weights)
        key.Set(info, scheme, place)


def set_keys(array, keys):
    """Sets the information keys of an array.

    Args:
        array: of VTK.
        keys: as of ``gatun.Array``.
    """
    if keys:
        # These are made on their first use, and have to be there before they are looked up.
        vtkAbstractArray.GUI_HIDE()
        vtkDataArray.UNITS_LABEL()
        vtkQuadratureSchemeDefinition.DICTIONARY()
        vtkQuadratureSchemeDefinition.QUADRATURE_OFFSET_ARRAY_NAME()
    for location, name, kind, values in keys:
        if _is_computed(location, name) or not (kind in _CLASSES or kind == _QUADRATURE):
            continue
        key = _find_key(location, name, kind)
        if key is None:
            continue
        info = array.GetInformation()
        if kind == _QUADRATURE:
            _set_schemes(info, key, values)
        elif kind <= _LAST_SINGLE:
            key.Set(info, _convert(values, kind)[0])
        else:
            for value in _convert(values, kind):
                key.Append(info, value)


def _as_value(value):
    if isinstance(value, bytes):
        return value.decode("utf-8", "surrogateescape")
    return "" if value is None else value


def _read_doubles(address, count):
    """Numbers at an address of VTK, such as _0123abcd_p_void."""
    return list((ctypes.c_double * count).from_address(int(address.split("_")[1], 16))) if count else []


def _list_schemes(key, info):
    """Schemes of integration: the place of each, the type of the cells, the numbers of nodes and of points, and
    the weights of both."""
    numbers = []
    for place in range(key.Size(info)):
        scheme = key.Get(info, place)
        if scheme is not None:
            nodes, points = scheme.GetNumberOfNodes(), scheme.GetNumberOfQuadraturePoints()
            numbers += [place, scheme.GetCellType(), nodes, points]
            numbers += _read_doubles(scheme.GetShapeFunctionWeights(), nodes * points)
            numbers += _read_doubles(scheme.GetQuadratureWeights(), points)
    return tuple(map(float, numbers))


def _read_key(info, key):
    """The kind and the values of a key; None if a file cannot hold it."""
    if isinstance(key, getattr(vtkCommonDataModel, _QUADRATURE_CLASS)):
        return _QUADRATURE, _list_schemes(key, info)
    for kind, name in _CLASSES.items():
        if isinstance(key, getattr(vtkCommonCore, name)):
            if kind <= _LAST_SINGLE:
                return kind, (_as_value(key.Get(info)),)
            return kind, tuple(_as_value(key.Get(info, i)) for i in range(key.Length(info)))
    return None


def find_keys(array):
    """The keys of an array as tuples of location, name, kind and values, and the names of those that a file
    cannot hold."""
    found, refused = [], []
    if not array.HasInformation():
        return (), refused
    info = array.GetInformation()
    iterator = vtkInformationIterator()
    iterator.SetInformationWeak(info)
    iterator.InitTraversal()
    while not iterator.IsDoneWithTraversal():
        key = iterator.GetCurrentKey()
        iterator.GoToNextItem()
        location, name = _as_value(key.GetLocation()), _as_value(key.GetName())
        if _is_computed(location, name):
            continue
        value = _read_key(info, key) if location and name else None
        if value is None:
            refused.append(f"{location}::{name}")
        else:
            found.append((location, name, *value))
    found.sort(key=lambda key: tuple(map(_to_bytes, key[:2])))
    return tuple(found), refused
