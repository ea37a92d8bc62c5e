# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Cells and points of NumPy."""

from __future__ import annotations

import collections.abc
import dataclasses
from typing import Any, Union

import numpy as np

from ._numbers import fill_masked

#: The name of a type of cells, or VTK's number.
CellType = Union[str, int]

# Name, number of VTK's cell type and of its points, 0 for any. The names are those of meshio.
CELLS = {
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
    "VTK_LAGRANGE_CURVE": (68, 0),
    "VTK_LAGRANGE_TRIANGLE": (69, 0),
    "VTK_LAGRANGE_QUADRILATERAL": (70, 0),
    "VTK_LAGRANGE_TETRAHEDRON": (71, 0),
    "VTK_LAGRANGE_HEXAHEDRON": (72, 0),
    "VTK_LAGRANGE_WEDGE": (73, 0),
    "VTK_LAGRANGE_PYRAMID": (74, 0),
}
NAMES = {number: name for name, (number, _) in CELLS.items()}
POLYHEDRON = 42


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


def as_points(points):
    """Coordinates as n x 3 floats."""
    points = fill_masked(points, "points")
    if points.ndim != 2 or points.shape[1] not in (2, 3):
        raise ValueError(f"points: has to be n x 3, and is {' x '.join(map(str, points.shape))}")
    if points.dtype not in (np.float32, np.float64):
        points = points.astype(np.float64)
    if points.shape[1] == 2:
        points = np.column_stack([points, np.zeros(len(points), points.dtype)])
    return points


def join_blocks(cell_data, sizes):
    """Values of all cells, of arrays or of lists with an array for each block."""
    joined = {}
    for name, values in (cell_data or {}).items():
        if isinstance(values, (list, tuple)) and len(values) == len(sizes):
            parts = [np.asanyarray(part) for part in values]
            if all(part.ndim and len(part) == size for part, size in zip(parts, sizes)):
                values = np.ma.concatenate(parts) if parts else np.empty(0)
        joined[name] = values
    return joined


def _number_of(kind):
    if isinstance(kind, str):
        if kind not in CELLS:
            raise ValueError(f"cells: {kind!r} is not known; there are {', '.join(CELLS)}")
        return CELLS[kind][0]
    return int(kind)


def list_blocks(cells):
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
        if np.ma.is_masked(corners):
            raise ValueError(f"cells: {kind!r} has masked values; leave these cells out")
        corners = np.asarray(corners)
        if corners.ndim != 2 or corners.dtype.kind not in "iu":
            raise ValueError(f"cells: {kind!r} has to be an array of integers with a row per cell")
        wanted = CELLS[NAMES[number]][1] if number in NAMES else 0
        if wanted and corners.shape[1] != wanted:
            raise ValueError(
                f"cells: a {NAMES[number]!r} has {wanted} points, not {corners.shape[1]}"
            )
        blocks.append((number, corners))
    return blocks


def join_corners(blocks, points):
    """The connectivity of blocks of cells as one array, and where each cell begins in it.

    Args:
        blocks: 2D arrays of the points of cells.
        points: the number of points that there are.
    """
    narrow = all(corners.dtype.itemsize <= 4 for corners in blocks) and bool(blocks)
    integer = np.int32 if narrow else np.int64
    for corners in blocks:
        if corners.size and not (corners.min() >= 0 and corners.max() < points):
            raise ValueError(f"cells: there are points from 0 to {points - 1} only")
    ids = np.concatenate([np.empty(0, integer)] + [corners.ravel() for corners in blocks])
    sizes = [np.full(len(corners), corners.shape[1], np.int64) for corners in blocks]
    ends = np.cumsum(np.concatenate([np.zeros(1, np.int64)] + sizes))
    return ids.astype(integer), ends.astype(integer)
