# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Golden files: what a file holds as checksums, from vtkGatunReader or from grids.

A description is made of dicts and lists, as it stands in expected.json under "meshes":

    times         of the steps
    wide_ids      whether point ids have 64 bits; None without cells
    arrays        names and types of the point and cell arrays
    roles         names of the active attributes of points and cells, by number of the role
    field_data    for each step
    file_order    sha256 of points, tets (or cells, if there are others) and, for each step, arrays,
                  in the file's own order
    input_order   the same in the order of the input, as far as the file keeps it

That of a series of meshes has times, and meshes: such a description of each mesh with its steps.
"""

import glob
import hashlib
import json
import os
import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkInformationIterator, vtkStringArray
from vtkmodules.vtkCommonDataModel import VTK_POLYHEDRON, VTK_TETRA, vtkUnstructuredGrid
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as pipeline

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "IO"))

import gatunMeshes as gm  # noqa: E402  (in the folder just added)
import gatunPolyData as pd  # noqa: E402
from gatun.vtk import vtkGatunReader, vtkGatunSurfaceReader  # noqa: E402


def path_of(name):
    return os.path.join(os.environ["GATUN_TEST_DATA"], "Golden", name)


def bytes_of(name):
    with open(path_of(name), "rb") as file:
        return file.read()


def expected(kind="meshes"):
    """What is expected of files by their names: descriptions of meshes, or lines on merges, layers
    or volumes. There is something of each file."""
    with open(path_of("expected.json"), encoding="utf-8") as file:
        result = json.load(file)
    names = {os.path.basename(path) for path in glob.glob(path_of("*.g[th][nv]"))}
    assert names == {*result["meshes"], *result["volumes"]}, names
    return result[kind]


def assert_same(one, other, path):
    """The same description; tells what differs."""
    assert type(one) is type(other), (path, one, other)
    if isinstance(one, dict):
        assert list(one) == list(other), (path, list(one), list(other))
        for key in one:
            assert_same(one[key], other[key], "%s: %s" % (path, key))
    elif isinstance(one, list):
        assert len(one) == len(other), (path, one, other)
        for i, (a, b) in enumerate(zip(one, other)):
            assert_same(a, b, "%s[%d]" % (path, i))
    else:
        assert one == other, (path, one, other)


def sha256(values):
    """Of the bytes of a numpy array, which are little-endian."""
    values = np.ascontiguousarray(values)
    return hashlib.sha256(values.astype(values.dtype.newbyteorder("<")).tobytes()).hexdigest()


def sha256_of_texts(texts):
    """Of texts as bytes, each with its length before it."""
    parts = [len(text).to_bytes(8, "little") + text for text in texts]
    return hashlib.sha256(b"".join(parts)).hexdigest()


#: Kinds of information keys (3.2), by the ends of their classes' names.
KEY_KINDS = {"IntegerKey": 1, "DoubleKey": 2, "IdTypeKey": 3, "UnsignedLongKey": 4, "StringKey": 5,
             "IntegerVectorKey": 6, "DoubleVectorKey": 7, "StringVectorKey": 8}


def keys_of(array):
    """The information keys of an array: location, name, kind and values, as texts."""
    keys = []
    iterator = vtkInformationIterator()
    iterator.SetInformation(array.GetInformation())
    iterator.InitTraversal()
    while not iterator.IsDoneWithTraversal():
        key = iterator.GetCurrentKey()
        kind = KEY_KINDS.get(key.GetClassName().removeprefix("vtkInformation"))
        if kind and not key.GetName().endswith("RANGE"):
            info = array.GetInformation()
            values = [key.Get(info, i) for i in range(key.Length(info))] if kind > 5 else [
                key.Get(info)]
            keys.append([key.GetLocation(), key.GetName(), kind, [str(v) for v in values]])
        iterator.GoToNextItem()
    return sorted(keys)


def describe_points(name, component_names, keys):
    """The array of the points, if it is not as usual."""
    described = dict(describe_array(name, 0, 3, component_names), keys=keys)
    return {} if described == {
        **describe_array("Points", 0, 3, []), "keys": []} else {"point_array": described}


def describe_array(name, vtk_type, components, component_names, keys=()):
    while component_names and not component_names[-1]:
        component_names = component_names[:-1]
    return {
        "name": name or "",
        "vtk_type": vtk_type,
        "components": components,
        "component_names": component_names,
        **({"keys": list(keys)} if keys else {}),
    }


def describe_field_array(array):
    result = describe_array(*gm.description(array), keys_of(array))
    if isinstance(array, vtkStringArray):
        texts = [array.GetValue(i).encode() for i in range(array.GetNumberOfValues())]
        result["sha256"] = sha256_of_texts(texts)
    else:
        result["sha256"] = sha256(gm.values_of(array))
    return result


def attributes_of(grid):
    return {"points": grid.GetPointData(), "cells": grid.GetCellData()}


def sha256_of_cells(cells):
    """Of triples of a type, points and, of a polyhedron, faces: these numbers as int64, each list
    with its length before it."""
    numbers = []
    for kind, points, faces in cells:
        numbers += [kind, len(points), *points]
        if faces is not None:
            numbers += [len(faces), *(x for face in faces for x in (len(face), *face))]
    return sha256(np.array(numbers, np.int64))


def cells_of(grid):
    """All cells, as sha256_of_cells takes them."""
    kinds = gm.cell_types(grid).tolist()
    offsets = vtk_to_numpy(grid.GetCells().GetOffsetsArray())
    points = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).tolist()
    cells = []
    for i, kind in enumerate(kinds):
        faces = None
        if kind == VTK_POLYHEDRON:
            faces, stream = [], gm.faces_of(grid, i)[1:]
            while stream:
                faces.append(stream[1 : stream[0] + 1])
                stream = stream[stream[0] + 1 :]
        cells.append((kind, points[offsets[i] : offsets[i + 1]], faces))
    return cells


def describe_cells(grid):
    kinds = set(gm.cell_types(grid)) if grid.GetNumberOfCells() else set()
    if kinds <= {VTK_TETRA}:
        return {"tets": sha256(gm.connectivity(grid).astype(np.int64))}
    return {"cells": sha256_of_cells(cells_of(grid))}


def hashes(grids):
    """Checksums of the grids of all steps, which have one mesh."""
    coordinates = gm.coordinates(grids[0])
    at_steps = [sha256(gm.coordinates(grid)) for grid in grids]
    return {
        **({"points_at": at_steps} if len(set(at_steps)) > 1 else {}),
        "points_type": coordinates.dtype.name if len(coordinates) else None,
        "points": sha256(coordinates) if len(coordinates) else None,
        **describe_cells(grids[0]),
        "arrays": [
            [
                sha256(gm.values_of(array))
                for attributes in attributes_of(grid).values()
                for array in gm.arrays_of(attributes)
            ]
            for grid in grids
        ],
    }


def describe_grids(grids, times, in_input_order):
    """grids: those of each step in the file's order, and then in that of the input. Steps with the
    same cells have one mesh."""
    meshes = {}
    for step, grid in enumerate(grids):
        key = grid.GetNumberOfPoints(), *describe_cells(grid).values()
        meshes.setdefault(key, []).append(step)
    described = [
        describe_mesh(*([of_steps[step] for step in steps if of_steps]
                        for of_steps in (grids, times, in_input_order)))
        for steps in meshes.values()
    ]
    return described[0] if len(meshes) == 1 else {"times": times, "meshes": described}


def describe_mesh(grids, times, in_input_order):
    """Of steps that have one mesh."""
    grid = grids[0]
    points = grid.GetPoints() and grid.GetPoints().GetData()
    return {
        **(describe_points(points.GetName(), gm.description(points)[3], keys_of(points))
           if points else {}),
        "times": times,
        "wide_ids": gm.has_wide_ids(grid.GetCells()) if grid.GetNumberOfCells() else None,
        "arrays": [
            dict(describe_array(*gm.description(array), keys_of(array)), where=where)
            for where, attributes in attributes_of(grid).items()
            for array in gm.arrays_of(attributes)
        ],
        "roles": {
            where: {str(i): name for i, name in enumerate(gm.roles_of(attributes)) if name}
            for where, attributes in attributes_of(grid).items()
        },
        "field_data": [
            [describe_field_array(array) for array in gm.arrays_of(step.GetFieldData())]
            for step in grids
        ],
        "file_order": hashes(grids),
        "input_order": hashes(in_input_order),
    }


TYPES = ({1: 1}, {2: 3}, {3: 5, 4: 9}, {})
OTHER_TYPES = (2, 4, 7, 6)


def grid_of(data):
    """A surface as a grid, with cells in the order of its lists; a grid as it is."""
    if not data.IsA("vtkPolyData"):
        return data
    grid = vtkUnstructuredGrid()
    grid.SetPoints(data.GetPoints())
    lists = pd.cells_of(data)
    wide = any(gm.has_wide_ids(getattr(data, "Get" + name)())
               for name, cells in zip(pd.LISTS, lists) if cells)
    kinds = [TYPES[i].get(len(ids), OTHER_TYPES[i]) for i, cells in enumerate(lists)
             for ids in cells]
    if kinds:
        grid.SetCells(kinds, pd.cell_array(sum(lists, []), wide))
    for name in ("PointData", "CellData", "FieldData"):
        getattr(grid, "Get" + name)().ShallowCopy(getattr(data, "Get" + name)())
    return grid


def read_steps(path, restore):
    """The grid of each step, and their times, by vtkGatunReader or vtkGatunSurfaceReader."""
    reader = vtkGatunSurfaceReader()
    if not reader.CanReadFile(path):
        reader = vtkGatunReader()
    reader.SetFileName(path)
    reader.SetRestoreOrder(restore)
    reader.UpdateInformation()
    info = reader.GetOutputInformation(0)
    times = list(info.Get(pipeline.TIME_STEPS())) if info.Has(pipeline.TIME_STEPS()) else []
    grids = []
    for time in times or [None]:
        reader.Update() if time is None else reader.UpdateTimeStep(time)
        assert reader.GetErrorCode() == 0, path
        grid = reader.GetOutput().NewInstance()
        grid.DeepCopy(reader.GetOutput())
        grids.append(grid_of(grid))
    return grids, times


def describe_read(path):
    """What vtkGatunReader makes of a file."""
    grids, times = read_steps(path, False)
    return describe_grids(grids, times, read_steps(path, True)[0])
