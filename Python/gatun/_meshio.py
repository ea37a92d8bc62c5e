# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Meshes of meshio.

A set of points or cells is an array that is 1 in the set and 0 elsewhere, under the name of the set. The
field array "PointSets" or "CellSets" lists the names of the arrays that are sets.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ._warnings import warn

if TYPE_CHECKING:
    from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkUnstructuredGrid

_POINT_SETS = "PointSets"
_CELL_SETS = "CellSets"
# These numbers are not those of cells, but of entities of Gmsh's model.
_NO_SETS = ("gmsh:bounding_entities",)


def _mark(members, count, what):
    """An array that is 1 for the members of a set."""
    members = np.asarray([] if members is None else members)
    marks = np.zeros(count, np.uint8)
    if members.size:
        if members.dtype.kind not in "iu" or members.min() < 0 or members.max() >= count:
            raise ValueError(f"{what}: has to be numbers from 0 to {count - 1}")
        marks[members] = 1
    return marks


def _add_sets(sets, list_name, arrays, field_data, mark):
    """Adds the arrays of sets to others, and the list of their names to the field data."""
    for name, members in sets.items():
        if name in arrays:
            raise ValueError(f"{name!r} is the name of an array and of a set; rename one of them")
        arrays[name] = mark(name, members)
    if sets:
        field_data[list_name] = list(sets)


def from_meshio(mesh: Any) -> vtkUnstructuredGrid:
    """Makes a vtkUnstructuredGrid from a ``meshio.Mesh``, a ``gatun.Mesh`` or an object like them.

    The object has the members ``points``, ``cells``, ``point_data`` and ``cell_data``, and may have
    ``field_data``, ``point_sets`` and ``cell_sets``; see ``from_numpy``. A set becomes an array of its name,
    with 1 in the set and 0 elsewhere. The field arrays ``PointSets`` and ``CellSets`` list the sets.

    Raises:
        ValueError: arrays that do not fit together, or a set with the name of an array.
    """
    from ._arrays import from_numpy

    point_data, cell_data, field_data = list_arrays(mesh)
    return from_numpy(
        mesh.points, mesh.cells, point_data=point_data, cell_data=cell_data, field_data=field_data
    )


def list_arrays(mesh):
    """The arrays of points, cells and of the whole mesh, and the sets, by name."""
    point_data = dict(mesh.point_data)
    cell_data = dict(mesh.cell_data)
    field_data = dict(getattr(mesh, "field_data", None) or {})
    blocks = mesh.cells.items() if isinstance(mesh.cells, dict) else mesh.cells
    sizes = [len(block.data if hasattr(block, "data") else block[1]) for block in blocks]

    def mark_points(name, members):
        return _mark(members, len(mesh.points), f"point set {name!r}")

    def mark_cells(name, members):
        if len(members) != len(sizes):
            raise ValueError(f"cell set {name!r}: has {len(members)} blocks, and the mesh has {len(sizes)}")
        return [_mark(part, size, f"cell set {name!r}") for part, size in zip(members, sizes)]

    point_sets = getattr(mesh, "point_sets", None) or {}
    cell_sets = dict(getattr(mesh, "cell_sets", None) or {})
    for name in _NO_SETS:
        if cell_sets.pop(name, None) is not None:
            warn(f"cell set {name!r} is left out: it has numbers of Gmsh's entities, not of cells")
    if getattr(mesh, "gmsh_periodic", None):
        warn("gmsh_periodic is left out: a mesh of VTK has nothing for it")
    _add_sets(point_sets, _POINT_SETS, point_data, field_data, mark_points)
    _add_sets(cell_sets, _CELL_SETS, cell_data, field_data, mark_cells)
    return point_data, cell_data, field_data


def to_meshio(mesh: vtkUnstructuredGrid | vtkPolyData) -> Any:
    """Returns a vtkUnstructuredGrid or vtkPolyData as a ``meshio.Mesh``, with the sets of ``from_meshio``.

    Raises:
        ImportError: meshio is not installed.
        ValueError: the mesh has polyhedra.
    """
    import meshio  # an optional package

    from ._arrays import to_numpy

    arrays = to_numpy(mesh)

    def take_sets(list_name, values, find):
        names = arrays.field_data.get(list_name, [])
        return {name: find(values.pop(name)) for name in names if name in values}

    point_sets = take_sets(_POINT_SETS, arrays.point_data, np.flatnonzero)
    cell_sets = take_sets(
        _CELL_SETS, arrays.cell_data, lambda parts: [np.flatnonzero(part) for part in parts]
    )
    field_data = {
        name: values
        for name, values in arrays.field_data.items()
        if name not in (_POINT_SETS, _CELL_SETS)
    }
    return meshio.Mesh(
        arrays.points,
        arrays.cells,
        arrays.point_data,
        arrays.cell_data,
        field_data=field_data,
        point_sets=point_sets,
        cell_sets=cell_sets,
    )
