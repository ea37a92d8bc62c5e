# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Files of volumes, read without VTK."""

from __future__ import annotations

import ctypes
import functools
import itertools
import json
from collections.abc import Sequence
from typing import Any

import numpy as np

from . import _library as _c
from ._library import library
from ._numbers import check_box
from ._piece import Target, to_buffer
from ._sources import Handle, get_ranges, get_text
from ._types import Allocate, Progress, Source

_FUNCTIONS = (
    library.gatun_open_volume,
    library.gatun_open_volume_source,
    library.gatun_close_volume,
)


class Volume:
    """An open .ghv file, which any number of threads may read at once.

    Args:
        source: as for ``gatun.File``.

    Attributes:
        shape: the numbers of voxels along z, y and x.
        dtype: their type.
        name: of the array.
        origin, spacing: coordinates of the first voxel, and the distances of voxels along x, y and z.
        direction: a 3 x 3 matrix, whose columns are the directions of x, y and z.
        first_index: the index of the first voxel in VTK, along x, y and z.
        range: the smallest and largest value.
        vtk_type: the type of the array in VTK, or 0.

    Raises:
        OSError: the file cannot be opened, as FileNotFoundError.
        Error: the file is damaged, or no file of a volume.
    """

    def __init__(self, source: Source) -> None:
        self._handle = Handle(source, _FUNCTIONS)
        found = self._get_info()
        self.shape = tuple(found.dimensions[::-1])
        self.dtype = np.dtype(_c.DTYPES[found.type])
        self.name = _c.decode_text(found.name)
        self.origin = tuple(found.origin)
        self.spacing = tuple(found.spacing)
        self.direction = np.array(found.direction).reshape(3, 3)
        self.first_index = tuple(found.first_index)
        self.range = tuple(found.range)
        self.vtk_type = found.vtk_type

    def _get_info(self):
        found = _c.VolumeInfo()
        self._handle.get(library.gatun_get_volume_info, ctypes.byref(found))
        return found

    def close(self) -> None:
        """Closes the file. Calls of other threads end first."""
        self._handle.close()

    def __enter__(self) -> Volume:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    @property
    def file_name(self) -> str:
        """The name of the file, for messages."""
        return self._handle.name

    @property
    def path(self) -> str | None:
        """The path of the file, or None if it comes from elsewhere."""
        return self._handle.path

    @property
    def bounds(self) -> tuple[float, ...]:
        """xmin, xmax, ymin, ymax, zmin, zmax."""
        ends = [(first, first + size - 1) for first, size in zip(self.first_index, self.shape[::-1])]
        corners = np.array(list(itertools.product(*ends))) @ (self.direction * self.spacing).T + self.origin
        return tuple(np.column_stack([corners.min(axis=0), corners.max(axis=0)]).ravel().tolist())

    @functools.cached_property
    def info(self) -> dict[str, Any]:
        """A description of the file, that of ``gtn volume info --json``."""
        return json.loads(get_text(self._handle, library.gatun_describe_volume))

    @property
    def bytes_read(self) -> int:
        """The bytes of the file that have been read since it was opened."""
        return self._get_info().bytes_read

    def find_box(self, box: Sequence[float]) -> tuple[tuple[int, ...], tuple[int, ...]]:
        """The voxels in a box and those around it, as ``first`` and ``end`` of ``read``.

        Args:
            box: xmin, xmax, ymin, ymax, zmin, zmax, in coordinates.

        Raises:
            ValueError: it has no voxels.
        """
        corners = np.array(list(itertools.product(*np.reshape(check_box(box), (3, 2)))))
        places = np.linalg.solve(self.direction * self.spacing, (corners - self.origin).T).T - self.first_index
        last = np.array(self.shape[::-1]) - 1
        low, high = np.maximum(places.min(axis=0), 0), np.minimum(places.max(axis=0), last)
        if not np.all(low <= high):
            raise ValueError(f"box: {tuple(box)} has no voxels")
        return tuple(np.floor(low).astype(int).tolist()), tuple((np.ceil(high).astype(int) + 1).tolist())

    def _find_box(self, first, end):
        size = self.shape[::-1]
        first = (0, 0, 0) if first is None else tuple(first)
        end = size if end is None else tuple(end)
        if not len(first) == len(end) == 3:
            raise ValueError("first and end: have to be three numbers, along x, y and z")
        if not all(0 <= low < high <= most for low, high, most in zip(first, end, size)):
            raise ValueError(f"there are no voxels from {first} to {end}; the volume has {size}")
        return (ctypes.c_uint32 * 3)(*first), (ctypes.c_uint32 * 3)(*end)

    def plan(
        self, first: Sequence[int] | None = None, end: Sequence[int] | None = None, *, gap: int = 0
    ) -> list[tuple[int, int]]:
        """The ranges of the file that ``read`` needs, as pairs of offset and length.

        Args:
            first, end: as for ``read``.
            gap: ranges with at most so many bytes between them are joined.
        """
        return get_ranges(self._handle, library.gatun_plan_voxels, *self._find_box(first, end), gap)

    def read(
        self,
        first: Sequence[int] | None = None,
        end: Sequence[int] | None = None,
        *,
        allocate: Allocate | None = None,
        progress: Progress | None = None,
    ) -> np.ndarray:
        """Reads voxels as ``values[z, y, x]``.

        Args:
            first, end: the first voxel along x, y and z, and the one behind the last. Default: all.
            allocate: as for ``File.read``; the name is that of the array.
            progress: a function of the fraction that is done; it may return False to stop.
        """
        box = self._find_box(first, end)
        values = Target(allocate).make(self.name, self.dtype, tuple(high - low for low, high in zip(*box))[::-1])
        buffer = to_buffer(values)
        self._handle.call(
            library.gatun_read_voxels, *box, ctypes.byref(buffer), progress=progress
        )
        return values

    def verify(self, progress: Progress | None = None) -> None:
        """Checks all checksums, and decodes everything.

        Args:
            progress: as for ``read``.

        Raises:
            Error: the file is damaged.
        """
        self._handle.call(library.gatun_verify_volume, progress=progress)
