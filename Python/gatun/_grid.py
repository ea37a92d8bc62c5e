# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""What has been read from the file of a mesh."""

from __future__ import annotations

import dataclasses
from typing import Any, Optional

import numpy as np

from ._cells import NAMES, POLYHEDRON, Mesh


@dataclasses.dataclass
class Grid:
    """Points and cells as NumPy arrays, in the layout of vtkUnstructuredGrid.

    Attributes:
        points: coordinates, n x 3.
        connectivity: the points of all cells, one cell after the other.
        offsets: for each of m cells where its points begin in ``connectivity``, and where the last
            one's end.
        types: of the cells, numbers of VTK.
        faces, face_locations: of polyhedra: for each cell where its faces begin in ``faces``, or -1:
            the number of faces, and for each one the number of its points, and them. None without
            polyhedra.
        point_data, cell_data: the arrays of points and cells by name, with a value or row for each.
            If names repeat, the later ones have `` (2)`` and so on at their ends.
        field_data: other arrays by name; lists of strings where they hold text.
        point_ids, cell_ids: the numbers that they had when they were written, as far as the file
            keeps them; None unless asked for.
        point_ghosts, cell_ghosts: 1 where points and cells belong to another piece; None unless the
            piece has ghosts or is one of several.
        normals: of isosurfaces, n x 3; None unless asked for.
        time: of the step, or None.
        is_surface: whether it is a surface (vtkPolyData): of the file of one, a contour or a slice.
    """

    points: np.ndarray
    connectivity: np.ndarray
    offsets: np.ndarray
    types: np.ndarray
    faces: Optional[np.ndarray] = None
    face_locations: Optional[np.ndarray] = None
    point_data: dict[str, np.ndarray] = dataclasses.field(default_factory=dict)
    cell_data: dict[str, np.ndarray] = dataclasses.field(default_factory=dict)
    field_data: dict[str, Any] = dataclasses.field(default_factory=dict)
    point_ids: Optional[np.ndarray] = None
    cell_ids: Optional[np.ndarray] = None
    point_ghosts: Optional[np.ndarray] = None
    cell_ghosts: Optional[np.ndarray] = None
    normals: Optional[np.ndarray] = None
    time: Optional[float] = None
    is_surface: bool = False

    @property
    def cells(self) -> list[tuple[str, np.ndarray]]:
        """Blocks of cells, as ``gatun.Mesh`` has them: one for each run of cells of a type and size.

        Raises:
            ValueError: there are polyhedra.
        """
        if np.any(self.types == POLYHEDRON):
            raise ValueError("polyhedra have no fixed number of points, and no array holds them")
        sizes = np.diff(self.offsets)
        differs = (self.types[1:] != self.types[:-1]) | (sizes[1:] != sizes[:-1])
        starts = np.flatnonzero(np.concatenate([[len(sizes) > 0], differs]))
        blocks = []
        for start, end in zip(starts, [*starts[1:], len(sizes)]):
            corners = self.connectivity[self.offsets[start] : self.offsets[end]]
            number = int(self.types[start])
            blocks.append((NAMES.get(number, number), corners.reshape(end - start, sizes[start])))
        return blocks

    def to_mesh(self) -> Mesh:
        """The same as a ``gatun.Mesh``, which shares its arrays.

        Raises:
            ValueError: there are polyhedra.
        """
        blocks = self.cells
        ends = np.cumsum([len(corners) for _, corners in blocks])[:-1]
        cell_data = {name: np.split(values, ends) if blocks else [] for name, values in self.cell_data.items()}
        return Mesh(self.points, blocks, dict(self.point_data), cell_data, dict(self.field_data))
