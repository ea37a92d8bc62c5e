# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Files of meshes, written without VTK."""

from __future__ import annotations

import ctypes
import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _library as _c
from ._cells import CellType, as_points
from ._description import Array
from ._fields import Fields
from ._library import Call, check, encode, library
from ._meshes import CellInput, StepInput, describe, take_values
from ._targets import check_target, find_order, find_profile
from ._types import Names, Path

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

_LAYERS_BY_HISTOGRAM = 3

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
        tolerances: as for ``write_mesh``.
    """

    def __init__(self, descriptions, tolerances):
        self._known = {(array.key, array.is_cell): array for array in descriptions}
        self._tolerances = {"*": tolerances} if isinstance(tolerances, str) else dict(tolerances or {})
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

    def describe(self, values):
        """Structures of the library, and what has to be kept with them.

        Args:
            values: of the first step, for hierarchies and layers, or None.
        """
        descriptions = [describe(array) for array in self.list]
        rest = dict(self._tolerances)
        everything = rest.pop("*", None)
        for array, description, own in zip(self.list, descriptions, values or [None] * len(self.list)):
            bound = rest.pop(array.key, self._tolerances.get(array.key))
            if bound is None and array.dtype.kind == "f":
                bound = everything
            if bound is not None:
                if not isinstance(bound, str):
                    raise ValueError(
                        f"tolerances: {bound!r} of {array.key!r} has to be a text such as 'rel:1e-3'"
                    )
                description.structure.error = bound.encode()
            if own is not None:
                description.structure.values = own.ctypes.data
        if rest:
            raise ValueError(f"tolerances: there is no array {next(iter(rest))!r}")
        structures = (_c.Array * len(descriptions))(*(d.structure for d in descriptions))
        return structures, descriptions

    def find(self, name):
        """The number of a point array."""
        for number, array in enumerate(self.list):
            if array.key == name and not array.is_cell:
                return number
        raise ValueError(f"layers: there is no point array {name!r}")


def make_options(
    arrays,
    points_move,
    *,
    keep_order="none",
    profile="fast",
    hierarchy=False,
    levels=0,
    layers=None,
    boundary=False,
    dependencies=False,
    chunk_size=0,
    key_step_interval=8,
):
    """The options of the library, of those of ``write_mesh``."""
    if not 0 <= levels <= 64:
        raise ValueError(f"levels: {levels} is not from 0 to 64")
    if chunk_size != 0 and not 64 <= chunk_size <= 1048576:
        raise ValueError(f"chunk_size: {chunk_size} is neither 0 nor from 64 to 1048576")
    if key_step_interval < 1:
        raise ValueError(f"key_step_interval: {key_step_interval} is not above 0")
    options = _c.Options(
        keep_order=find_order(keep_order),
        # The library counts from the fast one, and VTK from the small one.
        profile=1 - find_profile(profile),
        chunk_size=chunk_size,
        key_step_interval=key_step_interval,
        points_move=bool(points_move),
        boundary=bool(boundary),
        hierarchy=bool(hierarchy),
        levels=levels,
        dependencies=bool(dependencies),
    )
    if layers is not None:
        name, count = (layers, 0) if isinstance(layers, str) else layers
        if not 0 <= count <= 4096:
            raise ValueError(f"layers: {count} is not from 0 to 4096")
        options.layers = _LAYERS_BY_HISTOGRAM
        options.layer_array = arrays.find(name)
        options.layer_component = 0 if arrays.list[options.layer_array].components == 1 else -1
        options.layer_count = count
    return options


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
            first here, too; what the file has already, as the same mesh, is stored once. Options of
            the file stay.
        tolerances: how much arrays may change; as for ``gatun.write``.
        points_move: whether each step has coordinates of its own.
        arrays, point_array: descriptions of arrays and of the points with names, roles and keys to keep,
            as ``File.arrays`` and ``File.point_array`` have them.
        options: ``keep_order``, ``profile``, ``hierarchy``, ``levels``, ``layers``, ``boundary``,
            ``dependencies``, ``chunk_size`` and ``key_step_interval``, as for ``write_mesh``.
    """

    def __init__(
        self,
        path: Path,
        *,
        overwrite: bool = False,
        append: bool = False,
        tolerances: str | Mapping[str, str] | None = None,
        points_move: bool = False,
        arrays: Iterable[Array] = (),
        point_array: Array | None = None,
        **options: Any,
    ) -> None:
        check_target(path, overwrite or append, ".gtn")
        self._pointer = ctypes.c_void_p()
        self._path = os.fsdecode(path)
        self._points_move = bool(points_move)
        self._options = options
        self._point_array = point_array
        self._mesh = None
        self._meshes = {}  # by number
        self._kept = []  # what the library refers to until the end
        self._is_done = False
        self._arrays = ArrayList(arrays, tolerances)
        make_options(self._arrays, points_move, **{**options, "layers": None})  # or an error
        if append:
            self._append()

    def _append(self):
        from ._file import File

        if self._options:
            raise ValueError(f"{', '.join(self._options)}: a file keeps its options")
        with File(self._path) as file:
            self._arrays.list = list(file.arrays)
            self._points_move = bool(file.info["pointsMove"])
        check(library.gatun_append(encode(self._path), None, 0, None, ctypes.byref(self._pointer)), self._path)

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
        progress: Progress | None = None,
    ) -> int:
        """Adds a mesh for the next steps. Returns its number. The arrays stay in use until the file is complete.

        Args:
            points, cells: as for ``gatun.from_numpy``.
            connectivity, offsets, types, faces, face_locations: in place of ``cells``, as the members of
                ``gatun.Grid``.
            surface: whether the file is one of a surface (vtkPolyData): vertices first, then lines,
                polygons and strips.
            progress: as for ``File.read``.
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
        number = ctypes.c_uint32(0)
        if self._pointer:
            self._call(
                library.gatun_add_mesh,
                ctypes.byref(mesh.structure),
                None,
                progress=progress,
                tail=(ctypes.byref(number),),
            )
        self._mesh = self._meshes[number.value] = mesh
        return number.value

    def use_mesh(self, number: int) -> None:
        """Selects the mesh of the next steps: the last or the first one.

        Args:
            number: of the mesh, from 0.
        """
        self._check()
        if number not in self._meshes:
            raise ValueError(f"there is no mesh {number}")
        check(library.gatun_use_mesh(self._pointer, number), self._path)
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
        if not self._pointer:
            self._create(values, progress)
        if points is not None:
            if not self._points_move:
                raise ValueError("points: need a file whose points move")
            points = np.ascontiguousarray(as_points(points), self._mesh.points.dtype)
            if len(points) != counts[False]:
                raise ValueError(f"points: there are {len(points)} in place of {counts[False]}")
        step = StepInput(
            values, Fields(field_data), None if time is None else float(time), points, cells, rest
        )
        self._call(library.gatun_write_step, ctypes.byref(step.structure), progress=progress)

    def _create(self, values, progress):
        structures, descriptions = self._arrays.describe(values)
        self._kept += [structures, descriptions, values]
        options = make_options(self._arrays, self._points_move, **self._options)
        call = Call(progress)
        status = library.gatun_create(
            encode(self._path),
            ctypes.byref(self._mesh.structure),
            structures,
            len(structures),
            ctypes.byref(options),
            *call.arguments,
            ctypes.byref(self._pointer),
        )
        call.check(status, self._path)

    def _check(self):
        if self._is_done:
            raise ValueError("the file is complete, or has been given up")

    def _call(self, function, *arguments, progress=None, tail=()):
        call = Call(progress)
        call.check(function(self._pointer, *arguments, *call.arguments, *tail), self._path)

    def finish(self) -> int:
        """Completes the file. Returns its size in bytes."""
        self._check()
        if not self._pointer:
            if self._mesh is None:
                raise ValueError("there is no mesh to write")
            self._create([], None)
        pointer, self._pointer = self._pointer, ctypes.c_void_p()
        self._is_done = True
        size = ctypes.c_uint64()
        try:
            check(library.gatun_finish(pointer, ctypes.byref(size)), self._path)
        finally:
            self._release()
        return size.value

    def discard(self) -> None:
        """Gives the file up. One that is there stays as it was."""
        pointer, self._pointer = self._pointer, ctypes.c_void_p()
        self._is_done = True
        if pointer:
            library.gatun_discard(pointer)
        self._release()

    def _release(self):
        self._kept.clear()
        self._meshes.clear()
        self._mesh = None

    def __enter__(self) -> Writer:
        return self

    def __exit__(self, kind: object, *_: object) -> None:
        if kind is not None:
            self.discard()
        elif not self._is_done:
            self.finish()

    def __del__(self):
        if getattr(self, "_pointer", None):
            self.discard()


def split_steps(data, count, what):
    """For each step the arrays of it, of arrays with an entry for each step."""
    for name, values in (data or {}).items():
        if len(values) != count:
            raise ValueError(f"{what} {name!r}: has {len(values)} entries for {count} times")
    return [{name: values[i] for name, values in (data or {}).items()} for i in range(count)]


def write_mesh(
    path: Path,
    points: ArrayLike,
    cells: np.ndarray | Mapping[CellType, ArrayLike] | Iterable[tuple[CellType, ArrayLike]] | None = None,
    *,
    connectivity: ArrayLike | None = None,
    offsets: ArrayLike | None = None,
    types: ArrayLike | None = None,
    faces: ArrayLike | None = None,
    face_locations: ArrayLike | None = None,
    surface: bool = False,
    point_data: Data | None = None,
    cell_data: Data | None = None,
    field_data: Data | None = None,
    times: Sequence[float] | None = None,
    overwrite: bool = False,
    tolerances: str | Mapping[str, str] | None = None,
    profile: str = "fast",
    keep_order: bool | Names = "none",
    hierarchy: bool = False,
    levels: int = 0,
    layers: str | tuple[str, int] | None = None,
    boundary: bool = False,
    dependencies: bool = False,
    chunk_size: int = 0,
    key_step_interval: int = 8,
    arrays: Iterable[Array] = (),
    point_array: Array | None = None,
    progress: Progress | None = None,
) -> int:
    """Writes a mesh to a .gtn file without VTK.

    Args:
        path: the file to write, with the extension .gtn.
        points, cells, connectivity, offsets, types, faces, face_locations, surface: as for
            ``Writer.add_mesh``.
        point_data, cell_data, field_data: as for ``Writer.write_step``.
        times: the times of steps. Then each array of ``point_data`` and ``cell_data`` is a sequence with
            the values of each step.
        overwrite: whether to replace a file that is there.
        tolerances: how much arrays may change, as for ``gatun.write``.
        profile: ``"fast"`` optimizes the file for reading speed, ``"small"`` for size.
        keep_order: the original order that the file keeps: ``"none"``, ``"points"``, ``"cells"``,
            ``"corners"`` or ``"all"``, or a list of these. True is ``"all"``.
        hierarchy: whether the mesh can be read and drawn with any number of points.
        levels: largest number of coarser meshes to store, 0 to 64. Above 0, it includes the hierarchy.
        layers: a point array by whose values the file is organized, for isosurfaces; or a pair of it
            and the largest number of layers, 0 (automatic) to 4096.
        boundary: whether to store the boundary of the mesh, too.
        dependencies: whether to store those of the hierarchy, for view-dependent simplification.
        chunk_size: largest number of cells in a chunk, 64 to 1048576, or 0 (automatic).
        key_step_interval: number of time steps from one that needs no other step to the next.
        arrays, point_array: as for ``Writer``.
        progress: as for ``File.read``.

    Returns:
        The size of the file in bytes.

    Raises:
        OSError: the file cannot be written; FileExistsError: there is a file.
        ValueError: a parameter or data that do not fit.
    """
    writer = Writer(
        path,
        overwrite=overwrite,
        tolerances=tolerances,
        arrays=arrays,
        point_array=point_array,
        profile=profile,
        keep_order=keep_order,
        hierarchy=hierarchy,
        levels=levels,
        layers=layers,
        boundary=boundary,
        dependencies=dependencies,
        chunk_size=chunk_size,
        key_step_interval=key_step_interval,
    )
    try:
        writer.add_mesh(
            points,
            cells,
            connectivity=connectivity,
            offsets=offsets,
            types=types,
            faces=faces,
            face_locations=face_locations,
            surface=surface,
        )
        if times is None:
            writer.write_step(
                point_data=point_data, cell_data=cell_data, field_data=field_data, progress=progress
            )
        else:
            times = list(times)
            steps = zip(
                times,
                split_steps(point_data, len(times), "point_data"),
                split_steps(cell_data, len(times), "cell_data"),
            )
            for time, own_points, own_cells in steps:
                writer.write_step(
                    point_data=own_points,
                    cell_data=own_cells,
                    field_data=field_data,
                    time=time,
                    progress=progress,
                )
        return writer.finish()
    except BaseException:
        writer.discard()
        raise
