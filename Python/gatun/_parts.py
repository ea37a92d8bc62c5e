# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Meshes that are written in parts."""

from __future__ import annotations

import ctypes
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np

from ._description import Array
from ._fields import Fields
from ._library import Call, check, encode, library
from ._meshes import CellInput, StepInput
from ._targets import check_target
from ._types import Path
from ._write import ArrayList, Progress, make_options, split_steps


class _PartWriter:
    """Writes parts twice: first they are surveyed, and then they are stored."""

    def __init__(self, path, arrays, options, progress):
        self._path = path
        self._arrays = arrays
        self._options = options
        self._progress = progress
        self.pointer = ctypes.c_void_p()

    def _create(self):
        structures, descriptions = self._arrays.describe(None)
        options = make_options(self._arrays, False, **self._options)
        status = library.gatun_create_parts(
            encode(self._path), structures, len(structures), ctypes.byref(options), ctypes.byref(self.pointer)
        )
        check(status, self._path)
        del descriptions

    def write(self, part, times, fields, is_survey):
        """Surveys or stores a part with its steps."""
        mesh = CellInput(
            part.points,
            connectivity=part.connectivity,
            offsets=part.offsets,
            types=part.types,
            faces=part.faces,
            face_locations=part.face_locations,
        )
        steps = self._list_steps(part, times, {False: len(mesh.points), True: mesh.count})
        if not self.pointer:
            self._create()
        ids = part.point_ids
        if ids is not None:
            ids = np.ascontiguousarray(ids, np.int64)
            if ids.shape != (len(mesh.points),):
                raise ValueError("point_ids: has not one number for each point")
        call = Call(self._progress)
        function = library.gatun_survey_part if is_survey else library.gatun_add_part
        address = None if ids is None else ids.ctypes.data
        call.check(function(self.pointer, ctypes.byref(mesh.structure), address, *call.arguments), self._path)
        for time, values in steps:
            self._write_step(StepInput(values, Fields(fields), time), is_survey)

    def _list_steps(self, part, times, counts):
        if times is None:
            return [(None, self._arrays.take(part.point_data, part.cell_data, counts))]
        points = split_steps(part.point_data, len(times), "point_data")
        cells = split_steps(part.cell_data, len(times), "cell_data")
        return [(t, self._arrays.take(p, c, counts)) for t, p, c in zip(times, points, cells)]

    def _write_step(self, step, is_survey):
        structure = ctypes.byref(step.structure)
        if is_survey:
            check(library.gatun_survey_step(self.pointer, structure), self._path)
        else:
            call = Call(self._progress)
            call.check(library.gatun_write_step(self.pointer, structure, *call.arguments), self._path)

    def finish(self):
        """Completes the file. Returns its size."""
        pointer, self.pointer = self.pointer, ctypes.c_void_p()
        size = ctypes.c_uint64()
        check(library.gatun_finish(pointer, ctypes.byref(size)), self._path)
        return size.value

    def discard(self):
        """Gives the file up."""
        pointer, self.pointer = self.pointer, ctypes.c_void_p()
        if pointer:
            library.gatun_discard(pointer)


def write_parts(
    path: Path,
    parts: Iterable[Any],
    *,
    field_data: Mapping[str, Any] | None = None,
    times: Sequence[float] | None = None,
    overwrite: bool = False,
    tolerances: str | Mapping[str, str] | None = None,
    arrays: Iterable[Array] = (),
    progress: Progress | None = None,
    **options: Any,
) -> int:
    """Writes a mesh that comes in parts and never is in memory as a whole to a .gtn file.

    Points of several parts become one if their numbers, or without numbers their coordinates, and
    their values are the same.

    Args:
        path: the file to write, with the extension .gtn.
        parts: objects with the members of ``gatun.Grid``. ``point_ids`` are the numbers of the points in
            the whole mesh, or None. All parts are asked for twice, in the same order, so that an
            iterator will not do.
        field_data, times, overwrite, tolerances, arrays: as for ``write_mesh``.
        progress: as for ``File.read``, for each part anew.
        options: ``keep_order``, ``profile``, ``boundary``, ``chunk_size`` and ``key_step_interval``, as for
            ``write_mesh``.

    Returns:
        The size of the file in bytes.

    Raises:
        OSError: the file cannot be written; FileExistsError: there is a file.
        ValueError: a parameter or data that do not fit.
    """
    check_target(path, overwrite, ".gtn")
    if iter(parts) is parts:
        raise TypeError("parts: are needed twice; make a list of them, or an object with __iter__")
    times = None if times is None else [float(time) for time in times]
    writer = _PartWriter(path, ArrayList(arrays, tolerances), options, progress)
    try:
        for is_survey in (True, False):
            for part in parts:
                writer.write(part, times, field_data, is_survey)
        if not writer.pointer:
            raise ValueError("parts: there are none")
        return writer.finish()
    except BaseException:
        writer.discard()
        raise
