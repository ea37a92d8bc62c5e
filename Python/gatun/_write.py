# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Files of meshes, written without VTK."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from ._cells import CellType, as_points
from ._description import Array
from ._field_input import Fields
from ._meshes import CellInput, StepInput, take_values
from ._output import Options, Output
from ._targets import check_target
from ._types import Path

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

#: A function of the fraction from 0 to 1 that is done, which may return False to stop.
Progress = Callable[[float], Any]

#: Arrays by name.
Data = Mapping[str, Any]


def _list_data(point_data, cell_data):
    """Triples of a name, whether it is of cells, and values."""
    points = [(name, False, values) for name, values in (point_data or {}).items()]
    return points + [(name, True, values) for name, values in (cell_data or {}).items()]


class ArrayList:
    """The arrays of a file that is being written.

    Args:
        descriptions: of arrays with names, roles and keys to keep, as ``File.arrays`` has them.
    """

    def __init__(self, descriptions):
        self._known = {(array.key, array.is_cell): array for array in descriptions}
        self.list = []

    def take(self, point_data, cell_data, counts):
        """The values of a step, in the order of the arrays. The first step says which there are."""
        given = {(name, is_cell): values for name, is_cell, values in _list_data(point_data, cell_data)}
        if not self.list:
            self._begin(given, counts)
        taken = []
        for array in self.list:
            what = f"{'cell' if array.is_cell else 'point'}_data {array.key!r}"
            if (array.key, array.is_cell) not in given:
                raise ValueError(f"{what}: is missing")
            values = given.pop((array.key, array.is_cell))
            taken.append(take_values(values, what, counts[array.is_cell], array))
        if given:
            (name, is_cell), *_ = given
            what = f"{'cell' if is_cell else 'point'}_data {name!r}"
            raise ValueError(f"{what}: is none of the first step or of the file")
        return taken

    def _begin(self, given, counts):
        order = {key: number for number, key in enumerate(self._known)}
        for key in sorted(given, key=lambda key: order.get(key, len(order))):
            name, is_cell = key
            values = take_values(given[key], f"array {name!r}", counts[is_cell])
            known = self._known.get(key) or Array(name, name, is_cell, values.dtype, 0)
            components = int(np.prod(values.shape[1:], dtype=int))
            self.list.append(
                Array(
                    known.name,
                    name,
                    is_cell,
                    values.dtype,
                    components,
                    known.component_names if known.components == components else (),
                    known.roles,
                    known.vtk_type if known.dtype == values.dtype else 0,
                    known.keys,
                )
            )


class Writer:
    """Writes a mesh with time steps, or several meshes with steps of their own, to a .gtn file.

        >>> with gatun.Writer("series.gtn") as writer:
        ...     writer.add_mesh(points, tets)
        ...     for time in times:
        ...         writer.write_step(point_data={"pressure": solve(time)}, time=time)

    The file appears once the block has ended; an exception in it leaves nothing behind. The first
    step says which arrays there are. One thread at a time may use a writer.

    Args:
        path: the file to write, with the extension .gtn.
        overwrite: whether to replace a file that is there.
        append: whether to add steps to the file, which has to exist and have time. ``add_mesh`` comes
            first here, too; what the file has already, as the same mesh, is stored once.
        points_move: whether each step has coordinates of its own.
        arrays, point_array: descriptions of arrays and of the points with names, roles and keys to keep,
            as ``File.arrays`` and ``File.point_array`` have them.
        options: ``tolerances``, ``keep_order``, ``profile``, ``hierarchy``, ``levels``, ``dependencies``, ``layers``,
            ``boundary``, ``chunk_size`` and ``key_step_interval``, as for ``gatun.write``. Of a file that
            is appended to, the order, the profile, the chunk size and the interval stay.
    """

    def __init__(
        self,
        path: Path,
        *,
        overwrite: bool = False,
        append: bool = False,
        points_move: bool = False,
        arrays: Iterable[Array] = (),
        point_array: Array | None = None,
        **options: Any,
    ) -> None:
        check_target(path, overwrite or append, ".gtn")
        self._path = os.fsdecode(path)
        self._points_move = bool(points_move)
        self._point_array = point_array
        self._mesh = None
        self._meshes = []
        self._numbers = []  # of the meshes in the file; those of the last one may wait for its first step
        self._is_done = False
        self._arrays = ArrayList(arrays)
        self._output = Output(self._path, Options(**options))
        if append:
            self._append()

    def _append(self):
        from ._file import File

        with File(self._path) as file:
            self._arrays.list = list(file.arrays)
        self._output.append(self._arrays.list, self._points_move)

    def add_mesh(
        self,
        points: ArrayLike,
        cells: np.ndarray | Mapping[CellType, ArrayLike] | Iterable[tuple[CellType, ArrayLike]] | None = None,
        *,
        connectivity: ArrayLike | None = None,
        offsets: ArrayLike | None = None,
        types: ArrayLike | None = None,
        faces: ArrayLike | None = None,
        face_locations: ArrayLike | None = None,
        surface: bool = False,
    ) -> int:
        """Adds a mesh for the next steps. Returns its number. The arrays stay in use until the file is complete.

        Args:
            points, cells: as for ``gatun.from_numpy``.
            connectivity, offsets, types, faces, face_locations: in place of ``cells``, as the members of
                ``gatun.Grid``.
            surface: whether the file is one of a surface (vtkPolyData): vertices first, then lines,
                polygons and strips.
        """
        self._check()
        mesh = CellInput(
            points,
            cells,
            connectivity=connectivity,
            offsets=offsets,
            types=types,
            faces=faces,
            face_locations=face_locations,
            is_surface=surface,
            point_array=self._point_array,
        )
        if len(self._numbers) < len(self._meshes):
            raise ValueError("the mesh before has no step")
        self._mesh = mesh
        self._meshes.append(mesh)
        return len(self._meshes) - 1

    def use_mesh(self, number: int) -> None:
        """Selects the mesh of the next steps: the last or the first one.

        Args:
            number: of the mesh, from 0.
        """
        self._check()
        if not 0 <= number < len(self._numbers):
            raise ValueError(f"there is no mesh {number} with a step")
        self._output.use_mesh(self._numbers[number])
        self._mesh = self._meshes[number]

    def write_step(
        self,
        *,
        point_data: Data | None = None,
        cell_data: Data | None = None,
        field_data: Data | None = None,
        time: float | None = None,
        points: ArrayLike | None = None,
        remaining_cells: ArrayLike | None = None,
        remaining_points: ArrayLike | None = None,
        progress: Progress | None = None,
    ) -> None:
        """Writes a step. A mesh without time has one.

        Args:
            point_data, cell_data: arrays by name, with a value or row for each point or cell.
            field_data: other arrays, texts and lists of texts by name.
            time: of the step, after that of the one before.
            points: coordinates, if points move; default: those of the mesh.
            remaining_cells: the numbers of the cells that are still there, ascending, if some have been
                deleted. Values are those of these cells.
            remaining_points: the same of the points, which then lose the others.
            progress: as for ``File.read``.
        """
        self._check()
        if self._mesh is None:
            raise ValueError("there is no mesh; add_mesh comes first")
        cells, rest = (
            None if numbers is None else np.ascontiguousarray(numbers, np.uint64)
            for numbers in (remaining_cells, remaining_points)
        )
        if rest is not None and cells is None:
            raise ValueError("remaining_points: needs remaining_cells")
        counts = {
            False: len(self._mesh.points) if rest is None else len(rest),
            True: self._mesh.count if cells is None else len(cells),
        }
        values = self._arrays.take(point_data, cell_data, counts)
        if len(self._numbers) < len(self._meshes):
            self._put_mesh(values, progress)
        if points is not None:
            if not self._points_move:
                raise ValueError("points: need a file whose points move")
            points = np.ascontiguousarray(as_points(points), self._mesh.points.dtype)
            if len(points) != counts[False]:
                raise ValueError(f"points: there are {len(points)} in place of {counts[False]}")
        step = StepInput(
            values, Fields(field_data), None if time is None else float(time), points, cells, rest
        )
        self._output.write_step(step, progress)

    def _put_mesh(self, values, progress=None):
        """Puts the last mesh into the file. Values: of its first step, or None."""
        number = 0
        if self._output.is_open:
            number = self._output.add_mesh(self._mesh, values, progress)
        else:
            self._output.create(self._mesh, self._arrays.list, values, self._points_move, progress)
        self._numbers.append(number)

    def _check(self):
        if self._is_done:
            raise ValueError("the file is complete, or has been given up")

    def finish(self) -> int:
        """Completes the file. Returns its size in bytes."""
        self._check()
        if not self._output.is_open:
            if self._mesh is None:
                raise ValueError("there is no mesh to write")
            self._put_mesh(None)
        self._is_done = True
        return self._output.finish()

    def discard(self) -> None:
        """Gives the file up. One that is there stays as it was."""
        self._is_done = True
        self._output.discard()

    def __enter__(self) -> Writer:
        return self

    def __exit__(self, kind: object, *_: object) -> None:
        if kind is not None:
            self.discard()
        elif not self._is_done:
            self.finish()
