# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Meshes of VTK, whose memory the library reads where it can."""

from __future__ import annotations

import numpy as np
from vtkmodules.vtkCommonCore import vtkDataArray, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkDataSetAttributes

from ._description import Array
from ._field_input import Fields
from ._mesh_data import MeshData
from ._meshes import CellInput
from ._surface_lists import SURFACE_LISTS, find_types
from ._values import get_types, get_values
from ._vtk_keys import find_keys
from ._warnings import warn

_TETRA = 10
_POLYHEDRON = 42
_MOST_EXACT = float(1 << 53)  # up to here every integer is a double

_NO_CELLS = {
    "connectivity": np.empty(0, np.int64),
    "offsets": np.zeros(1, np.int64),
    "types": np.empty(0, np.uint8),
}


# ------------------------------------------------------------------------------
# Arrays


def _as_text(text):
    """A text of VTK, which is bytes if it is no UTF-8."""
    return text.decode("utf-8", "surrogateescape") if isinstance(text, bytes) else text or ""


def _describe(array, dtype, what, is_cell=False, roles=0):
    """The description of an array, with a warning of what a file cannot hold."""
    keys, refused = find_keys(array)
    name = _as_text(array.GetName())
    for key in refused:
        warn(f"the key {key} of the {what} {name!r} is left out, because its type cannot be written")
    components = array.GetNumberOfComponents()
    names = ()
    if array.HasAComponentName():
        names = tuple(_as_text(array.GetComponentName(i)) for i in range(components))
    return Array(name, name, is_cell, dtype, components, names, roles, array.GetDataType(), keys)


def _find_roles(attributes, array):
    roles = range(vtkDataSetAttributes.NUM_ATTRIBUTES)
    return sum(1 << role for role in roles if attributes.GetAbstractAttribute(role) is array)


def _take_arrays(attributes, is_cell, count, names):
    """The arrays of points or cells with their values.

    Args:
        attributes: of VTK.
        is_cell: whether they are of cells.
        count: the number of points or cells.
        names: of the arrays to take, or None for all. Those without a name are always taken.
    """
    what = "cell array" if is_cell else "point array"
    taken = []
    for i in range(attributes.GetNumberOfArrays()):
        array = attributes.GetAbstractArray(i)
        name = _as_text(array.GetName())
        tuples = array.GetNumberOfTuples()
        if tuples != count:
            raise ValueError(f"the {what} {name!r} has {tuples} tuples for {count} {what.split()[0]}s")
        if names is not None and name and name not in names:
            continue
        if not isinstance(array, vtkDataArray):
            raise ValueError(
                f"the {what} {name!r} is a {array.GetClassName()}, which a .gtn file cannot hold; texts are for "
                "field data, and arrays=... leaves it out"
            )
        values = get_values(array)
        taken.append((_describe(array, values.dtype, what, is_cell, _find_roles(attributes, array)), values))
    return taken


def _take_fields(data):
    """The field arrays with their values."""
    taken = []
    for i in range(data.GetNumberOfArrays()):
        array = data.GetAbstractArray(i)
        if isinstance(array, vtkStringArray):
            values = [array.GetValue(k) for k in range(array.GetNumberOfValues())]
            dtype = np.dtype(object)
        elif isinstance(array, vtkDataArray):
            values = get_values(array)
            dtype = values.dtype
        else:
            warn(f"the field array {_as_text(array.GetName())!r} is left out, because its type cannot be written")
            continue
        taken.append((_describe(array, dtype, "field array"), values))
    return taken


# ------------------------------------------------------------------------------
# Points and cells


def _take_points(points):
    """Coordinates, the description of their array, and whether they were integers."""
    if points is None:
        return np.empty((0, 3), np.float32), None, False
    array = points.GetData()
    values = get_values(array)
    is_integer = values.dtype.kind != "f"
    if is_integer:
        warn("integer coordinates are written as double")
        if values.size and np.abs(values.astype(np.float64)).max() >= _MOST_EXACT:
            raise ValueError("some coordinates are integers beyond 2^53")
        values = values.astype(np.float64)
    return values.reshape(-1, 3), _describe(array, values.dtype, "array of points"), is_integer


def _take_ids(cells):
    """Offsets and points of cells, both with 64 or 32 bits."""
    arrays = [get_values(cells.GetOffsetsArray()), get_values(cells.GetConnectivityArray())]
    narrow = all(np.iinfo(array.dtype).max <= np.iinfo(np.int32).max for array in arrays)
    return [array.astype(np.int32 if narrow else np.int64, copy=False) for array in arrays]


def make_face_stream(lists, faces, is_polyhedron):
    """The faces of polyhedra in one list: of each one the number of its faces, and of each face the number
    of its corners and them. Returns the list, and where each cell begins in it, or -1.

    Args:
        lists: offsets and numbers of the faces of each cell.
        faces: offsets and corners of each face.
        is_polyhedron: whether each cell is one.
    """
    (starts, numbers), (face_starts, corners) = lists, faces
    counts = np.where(is_polyhedron, np.diff(starts), 0)
    owners = np.repeat(np.arange(len(counts)), counts)  # the cell of each face
    firsts = np.cumsum(counts) - counts
    chosen = numbers[np.repeat(starts[:-1] - firsts, counts) + np.arange(len(owners))].astype(np.int64)
    if chosen.size and not (chosen.min() >= 0 and chosen.max() < len(face_starts) - 1):
        raise ValueError(f"a polyhedron has a face that is none of {len(face_starts) - 1}")
    sizes = np.diff(face_starts).astype(np.int64)[chosen]
    # One number before each polyhedron, and one before each face.
    heads = np.cumsum(is_polyhedron)
    ends = np.cumsum(sizes + 1)
    places = ends - sizes - 1 + heads[owners]
    stream = np.empty(int(sizes.sum()) + len(sizes) + int(heads[-1] if len(heads) else 0), np.int64)
    lengths = np.concatenate([[0], ends])
    locations = np.where(is_polyhedron, lengths[firsts] + heads - 1, -1)
    stream[locations[is_polyhedron]] = counts[is_polyhedron]
    stream[places] = sizes
    within = np.arange(int(sizes.sum())) - np.repeat(np.cumsum(sizes) - sizes, sizes)
    stream[np.repeat(places + 1, sizes) + within] = corners[
        np.repeat(face_starts[:-1].astype(np.int64)[chosen], sizes) + within
    ]
    return stream, locations.astype(np.int64)


def _take_faces(grid, types):
    """The faces of polyhedra and where those of each cell begin; None if there are none."""
    if hasattr(grid, "GetPolyhedronFaces"):  # since VTK 9.4
        lists, faces = grid.GetPolyhedronFaceLocations(), grid.GetPolyhedronFaces()
        if lists is None or faces is None or lists.GetNumberOfCells() < len(types):
            return None, None
        return make_face_stream(_take_ids(lists), _take_ids(faces), types == _POLYHEDRON)
    faces, locations = grid.GetFaces(), grid.GetFaceLocations()
    if faces is None or locations is None or locations.GetNumberOfValues() < len(types):
        return None, None
    return get_values(faces), get_values(locations)


def _take_grid(grid):
    """Members of a CellInput for the cells of a vtkUnstructuredGrid."""
    cells = grid.GetCells()
    types = get_types(grid)
    count = 0 if cells is None else cells.GetNumberOfCells()
    if len(types) != count:
        raise ValueError("the number of cell types is not that of the cells")
    if cells is None:
        return _NO_CELLS
    offsets, ids = _take_ids(cells)
    faces, locations = (None, None) if np.all(types == _TETRA) else _take_faces(grid, types)
    return {
        "connectivity": ids,
        "offsets": offsets if len(offsets) else np.zeros(1, ids.dtype),
        "types": types,
        "faces": faces,
        "face_locations": locations,
    }


def _take_surface(surface):
    """Members of a CellInput for the four lists of a vtkPolyData."""
    filled = []
    for name, *kinds in SURFACE_LISTS:
        cells = getattr(surface, f"Get{name}")()
        if cells is not None and cells.GetNumberOfCells() > 0:
            filled.append((*_take_ids(cells), *kinds))
    if not filled:
        return _NO_CELLS
    types = [find_types(np.diff(offsets), known, other) for offsets, _, known, other in filled]
    if len(filled) == 1:
        return {"connectivity": filled[0][1], "offsets": filled[0][0], "types": types[0]}
    total = sum(len(ids) for _, ids, *_ in filled)
    narrow = total <= np.iinfo(np.int32).max and all(ids.dtype == np.int32 for _, ids, *_ in filled)
    integer = np.int32 if narrow else np.int64
    ids = [ids[: offsets[-1]] for offsets, ids, *_ in filled]
    sizes = np.concatenate([np.diff(offsets) for offsets, *_ in filled])
    return {
        "connectivity": np.concatenate(ids).astype(integer),
        "offsets": np.concatenate([[0], np.cumsum(sizes)]).astype(integer),
        "types": np.concatenate(types),
    }


def take_vtk(data, names):
    """A mesh of VTK for the library.

    Args:
        data: a vtkUnstructuredGrid or vtkPolyData.
        names: of the arrays to take, or None for all.
    """
    is_surface = bool(data.IsA("vtkPolyData"))
    points, point_array, is_integer = _take_points(data.GetPoints())
    members = _take_surface(data) if is_surface else _take_grid(data)
    mesh = CellInput(points, is_surface=is_surface, point_array=point_array, **members)
    info = data.GetInformation()
    key = vtkDataObject.DATA_TIME_STEP()
    return MeshData(
        mesh,
        _take_arrays(data.GetPointData(), False, data.GetNumberOfPoints(), names)
        + _take_arrays(data.GetCellData(), True, data.GetNumberOfCells(), names),
        Fields(_take_fields(data.GetFieldData())),
        info.Get(key) if info.Has(key) else None,
        keeps_points=is_integer,
    )
