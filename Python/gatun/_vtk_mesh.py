# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Meshes of files as VTK has them."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from vtkmodules.vtkCommonCore import (
    vtkAbstractArray,
    vtkDoubleArray,
    vtkFloatArray,
    vtkIdTypeArray,
    vtkPoints,
    vtkTypeInt32Array,
    vtkTypeInt64Array,
    vtkUnsignedCharArray,
)
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkDataSetAttributes, vtkPolyData, vtkUnstructuredGrid

from ._file import File
from ._grid import Grid
from ._vtk_arrays import Filler, add_array, allocate, make_field, set_names
from ._vtk_cells import make_cells, make_lists, set_cells
from ._vtk_keys import set_keys

_ARRAYS = {
    "float32": vtkFloatArray,
    "float64": vtkDoubleArray,
    "int32": vtkTypeInt32Array,
    "int64": vtkTypeInt64Array,
    "uint8": vtkUnsignedCharArray,
}
# Those of another class or with a name.
_ID_ARRAYS = ("faces", "face_locations", "point_ids", "cell_ids")
_GHOSTS = vtkDataSetAttributes.GhostArrayName()
_NAMES = {
    "point_ids": "GlobalPointIds",
    "cell_ids": "GlobalCellIds",
    "point_ghosts": _GHOSTS,
    "cell_ghosts": _GHOSTS,
    "normals": "Normals",
}


class _Target:
    """The arrays of a mesh, which VTK allocates when the library asks for them."""

    def __init__(self, file: File) -> None:
        self._descriptions = {(array.is_cell, array.key): array for array in file.arrays}
        self.members: dict[str, Any] = {}
        self.fillers: list[Filler] = []

    def allocate(self, name: str, dtype: np.dtype, shape: tuple[int, ...]) -> np.ndarray:
        """The values of a new array, as ``File.read`` asks for it."""
        where, _, key = name.partition("/")
        if key or where in ("point_data", "cell_data"):
            self.fillers.append(Filler(self._descriptions[where == "cell_data", key], shape))
            return self.fillers[-1].values
        array = vtkIdTypeArray() if name in _ID_ARRAYS else _ARRAYS[dtype.name]()
        array.SetName(_NAMES.get(name))
        self.members[name] = array
        return allocate(array, dtype, shape)

    def list_fillers(self, is_cell: bool) -> list[Filler]:
        """The arrays of points or cells."""
        return [filler for filler in self.fillers if filler.description.is_cell == is_cell]


def _has_global_ids(fillers: list[Filler], name: str) -> bool:
    return any(
        f.description.name == name or f.description.roles >> vtkDataSetAttributes.GLOBALIDS & 1 for f in fillers
    )


def _add_ids(attributes, ids, is_hidden):
    if is_hidden:
        ids.GetInformation().Set(vtkAbstractArray.GUI_HIDE(), 1)
    attributes.SetGlobalIds(ids)


def _add_ghosts(attributes, ghosts, values):
    """Adds ghost flags; those that the file holds stay."""
    stored = attributes.GetArray(_GHOSTS)
    if isinstance(stored, vtkUnsignedCharArray) and stored.GetNumberOfValues() == ghosts.GetNumberOfValues():
        if len(values):
            np.frombuffer(stored, np.uint8)[...] |= values
    else:
        attributes.AddArray(ghosts)


def _make_points(array, description):
    set_names(array, description.name, description.component_names)
    set_keys(array, description.keys)
    points = vtkPoints()
    points.SetData(array)
    return points


def _make_structure(target, grid):
    """A mesh with cells. Puts the values of its cells into the order that they have in it."""
    members = target.members
    cells = make_cells(members["offsets"], members["connectivity"])
    if not grid.is_surface:
        mesh = vtkUnstructuredGrid()
        set_cells(mesh, cells, grid, members)
        return mesh
    mesh = vtkPolyData()
    lists, order = make_lists(cells, grid)
    for setter, some in lists.items():
        getattr(mesh, setter)(some)
    if order is not None:
        others = (grid.cell_ids, grid.cell_ghosts)
        for values in [f.values for f in target.list_fillers(True)] + [v for v in others if v is not None]:
            values[...] = values[order]
    return mesh


def run(
    file: File,
    method: Callable[..., Grid],
    *arguments: Any,
    hides_ids: bool = False,
    has_ghosts: bool = False,
    **options: Any,
) -> vtkUnstructuredGrid | vtkPolyData:
    """The mesh that a method of a file makes, such as ``file.contour``.

    Args:
        file: the file.
        method: of it.
        arguments, options: of the method.
        hides_ids: whether ids of points and cells are kept out of the lists of arrays in ParaView.
        has_ghosts: whether the mesh gets ghost flags.
    """
    target = _Target(file)
    grid = method(*arguments, allocate=target.allocate, **options)
    mesh = _make_structure(target, grid)
    mesh.SetPoints(_make_points(target.members["points"], file.point_array))
    for kind, attributes in (("point", mesh.GetPointData()), ("cell", mesh.GetCellData())):
        fillers = target.list_fillers(kind == "cell")
        for filler in fillers:
            add_array(attributes, filler.finish(), filler.description.roles)
        ids = target.members.get(kind + "_ids")
        if ids is not None and not _has_global_ids(fillers, ids.GetName()):
            _add_ids(attributes, ids, hides_ids)
        if has_ghosts:
            _add_ghosts(attributes, target.members[kind + "_ghosts"], getattr(grid, kind + "_ghosts"))
    if "normals" in target.members:
        mesh.GetPointData().SetNormals(target.members["normals"])
    for array in file.make_fields(make_field, options.get("step"), options.get("time")):
        add_array(mesh.GetFieldData(), array)
    if grid.time is not None:
        mesh.GetInformation().Set(vtkDataObject.DATA_TIME_STEP(), grid.time)
    return mesh


def make_mesh(file: File, method: Callable[..., Grid], *arguments: Any, **options: Any) -> vtkUnstructuredGrid | vtkPolyData:
    """The mesh that ``file.read``, ``file.contour`` or ``file.slice`` makes.

    Args:
        file: the file.
        method: of it.
        arguments, options: of the method.
    """
    if method == file.read:
        return read_mesh(file, **options)
    return run(file, method, *arguments, **options)


def read_mesh(file: File, **options: Any) -> vtkUnstructuredGrid | vtkPolyData:
    """Reads the mesh of a file or a part of it, as ``vtkGatunReader`` and ``vtkGatunSurfaceReader`` do.

    One of several pieces has global ids, which are hidden unless asked for.

    Args:
        file: the file.
        options: of ``File.read``.
    """
    is_piece = options.get("pieces", 1) > 1
    ids = bool(options.pop("ids", False))
    return run(
        file,
        file.read,
        hides_ids=not ids,
        has_ghosts=is_piece and options.get("ghost_levels", 0) > 0,
        ids=ids or (is_piece and not options.get("boundary")),
        **options,
    )
