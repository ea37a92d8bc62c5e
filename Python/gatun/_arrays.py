# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Meshes and volumes from NumPy arrays, and back."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import VTK_UNSIGNED_CHAR, vtkDataArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkGenericCell, vtkImageData, vtkPolyData, vtkUnstructuredGrid

from ._cells import NAMES, POLYHEDRON, CellType, Mesh, as_points, join_blocks, join_corners, list_blocks
from ._numbers import fill_masked
from ._surface_lists import LIST_OF_TYPE, SURFACE_LISTS, find_types
from ._values import get_types, get_values
from ._values import to_numpy as _to_values
from ._values import to_vtk

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

# ------------------------------------------------------------------------------
# To VTK


def _add_arrays(attributes, arrays, count, what):
    for name, values in (arrays or {}).items():
        values = fill_masked(values, f"{what} {name!r}")
        if values.ndim == 0 or len(values) != count:
            there = len(values) if values.ndim else "no"
            raise ValueError(f"{what} {name!r}: has {there} values for {count} of them")
        attributes.AddArray(to_vtk(values, name, f"{what} {name!r}"))


def _make_cells(blocks, points):
    """A vtkCellArray of blocks of connectivity."""
    ids, ends = join_corners(blocks, points)
    cells = vtkCellArray()
    make = numpy_to_vtk if ids.dtype == np.int32 else numpy_to_vtkIdTypeArray
    # A copy, so that the cells do not depend on arrays of the caller.
    cells.SetData(make(ends, deep=True), make(ids, deep=True))
    return cells


def _make_grid(blocks, points):
    grid = vtkUnstructuredGrid()
    types = [np.full(len(corners), number, np.uint8) for number, corners in blocks]
    types = np.concatenate([np.empty(0, np.uint8)] + types)
    cells = _make_cells([corners for _, corners in blocks], points)
    grid.SetCells(numpy_to_vtk(types, deep=True, array_type=VTK_UNSIGNED_CHAR), cells)
    return grid


def _make_surface(blocks, points):
    """A vtkPolyData. Its lists have an order of their own, in which blocks have to be."""
    places = [LIST_OF_TYPE[n] if 0 <= n < len(LIST_OF_TYPE) else -1 for n, _ in blocks]
    if -1 in places:
        name = NAMES.get(blocks[places.index(-1)][0], blocks[places.index(-1)][0])
        raise ValueError(f"cells: a surface has no {name!r}")
    if places != sorted(places):
        raise ValueError("cells: a surface has vertices first, then lines, polygons and strips")
    surface = vtkPolyData()
    for i, (name, *_) in enumerate(SURFACE_LISTS):
        some = [corners for place, (_, corners) in zip(places, blocks) if place == i]
        if some:
            getattr(surface, f"Set{name}")(_make_cells(some, points))
    return surface


def from_numpy(
    points: ArrayLike,
    cells: np.ndarray | Mapping[CellType, ArrayLike] | Iterable[tuple[CellType, ArrayLike]],
    *,
    point_data: Mapping[str, ArrayLike] | None = None,
    cell_data: Mapping[str, ArrayLike | Sequence[ArrayLike]] | None = None,
    field_data: Mapping[str, ArrayLike | str] | None = None,
    surface: bool = False,
) -> vtkUnstructuredGrid | vtkPolyData:
    """Makes a mesh of VTK from NumPy arrays.

    Args:
        points: coordinates, n x 3 (or n x 2, with 0 as the third), of floats.
        cells: an array m x 4 of tetrahedra; a dictionary from the type of cells to their
            connectivity; or a list of pairs of both. Types have the names of meshio, as ``"tetra"``,
            ``"hexahedron"``, ``"wedge"``, ``"pyramid"``, ``"triangle"`` and ``"quad"``, or VTK's numbers.
        point_data: arrays of n values or rows by name.
        cell_data: arrays by name, over all cells in the order of ``cells``, or lists with an array
            for each block of ``cells``.
        field_data: other arrays, texts and lists of texts by name.
        surface: whether to make a vtkPolyData, of vertices, lines, triangles, quadrilaterals,
            polygons and strips, in this order, in place of a vtkUnstructuredGrid.

    Returns:
        The mesh, with copies of all arrays. Masked values of floats become NaN, with a warning;
        booleans become bytes, and floats of 16 bits those of 32.

    Raises:
        ValueError: arrays that do not fit together.
    """
    points = as_points(points)
    blocks = list_blocks(cells)
    make = _make_surface if surface else _make_grid
    mesh = make(blocks, len(points))
    coordinates = vtkPoints()
    coordinates.SetData(to_vtk(points, "Points", "points"))
    mesh.SetPoints(coordinates)
    sizes = [len(corners) for _, corners in blocks]
    _add_arrays(mesh.GetPointData(), point_data, len(points), "point_data")
    _add_arrays(mesh.GetCellData(), join_blocks(cell_data, sizes), sum(sizes), "cell_data")
    for name, values in (field_data or {}).items():
        what = f"field_data {name!r}"
        values = np.atleast_1d(fill_masked(values, what))
        mesh.GetFieldData().AddArray(to_vtk(values, name, what))
    return mesh


def image_from_numpy(
    values: ArrayLike,
    *,
    spacing: Sequence[float] = (1.0, 1.0, 1.0),
    origin: Sequence[float] = (0.0, 0.0, 0.0),
    name: str = "values",
) -> vtkImageData:
    """Makes a vtkImageData from a 3D array.

    Args:
        values: the voxels as ``values[z, y, x]``.
        spacing: the distances of voxels along x, y and z.
        origin: the coordinates of ``values[0, 0, 0]``.
        name: the name of the point array.

    Returns:
        The volume, with a copy of the array.
    """
    values = fill_masked(values, "values")
    if values.ndim != 3:
        raise ValueError(f"values: has to have 3 dimensions, and has {values.ndim}")
    image = vtkImageData()
    image.SetDimensions(values.shape[::-1])
    image.SetSpacing(spacing)
    image.SetOrigin(origin)
    image.GetPointData().SetScalars(to_vtk(values.reshape(-1), name, "values"))
    return image


# ------------------------------------------------------------------------------
# From VTK


def _get_arrays(attributes, count, copy):
    arrays = {}
    for i in range(attributes.GetNumberOfArrays()):
        array = attributes.GetAbstractArray(i)
        name = array.GetName() or f"array {i}"
        if array.GetNumberOfTuples() != count:
            raise ValueError(f"{name}: has {array.GetNumberOfTuples()} values for {count} of them")
        arrays[name] = _to_values(array, copy)
    return arrays


def _get_field_data(data, copy):
    arrays = {}
    for i in range(data.GetNumberOfArrays()):
        array = data.GetAbstractArray(i)
        values = _to_values(array, copy)
        arrays[array.GetName() or f"array {i}"] = values if isinstance(array, vtkDataArray) else values.tolist()
    return arrays


def get_cell_lists(mesh):
    """Pairs of the types of some cells and their vtkCellArray, in the order of the cells."""
    if isinstance(mesh, vtkUnstructuredGrid):
        return [(get_types(mesh), mesh.GetCells())] if mesh.GetNumberOfCells() else []
    lists = []
    for name, known, other in SURFACE_LISTS:
        cells = getattr(mesh, f"Get{name}")()
        if cells.GetNumberOfCells():
            # Not by mesh.GetCellType, which ends the process where cells have no points.
            types = find_types(np.diff(get_values(cells.GetOffsetsArray())), known, other)
            lists.append((types, cells))
    return lists


def _make_blocks(mesh, copy):
    """Blocks of cells of one type and size, and the ids of the cells of each."""
    blocks = []
    first = 0
    for types, cells in get_cell_lists(mesh):
        if np.any(types == POLYHEDRON):
            raise ValueError("polyhedra have no fixed number of points, and no array holds them")
        offsets = _to_values(cells.GetOffsetsArray(), copy=False)
        ids = _to_values(cells.GetConnectivityArray(), copy=False)
        sizes = np.diff(offsets)
        keys, starts, kinds = np.unique(
            np.column_stack([types, sizes]), axis=0, return_index=True, return_inverse=True
        )
        for kind in np.argsort(starts):
            number, size = keys[kind]
            chosen = np.flatnonzero(kinds.ravel() == kind)
            if len(chosen) == len(types):
                corners = ids[offsets[0] : offsets[-1]].reshape(len(types), size)
                corners = corners.copy() if copy else corners
            else:
                corners = ids[offsets[chosen][:, None] + np.arange(size)]
            name = NAMES.get(number) or vtkGenericCell.InstantiateCell(int(number)).GetClassName()
            blocks.append((name, corners, first + chosen))
        first += len(types)
    return blocks


def to_numpy(mesh: vtkUnstructuredGrid | vtkPolyData, *, copy: bool = True) -> Mesh:
    """Returns a vtkUnstructuredGrid or vtkPolyData as a ``gatun.Mesh`` of NumPy arrays.

    There is one block of cells for each type (and size, of polygons), by first appearance. Within a
    block, cells keep their order.

    Args:
        mesh: the mesh.
        copy: whether all values are copied. With False, arrays share the memory of the mesh where they
            can, and keep it alive: changing one changes the mesh, and none may be used once VTK has
            resized the array that it is of.

    Raises:
        TypeError: it is no mesh.
        ValueError: the mesh has polyhedra.
    """
    if not isinstance(mesh, (vtkUnstructuredGrid, vtkPolyData)):
        raise TypeError(f"a {type(mesh).__name__} is no vtkUnstructuredGrid and no vtkPolyData")
    points = mesh.GetPoints()
    blocks = _make_blocks(mesh, copy)
    cell_data = _get_arrays(mesh.GetCellData(), mesh.GetNumberOfCells(), copy)
    return Mesh(
        points=_to_values(points.GetData(), copy) if points else np.empty((0, 3)),
        cells=[(name, corners) for name, corners, _ in blocks],
        point_data=_get_arrays(mesh.GetPointData(), mesh.GetNumberOfPoints(), copy),
        cell_data={
            name: [values[ids] for _, _, ids in blocks] for name, values in cell_data.items()
        },
        field_data=_get_field_data(mesh.GetFieldData(), copy),
    )


def image_to_numpy(
    image: vtkImageData, name: str | None = None, *, copy: bool = True
) -> np.ndarray:
    """Returns an array of a vtkImageData as ``values[z, y, x]``, or ``values[z, y, x, component]``.

    Args:
        image: the volume.
        name: the name of the point array. Default: the active scalars, or the only array.
        copy: whether the values are copied; see ``to_numpy``.
    """
    if not isinstance(image, vtkImageData):
        raise TypeError(f"a {type(image).__name__} is no vtkImageData")
    data = image.GetPointData()
    array = data.GetArray(name) if name else data.GetScalars() or data.GetArray(0)
    if array is None:
        raise ValueError(f"the volume has no array {name!r}" if name else "the volume has no array")
    values = _to_values(array, copy)
    return values.reshape(image.GetDimensions()[::-1] + values.shape[1:])
