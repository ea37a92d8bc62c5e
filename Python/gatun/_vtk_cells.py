# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Cells of VTK, of arrays that the library has filled."""

from __future__ import annotations

import numpy as np
from vtkmodules.vtkCommonCore import vtkTypeInt32Array, vtkTypeInt64Array
from vtkmodules.vtkCommonDataModel import vtkCellArray

from ._exceptions import Error
from ._surface_lists import LIST_OF_TYPE, SURFACE_LISTS
from ._vtk_arrays import allocate

def make_cells(offsets, ids):
    """A vtkCellArray. It shares the memory of vtkTypeInt32Array and vtkTypeInt64Array."""
    cells = vtkCellArray()
    cells.SetData(offsets, ids)
    return cells


def _copy_cells(offsets, ids):
    """A vtkCellArray with copies of arrays of NumPy."""
    arrays = []
    for values in (offsets, ids):
        array = (vtkTypeInt32Array if values.dtype == np.int32 else vtkTypeInt64Array)()
        allocate(array, values.dtype, values.shape)[...] = values
        arrays.append(array)
    return make_cells(*arrays)


def _gather(offsets, ids, chosen):
    """Offsets and ids of some cells."""
    sizes = np.diff(offsets)[chosen]
    ends = np.concatenate([np.zeros(1, offsets.dtype), np.cumsum(sizes, dtype=offsets.dtype)])
    return ends, ids[np.repeat(offsets[chosen] - ends[:-1], sizes) + np.arange(ends[-1])]


def make_lists(cells, grid):
    """The lists of a surface by the names of the methods that set them, and the order of its cells.

    Args:
        cells: all of them as a vtkCellArray.
        grid: what the library has read.

    Returns:
        The lists; and the numbers of the cells in the order of these lists, or None if they are in it.
    """
    lists = LIST_OF_TYPE[grid.types]
    if np.any(lists < 0):
        raise Error(f"a surface has a cell of type {grid.types[np.argmin(lists)]}", 20005, "FileFormatError")
    setters = [f"Set{name}" for name, *_ in SURFACE_LISTS]
    counts = np.bincount(lists, minlength=len(SURFACE_LISTS))
    if np.count_nonzero(counts) <= 1:
        return {setter: cells for setter, count in zip(setters, counts) if count}, None
    is_sorted = bool(np.all(lists[1:] >= lists[:-1]))
    order = np.argsort(lists, kind="stable")
    found = {}
    for setter, chosen in zip(setters, np.split(order, np.cumsum(counts)[:-1])):
        if len(chosen):
            found[setter] = _copy_cells(*_gather(grid.offsets, grid.connectivity, chosen))
    return found, None if is_sorted else order


def _divide_faces(grid):
    """The faces of polyhedra as VTK has them since 9.4: for each cell a list of the numbers of its faces, and the
    corners of all faces."""
    cells = np.flatnonzero(grid.face_locations >= 0)
    at = grid.face_locations[cells]
    counts = grid.faces[at]
    ends = np.zeros(len(grid.face_locations) + 1, np.int64)
    ends[cells + 1] = counts
    np.cumsum(ends, out=ends)
    # All cells at once: their first faces, then their second ones, and so on.
    places = np.empty(ends[-1], np.int64)
    at = at + 1
    for number in range(counts.max(initial=0)):
        has_face = counts > number
        cells, counts, at = cells[has_face], counts[has_face], at[has_face]
        places[ends[cells] + number] = at
        at = at + 1 + grid.faces[at]
    sizes = grid.faces[places]
    corner_ends = np.concatenate([np.zeros(1, np.int64), np.cumsum(sizes)])
    corners = grid.faces[np.repeat(places + 1 - corner_ends[:-1], sizes) + np.arange(corner_ends[-1])]
    return _copy_cells(ends, np.arange(ends[-1])), _copy_cells(corner_ends, corners)


def set_cells(mesh, cells, grid, arrays):
    """Gives a vtkUnstructuredGrid its cells.

    Args:
        mesh: the grid.
        cells: a vtkCellArray.
        grid: what the library has read.
        arrays: the arrays of VTK by the names that they have as members of the grid.
    """
    if grid.faces is None:
        mesh.SetCells(arrays["types"], cells)
    elif hasattr(mesh, "SetPolyhedralCells"):  # since VTK 9.4
        mesh.SetPolyhedralCells(arrays["types"], cells, *_divide_faces(grid))
    else:
        mesh.SetCells(arrays["types"], cells, arrays["face_locations"], arrays["faces"])
