# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Meshes and volumes from NumPy arrays, and back."""

from __future__ import annotations

import collections.abc
import dataclasses
import functools
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Union

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_UNSIGNED_CHAR, vtkPoints
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray,
    vtkImageData,
    vtkPolyData,
    vtkUnstructuredGrid,
)

try:
    from vtkmodules.vtkCommonDataModel import vtkCellTypeUtilities as _cell_types
except ImportError:  # before VTK 9.6
    from vtkmodules.vtkCommonDataModel import vtkCellTypes as _cell_types

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

#: The name of a type of cells, or VTK's number.
CellType = Union[str, int]

# Name, number of VTK's cell type and of its points, 0 for any. The names are those of meshio.
_CELLS = {
    "vertex": (1, 1),
    "poly_vertex": (2, 0),
    "line": (3, 2),
    "poly_line": (4, 0),
    "triangle": (5, 3),
    "triangle_strip": (6, 0),
    "polygon": (7, 0),
    "pixel": (8, 4),
    "quad": (9, 4),
    "tetra": (10, 4),
    "voxel": (11, 8),
    "hexahedron": (12, 8),
    "wedge": (13, 6),
    "pyramid": (14, 5),
    "penta_prism": (15, 10),
    "hexa_prism": (16, 12),
    "line3": (21, 3),
    "triangle6": (22, 6),
    "quad8": (23, 8),
    "tetra10": (24, 10),
    "hexahedron20": (25, 20),
    "wedge15": (26, 15),
    "pyramid13": (27, 13),
    "quad9": (28, 9),
    "hexahedron27": (29, 27),
    "wedge18": (32, 18),
    "triangle7": (34, 7),
}
_NAMES = {number: name for name, (number, _) in _CELLS.items()}
_POLYHEDRON = 42


@dataclasses.dataclass
class Mesh:
    """A mesh as NumPy arrays, with the members of a ``meshio.Mesh``.

    Attributes:
        points: coordinates, n x 3.
        cells: blocks of cells, each a pair of the type's name (``"tetra"``, ``"hexahedron"``,
            ``"triangle"``, ...) and the connectivity, an array with one row for each cell.
        point_data: the arrays of the points by name, with n values or rows each.
        cell_data: the arrays of the cells by name: a list with an array for each block.
        field_data: other arrays by name; lists of strings where they hold text.
    """

    points: np.ndarray
    cells: list[tuple[str, np.ndarray]]
    point_data: dict[str, np.ndarray] = dataclasses.field(default_factory=dict)
    cell_data: dict[str, list[np.ndarray]] = dataclasses.field(default_factory=dict)
    field_data: dict[str, Any] = dataclasses.field(default_factory=dict)

    @property
    def cells_dict(self) -> dict[str, np.ndarray]:
        """The connectivity by the name of the type. Blocks of the same type are joined."""
        names = list(dict.fromkeys(name for name, _ in self.cells))
        return {
            name: np.concatenate([cells for other, cells in self.cells if other == name])
            for name in names
        }


# ------------------------------------------------------------------------------
# To VTK


def _to_vtk(values, name):
    """A VTK array of the values, which it shares if they are contiguous."""
    array = np.ascontiguousarray(values)
    if array.dtype == bool:
        array = array.view(np.uint8)
    if array.dtype.byteorder == ">":
        array = array.astype(array.dtype.newbyteorder("="))
    if array.dtype.kind not in "iuf" or array.dtype.itemsize > 8 or array.dtype == np.float16:
        raise ValueError(f"{name}: arrays of type {array.dtype} are not supported")
    result = numpy_to_vtk(array.reshape(len(array), -1) if array.ndim > 2 else array)
    # VTK would keep the memory by an attribute of the Python object. VTK 9.1 damages its list of
    # such objects where the memory belongs to an array of VTK in turn. An observer keeps it, too.
    result.__dict__.pop("_numpy_reference", None)
    result.AddObserver("UserEvent", functools.partial(_keep, array))
    result.SetName(name)
    return result


def _keep(_array, _caller, _event):
    """Does nothing; an observer of it keeps an array."""


def _add_arrays(attributes, arrays, count, what):
    for name, values in (arrays or {}).items():
        values = np.asarray(values)
        if values.ndim == 0 or len(values) != count:
            there = len(values) if values.ndim else "no"
            raise ValueError(f"{what} {name!r}: has {there} values for {count} of them")
        attributes.AddArray(_to_vtk(values, name))


def _join_blocks(cell_data, sizes):
    """Values of all cells, of arrays or of lists with an array for each block."""
    joined = {}
    for name, values in (cell_data or {}).items():
        if isinstance(values, (list, tuple)) and len(values) == len(sizes):
            parts = [np.asarray(part) for part in values]
            if all(part.ndim and len(part) == size for part, size in zip(parts, sizes)):
                values = np.concatenate(parts) if parts else np.empty(0)
        joined[name] = values
    return joined


def _number_of(kind):
    if isinstance(kind, str):
        if kind not in _CELLS:
            raise ValueError(f"cells: {kind!r} is not known; there are {', '.join(_CELLS)}")
        return _CELLS[kind][0]
    return int(kind)


def _list_blocks(cells):
    """The blocks of cells as pairs of VTK's number and a 2D array."""
    if isinstance(cells, np.ndarray):
        cells = {"tetra": cells}
    if isinstance(cells, collections.abc.Mapping):
        cells = cells.items()
    blocks = []
    for block in cells:
        # A CellBlock of meshio is no pair.
        kind, corners = (block.type, block.data) if hasattr(block, "type") else block
        number = _number_of(kind)
        corners = np.asarray(corners)
        if corners.ndim != 2 or corners.dtype.kind not in "iu":
            raise ValueError(f"cells: {kind!r} has to be an array of integers with a row per cell")
        wanted = _CELLS[_NAMES[number]][1] if number in _NAMES else 0
        if wanted and corners.shape[1] != wanted:
            raise ValueError(
                f"cells: a {_NAMES[number]!r} has {wanted} points, not {corners.shape[1]}"
            )
        blocks.append((number, corners))
    return blocks


def _make_cells(blocks, points):
    """A vtkCellArray of blocks of connectivity."""
    narrow = all(corners.dtype.itemsize <= 4 for corners in blocks) and bool(blocks)
    integer = np.int32 if narrow else np.int64
    for corners in blocks:
        if corners.size and not (corners.min() >= 0 and corners.max() < points):
            raise ValueError(f"cells: there are points from 0 to {points - 1} only")
    ids = np.concatenate([np.empty(0, integer)] + [corners.ravel() for corners in blocks])
    sizes = [np.full(len(corners), corners.shape[1], np.int64) for corners in blocks]
    ends = np.cumsum(np.concatenate([np.zeros(1, np.int64)] + sizes))
    cells = vtkCellArray()
    make = numpy_to_vtk if narrow else numpy_to_vtkIdTypeArray
    # A copy, so that the cells do not depend on arrays of the caller.
    cells.SetData(
        make(ends.astype(integer), deep=True), make(ids.astype(integer), deep=True)
    )
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
    lists = [
        ("SetVerts", (1, 2)),
        ("SetLines", (3, 4)),
        ("SetPolys", (5, 7, 9)),
        ("SetStrips", (6,)),
    ]
    places = [next((i for i, (_, kinds) in enumerate(lists) if n in kinds), -1) for n, _ in blocks]
    if -1 in places:
        name = _NAMES.get(blocks[places.index(-1)][0], blocks[places.index(-1)][0])
        raise ValueError(f"cells: a surface has no {name!r}")
    if places != sorted(places):
        raise ValueError("cells: a surface has vertices first, then lines, polygons and strips")
    surface = vtkPolyData()
    for i, (method, _) in enumerate(lists):
        some = [corners for place, (_, corners) in zip(places, blocks) if place == i]
        if some:
            getattr(surface, method)(_make_cells(some, points))
    return surface


def from_numpy(
    points: ArrayLike,
    cells: np.ndarray | Mapping[CellType, ArrayLike] | Iterable[tuple[CellType, ArrayLike]],
    *,
    point_data: Mapping[str, ArrayLike] | None = None,
    cell_data: Mapping[str, ArrayLike | Sequence[ArrayLike]] | None = None,
    field_data: Mapping[str, ArrayLike] | None = None,
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
        field_data: other arrays by name.
        surface: whether to make a vtkPolyData, of vertices, lines, triangles, quadrilaterals,
            polygons and strips, in this order, in place of a vtkUnstructuredGrid.

    Returns:
        The mesh. It shares the memory of contiguous points and data; connectivity is copied.

    Raises:
        ValueError: arrays that do not fit together.
    """
    points = np.asarray(points)
    if points.ndim != 2 or points.shape[1] not in (2, 3):
        raise ValueError(f"points: has to be n x 3, and is {' x '.join(map(str, points.shape))}")
    if points.dtype not in (np.float32, np.float64):
        points = points.astype(np.float64)
    if points.shape[1] == 2:
        points = np.column_stack([points, np.zeros(len(points), points.dtype)])
    blocks = _list_blocks(cells)
    make = _make_surface if surface else _make_grid
    mesh = make(blocks, len(points))
    coordinates = vtkPoints()
    coordinates.SetData(_to_vtk(points, "Points"))
    mesh.SetPoints(coordinates)
    sizes = [len(corners) for _, corners in blocks]
    _add_arrays(mesh.GetPointData(), point_data, len(points), "point_data")
    _add_arrays(mesh.GetCellData(), _join_blocks(cell_data, sizes), sum(sizes), "cell_data")
    for name, values in (field_data or {}).items():
        mesh.GetFieldData().AddArray(_to_vtk(np.atleast_1d(values), name))
    return mesh


def from_meshio(mesh: Any) -> vtkUnstructuredGrid:
    """Makes a vtkUnstructuredGrid from a ``meshio.Mesh``, a ``gatun.Mesh`` or an object like them.

    The object has the members ``points``, ``cells``, ``point_data`` and ``cell_data``; see ``from_numpy``.
    """
    return from_numpy(
        mesh.points,
        mesh.cells,
        point_data=mesh.point_data,
        cell_data=mesh.cell_data,
    )


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
        The volume. It shares the memory of a contiguous array.
    """
    values = np.asarray(values)
    if values.ndim != 3:
        raise ValueError(f"values: has to have 3 dimensions, and has {values.ndim}")
    image = vtkImageData()
    image.SetDimensions(values.shape[::-1])
    image.SetSpacing(spacing)
    image.SetOrigin(origin)
    image.GetPointData().SetScalars(_to_vtk(values.reshape(-1), name))
    return image


# ------------------------------------------------------------------------------
# From VTK


def _get_arrays(attributes, count):
    arrays = {}
    for i in range(attributes.GetNumberOfArrays()):
        array = attributes.GetArray(i)
        if array is not None and array.GetNumberOfTuples() == count:
            arrays[array.GetName() or f"array {i}"] = vtk_to_numpy(array)
    return arrays


def _get_field_data(data):
    arrays = {}
    for i in range(data.GetNumberOfArrays()):
        array = data.GetAbstractArray(i)
        name = array.GetName() or f"array {i}"
        if data.GetArray(i) is not None:
            arrays[name] = vtk_to_numpy(array)
        else:
            arrays[name] = [str(array.GetValue(j)) for j in range(array.GetNumberOfValues())]
    return arrays


def _get_cell_lists(mesh):
    """Pairs of the types of some cells and their vtkCellArray, in the order of the cells."""
    if isinstance(mesh, vtkUnstructuredGrid):
        # Since VTK 9.6, types may be a vtkConstantArray, for which GetCellTypesArray returns None.
        types = mesh.GetCellTypes if hasattr(mesh, "GetDistinctCellTypes") else mesh.GetCellTypesArray
        return [(vtk_to_numpy(types()), mesh.GetCells())] if mesh.GetNumberOfCells() else []
    types = np.fromiter(map(mesh.GetCellType, range(mesh.GetNumberOfCells())), np.uint8)
    lists = []
    first = 0
    for cells in (mesh.GetVerts(), mesh.GetLines(), mesh.GetPolys(), mesh.GetStrips()):
        count = cells.GetNumberOfCells()
        if count:
            lists.append((types[first : first + count], cells))
        first += count
    return lists


def _make_blocks(mesh):
    """Blocks of cells of one type and size, and the ids of the cells of each."""
    blocks = []
    first = 0
    for types, cells in _get_cell_lists(mesh):
        if np.any(types == _POLYHEDRON):
            raise ValueError("polyhedra have no fixed number of points, and no array holds them")
        offsets = vtk_to_numpy(cells.GetOffsetsArray())
        ids = vtk_to_numpy(cells.GetConnectivityArray())
        sizes = np.diff(offsets)
        keys, starts, kinds = np.unique(
            np.column_stack([types, sizes]), axis=0, return_index=True, return_inverse=True
        )
        for kind in np.argsort(starts):
            number, size = keys[kind]
            chosen = np.flatnonzero(kinds.ravel() == kind)
            if len(chosen) == len(types):
                corners = ids.reshape(-1, size)
            else:
                corners = ids[offsets[chosen][:, None] + np.arange(size)]
            name = _NAMES.get(number, _cell_types.GetClassNameFromTypeId(int(number)))
            blocks.append((name, corners, first + chosen))
        first += len(types)
    return blocks


def to_numpy(mesh: vtkUnstructuredGrid | vtkPolyData) -> Mesh:
    """Returns a vtkUnstructuredGrid or vtkPolyData as a ``gatun.Mesh`` of NumPy arrays.

    There is one block of cells for each type (and size, of polygons), by first appearance. Within a
    block, cells keep their order. The arrays share the memory of the mesh where they can, and keep
    it alive. Changing them changes the mesh.

    Raises:
        TypeError: it is no mesh.
        ValueError: the mesh has polyhedra.
    """
    if not isinstance(mesh, (vtkUnstructuredGrid, vtkPolyData)):
        raise TypeError(f"a {type(mesh).__name__} is no vtkUnstructuredGrid and no vtkPolyData")
    points = mesh.GetPoints()
    blocks = _make_blocks(mesh)
    cell_data = _get_arrays(mesh.GetCellData(), mesh.GetNumberOfCells())
    return Mesh(
        points=vtk_to_numpy(points.GetData()) if points else np.empty((0, 3)),
        cells=[(name, corners) for name, corners, _ in blocks],
        point_data=_get_arrays(mesh.GetPointData(), mesh.GetNumberOfPoints()),
        cell_data={
            name: [values[ids] for _, _, ids in blocks] for name, values in cell_data.items()
        },
        field_data=_get_field_data(mesh.GetFieldData()),
    )


def to_meshio(mesh: vtkUnstructuredGrid | vtkPolyData) -> Any:
    """Returns a vtkUnstructuredGrid or vtkPolyData as a ``meshio.Mesh``.

    Raises:
        ImportError: meshio is not installed.
    """
    import meshio  # an optional package

    arrays = to_numpy(mesh)
    return meshio.Mesh(arrays.points, arrays.cells, arrays.point_data, arrays.cell_data)


def image_to_numpy(image: vtkImageData, name: str | None = None) -> np.ndarray:
    """Returns an array of a vtkImageData as ``values[z, y, x]``, or ``values[z, y, x, component]``.

    Args:
        image: the volume.
        name: the name of the point array. Default: the active scalars, or the only array.

    Returns:
        An array that shares the memory of the volume.
    """
    if not isinstance(image, vtkImageData):
        raise TypeError(f"a {type(image).__name__} is no vtkImageData")
    data = image.GetPointData()
    array = data.GetArray(name) if name else data.GetScalars() or data.GetArray(0)
    if array is None:
        raise ValueError(f"the volume has no array {name!r}" if name else "the volume has no array")
    values = vtk_to_numpy(array)
    return values.reshape(image.GetDimensions()[::-1] + values.shape[1:])
