# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The arrays of a time series.

All steps of a file have the same arrays. Steps may differ in the order of the arrays, in their roles and the names of
components, in vtkGhostType, and in arrays without tuples. Arrays have the order and the roles of the first step with
values, and the first names of components that occur.
"""

from __future__ import annotations

import collections
import dataclasses

import numpy as np

from ._description import Array
from ._exceptions import InputError
from ._warnings import warn

_GHOSTS = "vtkGhostType"
_HOW_TO_FILL = "; fill_missing=True writes NaN, or 0 for integers, where a step does not have an array"


def _title(array):
    return f"{'cell' if array.is_cell else 'point'} array {array.name!r}"


def _kind(array):
    return f"{array.dtype} with {array.components} component{'' if array.components == 1 else 's'}"


def _is_of_kind(one, other):
    same_type = one.vtk_type == other.vtk_type or 0 in (one.vtk_type, other.vtk_type)
    return one.dtype == other.dtype and one.components == other.components and same_type


def _is_ghosts(array):
    return array.name == _GHOSTS and array.components == 1 and array.dtype == np.uint8


def _number(arrays):
    """For each array its place and name, and how many of them come before it: names need not be unique."""
    counts = collections.Counter()
    for array in arrays:
        key = (array.is_cell, array.name)
        yield (*key, counts[key])
        counts[key] += 1


def _make_missing(array, count):
    fill = np.nan if array.dtype.kind == "f" else 0
    return np.full((count, array.components), fill, array.dtype)


@dataclasses.dataclass
class _Known:
    array: Array
    has_tuples: bool


class SeriesArrays:
    """Finds the arrays of all steps.

    Args:
        path: of the file, for messages.
        fills: whether arrays may come and go.
        written: the arrays of the file to which steps are added, or None. It gets no others.
    """

    def __init__(self, path, fills):
        self._path = path
        self._fills = fills
        self._known = {}  # by the numbers of _number
        self._had_tuples = {False: False, True: False}
        self._is_continued = False
        self._warned = set()

    def continue_file(self, arrays):
        """Lets the steps come after those of a file, to which no arrays are added."""
        self._is_continued = True
        self._known = {key: _Known(array, True) for key, array in zip(_number(arrays), arrays)}
        for array in arrays:
            self._had_tuples[array.is_cell] = True

    def _warn(self, text):
        if text not in self._warned:
            self._warned.add(text)
            warn(f"{self._path}: {text}")

    def _refuse(self, text):
        raise InputError(f"{self._path}: {text}", 40007, "InvalidInputError")

    def learn(self, arrays, counts, step):
        """Adds the arrays of a step. Returns whether they were known; if not, the steps before have to be written
        with more arrays.

        Args:
            arrays: pairs of descriptions and values.
            counts: the numbers of points and cells, by whether they are of cells.
            step: its name, for messages.
        """
        is_known = True
        before = dict(self._known)
        there = set()
        for key, (array, values) in zip(_number(array for array, _ in arrays), arrays):
            there.add(key)
            if key in before:
                has_more = self._compare(before[key], array, len(values) > 0, step)
            else:
                has_more = self._add(key, array, len(values) > 0, step)
            is_known = is_known and not has_more
        for key, known in before.items():
            array = known.array
            if key not in there and counts[array.is_cell] > 0 and not self._fills and not _is_ghosts(array):
                self._refuse(
                    f"in {step} the {_title(array)} ({_kind(array)}) of the steps before is missing{_HOW_TO_FILL}"
                )
        for is_cell, count in counts.items():
            self._had_tuples[is_cell] |= count > 0
        return is_known

    def _add(self, key, array, has_tuples, step):
        """Adds an array that the steps before do not have. Returns whether it has to be written."""
        if self._had_tuples[array.is_cell] or self._is_continued:
            if not has_tuples:
                return False
            start = f"in {step} the {_title(array)} ({_kind(array)}) appears, which the "
            if self._is_continued:
                self._refuse(f"{start}file does not have; arrays=... leaves it out")
            if not self._fills and not _is_ghosts(array):
                self._refuse(f"{start}steps before do not have{_HOW_TO_FILL}")
        taken = 0
        for known in self._known.values():
            if known.array.is_cell == array.is_cell:
                taken |= known.array.roles
        self._known[key] = _Known(dataclasses.replace(array, roles=array.roles & ~taken), has_tuples)
        return True

    def _compare(self, known, array, has_tuples, step):
        """Compares an array with that of the steps before. Returns whether more has to be written than before."""
        if not has_tuples:
            return False
        had_tuples, known.has_tuples = known.has_tuples, True
        mine = known.array
        if not had_tuples and mine != array:
            known.array = array
            return True
        if not _is_of_kind(mine, array):
            self._refuse(
                f"in {step} the {_title(array)} is {_kind(array)}, and in the steps before {_kind(mine)}; an array has "
                "one type in all steps of a file"
            )
        if mine.roles != array.roles:
            self._warn(
                "the active arrays (scalars, vectors, ids and the like) are those of the first step at all steps; other "
                "ones of later steps are not kept"
            )
        if mine.keys != array.keys:
            self._warn(
                f"the keys of the {_title(mine)} change with time, and are those of the first step at all steps"
            )
        if mine.component_names == array.component_names or not array.component_names:
            return False
        if not mine.component_names and not self._is_continued:
            known.array = dataclasses.replace(mine, component_names=array.component_names)
            return True
        self._warn(
            f"the names of components of the {_title(mine)} change with time, and are those of the first step at all "
            "steps"
        )
        return False

    def list(self):
        """The descriptions of all arrays, in the order of the file."""
        return [known.array for known in self._known.values()]

    def arrange(self, arrays, counts):
        """The values of all arrays at a step that was learned, also of those that it does not have."""
        found = dict(zip(_number(array for array, _ in arrays), arrays))
        arranged = []
        for key, known in self._known.items():
            array, values = found.get(key, (None, None))
            if array is None or not _is_of_kind(array, known.array):
                values = _make_missing(known.array, counts[known.array.is_cell])
            arranged.append(values)
        return arranged
