# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Everything that a mesh of VTK holds, to compare two of them."""

import gatunMeshes as gm
import numpy as np
from gatunGolden import keys_of
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import (
    vtkDataObject, vtkDataSetAttributes, vtkQuadratureSchemeDefinition, vtkUnstructuredGrid, vtkXMLDataElement)


def describe_schemes(array):
    """The schemes of integration in the keys of an array."""
    key, info = vtkQuadratureSchemeDefinition.DICTIONARY(), array.GetInformation()
    found = []
    for i in range(key.Size(info) if info.Has(key) else 0):
        scheme = key.Get(info, i)
        if scheme is not None:
            element = vtkXMLDataElement()
            scheme.SaveState(element)
            text = element.GetCharacterData()
            nested = [element.GetNestedElement(n) for n in range(element.GetNumberOfNestedElements())]
            found.append((i, scheme.GetCellType(), text, [e.GetCharacterData() for e in nested]))
    return found


def describe_array(array):
    if array is None:
        return None
    if isinstance(array, vtkStringArray):
        values = [array.GetValue(i) for i in range(array.GetNumberOfValues())]
    else:
        values = np.ascontiguousarray(gm.values_of(array)).tobytes()
    count = array.GetNumberOfComponents()
    return {
        "class": array.GetClassName(),
        "name": array.GetName(),
        "components": [array.GetComponentName(i) for i in range(count)],
        "has components": array.HasAComponentName(),
        "tuples": array.GetNumberOfTuples(),
        "keys": keys_of(array),
        "schemes": describe_schemes(array),
        "values": values,
    }


def describe_attributes(attributes):
    arrays = gm.arrays_of(attributes)
    roles = {}
    if isinstance(attributes, vtkDataSetAttributes):
        active = map(attributes.GetAbstractAttribute, range(vtkDataSetAttributes.NUM_ATTRIBUTES))
        roles = {role: arrays.index(array) for role, array in enumerate(active) if array is not None}
    return {"arrays": list(map(describe_array, arrays)), "roles": roles}


def describe_cells(cells):
    if cells is None or cells.GetNumberOfCells() == 0:
        return None
    return describe_array(cells.GetOffsetsArray()), describe_array(cells.GetConnectivityArray())


def describe_mesh(mesh):
    """Everything that a vtkUnstructuredGrid or a vtkPolyData holds."""
    if isinstance(mesh, vtkUnstructuredGrid):
        count = mesh.GetNumberOfCells()
        cells = [describe_cells(mesh.GetCells()), gm.cell_types(mesh).tobytes() if count else b""]
        cells += [gm.faces_of(mesh, i) for i in range(count)]
    else:
        cells = list(map(describe_cells, (mesh.GetVerts(), mesh.GetLines(), mesh.GetPolys(), mesh.GetStrips())))
    key, info = vtkDataObject.DATA_TIME_STEP(), mesh.GetInformation()
    points = mesh.GetPoints()
    return {
        "class": mesh.GetClassName(),
        "time": info.Get(key) if info.Has(key) else None,
        "points": points and describe_array(points.GetData()),
        "cells": cells,
        "point data": describe_attributes(mesh.GetPointData()),
        "cell data": describe_attributes(mesh.GetCellData()),
        "field data": describe_attributes(mesh.GetFieldData()),
    }


def list_differences(one, other, place=""):
    """The places where two descriptions differ."""
    if type(one) is not type(other):
        return [f"{place}: {one!r:.200} {other!r:.200}"]
    if isinstance(one, dict) and one.keys() == other.keys():
        pairs = [(key, one[key], other[key]) for key in one]
    elif isinstance(one, (list, tuple)) and len(one) == len(other):
        pairs = list(zip(range(len(one)), one, other))
    else:
        return [] if one == other else [f"{place}: {one!r:.200} {other!r:.200}"]
    return [text for key, a, b in pairs for text in list_differences(a, b, f"{place}/{key}")]


def require_same_mesh(one, other, what):
    """Two meshes hold the same, array by array and bit by bit."""
    differences = list_differences(describe_mesh(one), describe_mesh(other))
    assert not differences, (what, differences[:5])
