# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Requests for parts of meshes, and the arrays that they fill."""

from __future__ import annotations

import ctypes

import numpy as np

from . import _library as _c
from ._fields import read_fields
from ._grid import Grid
from ._library import Buffer, Call, library
from ._numbers import check_box

# The number of points of a cell of the only type that a piece has.
_CORNERS = {5: 3, 10: 4}
_LARGEST_NARROW = 0x7FFFFFFF


def _check_number(name, value, least, most):
    """An integer that C can hold."""
    if int(value) != value or not least <= value <= most:
        raise ValueError(f"{name}: {value!r} is not from {least} to {most}")
    return int(value)


class Request:
    """A request with the memory that it refers to.

    Attributes:
        structure: the request of the library.
        step: the number of the step.
        numbers: of the arrays.
    """

    def __init__(self, step, numbers):
        self.step = step
        self.numbers = numbers
        self._array_numbers = (ctypes.c_uint32 * len(numbers))(*numbers)
        self.structure = _c.Request(
            step=step,
            flags=_c.UNUSED_POINTS,
            arrays=self._array_numbers,
            array_count=len(numbers),
        )


def make_request(
    step,
    arrays,
    *,
    piece=0,
    pieces=1,
    ghost_levels=0,
    box=None,
    values=None,
    exact=False,
    ratio=0.0,
    level=0,
    boundary=False,
    tetrahedra=False,
    restore_order=True,
    plane=None,
):
    """Returns a request, with the parameters of ``File.read``.

    Args:
        step: the number of the step.
        arrays: numbers of the arrays.
        values: number of an array, its component, smallest and largest value.
        plane: origin and normal.
    """
    made = Request(step, arrays)
    to = made.structure
    to.pieces = _check_number("pieces", pieces, 1, 0xFFFFFFFF)
    to.piece = _check_number("piece", piece, 0, pieces - 1)
    to.ghost_levels = _check_number("ghost_levels", ghost_levels, 0, 0xFFFF)
    to.level = _check_number("level", level, 0, 0xFFFFFFFF)
    if isinstance(ratio, str):
        raise TypeError(f"ratio: {ratio!r} is no number")
    to.ratio = float(ratio)
    if not 0 <= to.ratio <= 1:
        raise ValueError(f"ratio: {ratio!r} is not from 0 to 1")
    if exact and box is None and values is None:
        raise ValueError("exact: needs a box or values")
    flags = {
        _c.TETRAHEDRA: tetrahedra,
        _c.RESTORE_ORDER: restore_order,
        _c.BOUNDARY: boundary,
        _c.EXACT: exact,
    }
    for flag, is_set in flags.items():
        to.flags |= flag if is_set else 0
    if box is not None:
        to.flags |= _c.IN_BOX
        to.box[:] = check_box(box)
    if values is not None:
        to.flags |= _c.IN_RANGE
        to.range_array, to.range_component = values[:2]
        to.range[:] = values[2:]
    if plane is not None:
        to.flags |= _c.ON_PLANE
        for member, vector in zip((to.origin, to.normal), plane):
            numbers = tuple(map(float, vector))
            if len(numbers) != 3:
                raise ValueError("a point and a direction have three numbers")
            member[:] = numbers
    return made


def make_array(shape, dtype):
    """A new array. Its size comes from a file, which may be damaged."""
    try:
        return np.empty(shape, dtype)
    except ValueError as error:  # too large for NumPy, whatever the memory
        raise MemoryError(f"no memory for an array of shape {shape} ({error})") from None


class Target:
    """New arrays, and their buffers for the library."""

    def __init__(self, allocate):
        self._allocate = allocate
        self.buffers = _c.Buffers()
        self._arrays = None

    def make(self, name, dtype, shape):
        """An array of a type and shape."""
        dtype = np.dtype(dtype)
        if self._allocate is None:
            return make_array(shape, dtype)
        array = self._allocate(name, dtype, shape)
        fits = isinstance(array, np.ndarray) and array.dtype == dtype and array.shape == shape
        if not (fits and array.flags.c_contiguous and array.flags.writeable):
            raise ValueError(f"allocate: has not returned an array {name!r} of {dtype} and shape {shape}")
        return array

    def add(self, name, dtype, shape):
        """An array that the library fills as the member of a name."""
        array = self.make(name, dtype, shape)
        setattr(self.buffers, name, to_buffer(array))
        return array

    def add_values(self, arrays):
        """Makes the library fill arrays of points and cells."""
        self._arrays = (Buffer * len(arrays))(*map(to_buffer, arrays))
        self.buffers.arrays = self._arrays
        self.buffers.array_count = len(arrays)


def to_buffer(array):
    """A contiguous array of NumPy as a buffer of the library."""
    # The library takes a null pointer for a buffer that is left out.
    return Buffer(array.ctypes.data or None, array.nbytes)


def _add_cells(target, sizes, integer):
    """The arrays of the cells by their names as members of a grid."""
    cells = sizes.cells
    found = {"connectivity": target.add("connectivity", integer, (sizes.connectivity,))}
    target.buffers.wide_ids = integer is np.int64
    if sizes.cell_type:
        # The library does not want those that follow from the type.
        offsets = target.make("offsets", integer, (cells + 1,))
        corners = _CORNERS[sizes.cell_type]
        offsets[...] = np.arange(0, corners * (cells + 1), corners, dtype=integer)
        types = target.make("types", np.uint8, (cells,))
        types[...] = sizes.cell_type
        return {**found, "offsets": offsets, "types": types}
    found["offsets"] = target.add("offsets", integer, (cells + 1,))
    found["types"] = target.add("types", np.uint8, (cells,))
    if sizes.faces:
        found["face_locations"] = target.add("face_locations", np.int64, (cells,))
        found["faces"] = target.add("faces", np.int64, (sizes.faces,))
    return found


def _choose_ids(sizes, wide_ids):
    """The type of ids: one that is asked for has to be wide enough."""
    largest = max(sizes.points, sizes.connectivity)
    return np.int64 if wide_ids or largest > _LARGEST_NARROW else np.int32


def _make_grid(file, request, sizes, target, options):
    """A grid with arrays that are not filled yet."""
    wide_ids = options.get("wide_ids")
    integer = _choose_ids(sizes, file.has_wide_ids if wide_ids is None else wide_ids)
    points = target.add("points", _c.DTYPES[sizes.coordinate_type], (sizes.points, 3))
    grid = Grid(points, **_add_cells(target, sizes, integer))
    extras = []
    if options.get("ids"):
        extras += [("point_ids", sizes.points, np.int64), ("cell_ids", sizes.cells, np.int64)]
    if options.get("ghosts"):
        extras += [("point_ghosts", sizes.points, np.uint8), ("cell_ghosts", sizes.cells, np.uint8)]
    for name, count, dtype in extras:
        setattr(grid, name, target.add(name, dtype, (count,)))
    if options.get("normals"):
        grid.normals = target.add("normals", np.float32, (sizes.points, 3))
    arrays = []
    for number in request.numbers:
        array = file.arrays[number]
        where, data, count = (
            ("cell_data", grid.cell_data, sizes.cells)
            if array.is_cell
            else ("point_data", grid.point_data, sizes.points)
        )
        shape = (count,) if array.components == 1 else (count, array.components)
        data[array.key] = target.make(f"{where}/{array.key}", array.dtype, shape)
        arrays.append(data[array.key])
    target.add_values(arrays)
    return grid


def read_piece(file, handle, request, prepare, arguments, options, allocate, progress):
    """Reads a piece into a grid.

    Args:
        file: the File.
        handle: its handle.
        request: the Request.
        prepare: the function of the library that makes the piece.
        arguments: of it, between the file and the sizes.
        options: whether the grid has ``ids``, ``ghosts``, ``normals`` and ``wide_ids``, and is a ``surface``.
        allocate, progress: as for ``File.read``.
    """
    call = Call(progress)
    sizes, piece = _c.Sizes(), ctypes.c_void_p()
    # First, as the file may be closed during the calls below.
    fields = read_fields(handle, request.step)
    time = file.times[request.step] if file.has_time else None
    with handle.use() as pointer:
        handle.check(
            prepare(pointer, *arguments, ctypes.byref(sizes), *call.arguments, ctypes.byref(piece)), call
        )
        try:
            target = Target(allocate)
            grid = _make_grid(file, request, sizes, target, options)
            handle.check(
                library.gatun_read(piece, ctypes.byref(target.buffers), *call.arguments), call
            )
        finally:
            library.gatun_end(piece)
    grid.field_data = fields
    grid.time = time
    grid.is_surface = options.get("surface", file.is_surface)
    return grid
