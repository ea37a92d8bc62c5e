# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""A mesh with its arrays, as the library takes it."""

from __future__ import annotations

import dataclasses
from typing import Optional

import numpy as np

from ._cells import join_blocks
from ._description import Array
from ._field_input import Fields
from ._meshes import CellInput, take_values
from ._meshio import list_arrays


@dataclasses.dataclass
class MeshData:
    """A mesh of one step.

    Attributes:
        mesh: points and cells.
        arrays: pairs of descriptions and values.
        fields: arrays of the whole mesh.
        time: of the step, if it has one.
        keeps_points: whether coordinates are not rounded, because they are integers.
    """

    mesh: CellInput
    arrays: list[tuple[Array, np.ndarray]]
    fields: Fields
    time: Optional[float] = None
    keeps_points: bool = False


def _take_arrays(data, is_cell, count, names):
    taken = []
    for name, values in data.items():
        if names is None or not name or name in names:
            values = take_values(values, f"{'cell' if is_cell else 'point'}_data {name!r}", count)
            components = int(np.prod(values.shape[1:], dtype=int))
            taken.append((Array(name, name, is_cell, values.dtype, components), values))
    return taken


def take_members(data, names):
    """A ``gatun.Grid``, or an object with the members of a ``meshio.Mesh``, for the library.

    Args:
        data: the object.
        names: of the arrays to take, or None for all.
    """
    if hasattr(data, "connectivity"):
        members = ("connectivity", "offsets", "types", "faces", "face_locations", "is_surface")
        mesh = CellInput(data.points, **{name: getattr(data, name) for name in members})
        point_data, cell_data, field_data = data.point_data, data.cell_data, data.field_data
    else:
        point_data, cell_data, field_data = list_arrays(data)
        mesh = CellInput(data.points, data.cells)
        cell_data = join_blocks(cell_data, mesh.sizes)
    arrays = _take_arrays(point_data, False, len(mesh.points), names)
    arrays += _take_arrays(cell_data, True, mesh.count, names)
    return MeshData(mesh, arrays, Fields(field_data), getattr(data, "time", None))
