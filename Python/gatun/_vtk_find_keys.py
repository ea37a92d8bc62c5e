# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Information keys of arrays of VTK, for files."""

import ctypes

from vtkmodules import vtkCommonCore
from vtkmodules.vtkCommonCore import vtkInformationIterator
from vtkmodules.vtkCommonDataModel import vtkInformationQuadratureSchemeDefinitionVectorKey

# The classes of keys with one value and with several, and their kinds in the file format.
_SINGLE = {
    "vtkInformationIntegerKey": 1,
    "vtkInformationDoubleKey": 2,
    "vtkInformationIdTypeKey": 3,
    "vtkInformationUnsignedLongKey": 4,
    "vtkInformationStringKey": 5,
}
_LISTS = {
    "vtkInformationIntegerVectorKey": 6,
    "vtkInformationDoubleVectorKey": 7,
    "vtkInformationStringVectorKey": 8,
}
_QUADRATURE = 9

# Keys whose values follow from those of the array.
_COMPUTED = {
    "COMPONENT_RANGE",
    "L2_NORM_RANGE",
    "L2_NORM_FINITE_RANGE",
    "PER_COMPONENT",
    "PER_FINITE_COMPONENT",
    "DISCRETE_VALUES",
    "DISCRETE_VALUE_SAMPLE_PARAMETERS",
}


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
    for name, kind in _SINGLE.items():
        if isinstance(key, getattr(vtkCommonCore, name)):
            return kind, (_as_value(key.Get(info)),)
    for name, kind in _LISTS.items():
        if isinstance(key, getattr(vtkCommonCore, name)):
            return kind, tuple(_as_value(key.Get(info, i)) for i in range(key.Length(info)))
    if isinstance(key, vtkInformationQuadratureSchemeDefinitionVectorKey):
        return _QUADRATURE, _list_schemes(key, info)
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
        if location == "vtkGatunWriter" or (
            location in ("vtkDataArray", "vtkAbstractArray") and name in _COMPUTED
        ):
            continue
        value = _read_key(info, key) if location and name else None
        if value is None:
            refused.append(f"{location}::{name}")
        else:
            found.append((location, name, *value))
    found.sort(key=lambda key: tuple(text.encode("utf-8", "surrogateescape") for text in key[:2]))
    return tuple(found), refused
