# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Writes the steps of a series, whose mesh may stay, move, lose cells or be another one."""

from __future__ import annotations

import ctypes
import dataclasses
import os

import numpy as np

from . import _library as _c
from ._file import File
from ._inputs import take
from ._library import check, library
from ._meshes import CellInput, StepInput
from ._output import Output
from ._piece import to_buffer
from ._series_arrays import SeriesArrays


@dataclasses.dataclass
class _Written:
    """A mesh that more steps can have.

    Attributes:
        number: of the mesh in the file.
        mesh: its points and cells.
        cells, points: fingerprints, as memory of the input may change from step to step.
        is_overwritten: whether its memory has another mesh now.
    """

    number: int
    mesh: CellInput
    cells: bytes
    points: bytes
    is_overwritten: bool = False

    def has_cells_of(self, mesh, cells):
        return not self.is_overwritten and self.mesh.has_form_of(mesh) and self.cells == cells

    def is_intact(self):
        return (
            not self.is_overwritten
            and self.mesh.hash_cells() == self.cells
            and self.mesh.hash_points() == self.points
        )


@dataclasses.dataclass
class _Remaining:
    """The numbers of the cells and points of a mesh that a step has."""

    cells: np.ndarray
    points: np.ndarray | None
    have_moved: bool


def _find_remaining(whole, part):
    """The cells and points of a mesh that make up another one, or None."""
    cells = np.empty(part.count, np.uint64)
    points = np.empty(len(part.points), np.uint64)
    found = _c.Remaining()
    status = library.gatun_find_remaining(
        ctypes.byref(whole.structure),
        ctypes.byref(part.structure),
        ctypes.byref(to_buffer(cells)),
        ctypes.byref(to_buffer(points)),
        ctypes.byref(found),
    )
    check(status)
    if not found.is_part:
        return None
    return _Remaining(cells, points if found.drops_points else None, bool(found.points_moved))


def _round_points(mesh, error, path):
    """Rounds the coordinates of a mesh."""
    rounded, largest = np.empty_like(mesh.points), ctypes.c_double()
    status = library.gatun_round_points(
        ctypes.byref(mesh.structure), error, 0, ctypes.byref(to_buffer(rounded)), ctypes.byref(largest)
    )
    check(status, path)
    if largest.value > 0:
        mesh.set_points(rounded)


class _Progress:
    """Reports the part of all steps that is done, which does not go back."""

    def __init__(self, report, steps):
        self._report = report
        self._steps = steps
        self._done = 0.0

    def of_part(self, step, begin, end):
        """The function for a part of a step, both from 0 to 1; None without a report."""
        if self._report is None:
            return None

        def report(fraction):
            done = (step + begin + (end - begin) * fraction) / self._steps
            self._done = max(self._done, done)
            return self._report(self._done)

        return report


class SeriesWriter:
    """Writes all steps to a file.

    Args:
        path: of the file.
        steps: what to write, as Steps.
        options: of the file.
        arrays: names of the arrays to write, or None for all.
        point_error: the bound of coordinates as bytes, or None.
        append: whether to add the steps to the file, if it exists.
        fill_missing: whether arrays may come and go.
        progress: a function, or None.
    """

    def __init__(self, path, steps, options, *, arrays, point_error, append, fill_missing, progress):
        self._path = path
        self._steps = steps
        self._options = options
        self._names = arrays
        self._point_error = point_error
        self._appends = append and os.path.exists(path)
        self._progress = _Progress(progress, len(steps))
        self._arrays = SeriesArrays(path, fill_missing)
        if self._appends:
            with File(path) as file:
                self._arrays.continue_file(file.arrays)
        self._points_move = False
        self._looks_ahead = False  # for more arrays in the steps to come
        self._is_surface = None
        self._output = Output(path, options)
        self._meshes = []  # the first one and the one that was added last
        self._remaining = None

    def write(self):
        """Writes the file. Returns its size in bytes."""
        with self._output:
            step = 0
            while step < len(self._steps):
                step = self._write_step(step, self._take(step))
            return self._output.finish()

    def _take(self, step):
        """The mesh of a step with its arrays."""
        data = take(self._steps.get(step), self._names)
        is_surface = bool(data.mesh.structure.is_surface)
        if self._is_surface is None:
            self._is_surface = is_surface
            self._check_names(data)
        if is_surface != self._is_surface:
            raise TypeError(f"data: step {step} is {'a' if is_surface else 'no'} surface, and those before are not so")
        if self._point_error is not None and len(data.mesh.points) and not data.keeps_points:
            _round_points(data.mesh, self._point_error, self._path)
        if self._steps.times is not None:
            data.time = self._steps.times[step]
        return data

    def _check_names(self, data):
        """Raises ValueError for an array that a mesh in memory does not have."""
        there = {array.name for array, _ in data.arrays}
        for name in (self._names or []) if self._steps.is_made else []:
            if name not in there:
                raise ValueError(f"arrays: the mesh has no array {name!r}")

    def _write_step(self, step, data):
        """Writes a step. Returns the next one: the first one again if the file has to be begun once more."""
        counts = {False: len(data.mesh.points), True: data.mesh.count}
        name = "the data"
        if self._steps.times is not None:
            name = f"time step {step} (time {data.time:g})"
        are_known = self._arrays.learn(data.arrays, counts, name) or not self._output.is_open
        if self._looks_ahead or not are_known:
            self._looks_ahead = step + 1 < len(self._steps)
            return step + 1 if self._looks_ahead else self._restart()
        values = self._arrays.arrange(data.arrays, counts)
        if not self._use_mesh(step, data.mesh, values):
            return self._restart()
        remaining = self._remaining
        self._output.write_step(
            StepInput(
                values,
                data.fields,
                data.time,
                data.mesh.points if self._points_move else None,
                None if remaining is None else remaining.cells,
                None if remaining is None else remaining.points,
            ),
            self._progress.of_part(step, 0.5, 1),
        )
        return step + 1

    def _restart(self):
        self._output.discard()
        self._meshes.clear()
        self._looks_ahead = False
        return 0

    def _use_mesh(self, step, mesh, values):
        """Lets a step have a mesh: one that was written, if it has the same cells, or a new one. Returns False if the
        points move, and the file is one whose points do not."""
        self._remaining = None
        cells = mesh.hash_cells() if len(self._steps) > 1 else b""
        for written in self._meshes:
            if written.has_cells_of(mesh, cells):
                if not self._points_move and mesh.hash_points() != written.points:
                    self._points_move = True
                    return False
                self._output.use_mesh(written.number)
                return True
        if self._use_remaining(mesh):
            is_written = self._points_move or not self._remaining.have_moved
            self._points_move = self._points_move or self._remaining.have_moved
            return is_written
        for written in self._meshes:
            written.is_overwritten |= written.mesh.shares_memory(mesh)
        self._add_mesh(step, mesh, cells, values)
        return True

    def _use_remaining(self, mesh):
        """The mesh as some of the cells of one that was written. Returns whether it is."""
        if self._options.has_hierarchy or self._options.has_boundary:
            return False  # they are those of a mesh with all cells
        for written in self._meshes:
            if mesh.count < written.mesh.count and written.is_intact():
                self._remaining = _find_remaining(written.mesh, mesh)
                if self._remaining is not None:
                    self._output.use_mesh(written.number)
                    return True
        return False

    def _add_mesh(self, step, mesh, cells, values):
        points = mesh.hash_points() if len(self._steps) > 1 else b""
        if self._points_move:
            # The input may change its points in place, and the first ones are needed until the end.
            mesh.set_points(mesh.points.copy())
        progress = self._progress.of_part(step, 0, 0.5)
        if not self._output.is_open and self._appends:
            self._output.append(self._arrays.list(), self._points_move)
        number = 0
        if self._output.is_open:
            number = self._output.add_mesh(mesh, values, progress)
            # The mesh that was added before is complete, and so are those of a file.
            del self._meshes[0 if self._appends else 1 :]
        else:
            self._output.create(mesh, self._arrays.list(), values, self._points_move, progress)
        self._meshes.append(_Written(number, mesh, cells, points))
