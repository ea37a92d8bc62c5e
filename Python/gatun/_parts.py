# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Meshes that are written in parts."""

from __future__ import annotations

import ctypes
import os
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np

from ._description import Array
from ._field_input import Fields
from ._library import library
from ._meshes import CellInput, StepInput
from ._output import Options, Output
from ._targets import check_target
from ._types import Path
from ._write import ArrayList, Progress


def _split_steps(data, count, what):
    """For each step the arrays of it, of arrays with an entry for each step."""
    for name, values in (data or {}).items():
        if len(values) != count:
            raise ValueError(f"{what} {name!r}: has {len(values)} entries for {count} times")
    return [{name: values[i] for name, values in (data or {}).items()} for i in range(count)]



class _PartWriter:
    """Writes parts twice: first they are surveyed, and then they are stored."""

    def __init__(self, output, arrays, count, progress):
        self._output = output
        self._arrays = arrays
        self._count = count
        self._progress = progress

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
        if not self._output.is_open:
            self._output.create_parts(self._arrays.list, self._count)
        ids = part.point_ids
        if ids is not None:
            ids = np.ascontiguousarray(ids, np.int64)
            if ids.shape != (len(mesh.points),):
                raise ValueError("point_ids: has not one number for each point")
        function = library.gatun_survey_part if is_survey else library.gatun_add_part
        address = None if ids is None else ids.ctypes.data
        self._output.call(function, ctypes.byref(mesh.structure), address, progress=self._progress)
        for time, values in steps:
            self._write_step(StepInput(values, Fields(fields), time), is_survey)

    def _list_steps(self, part, times, counts):
        if times is None:
            return [(None, self._arrays.take(part.point_data, part.cell_data, counts))]
        points = _split_steps(part.point_data, len(times), "point_data")
        cells = _split_steps(part.cell_data, len(times), "cell_data")
        return [(t, self._arrays.take(p, c, counts)) for t, p, c in zip(times, points, cells)]

    def _write_step(self, step, is_survey):
        if is_survey:
            self._output.survey_step(step)
        else:
            self._output.write_step(step, self._progress)


def write_parts(
    path: Path,
    parts: Iterable[Any],
    *,
    field_data: Mapping[str, Any] | None = None,
    times: Sequence[float] | None = None,
    overwrite: bool = False,
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
        field_data: arrays of the whole mesh by name.
        times: the times of steps. Then each array of ``point_data`` and ``cell_data`` is a sequence with the
            values of each step.
        overwrite: whether to replace a file that is there.
        arrays: as for ``Writer``.
        progress: as for ``File.read``, for each part anew.
        options: ``tolerances``, ``keep_order``, ``profile``, ``hierarchy``, ``levels``, ``dependencies``, ``boundary``,
            ``chunk_size`` and ``key_step_interval``, as for ``gatun.write``.

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
    count = len(parts) if hasattr(parts, "__len__") else 0
    with Output(os.fsdecode(path), Options(**options)) as output:
        writer = _PartWriter(output, ArrayList(arrays), count, progress)
        for is_survey in (True, False):
            for part in parts:
                writer.write(part, times, field_data, is_survey)
        if not output.is_open:
            raise ValueError("parts: there are none")
        return output.finish()
