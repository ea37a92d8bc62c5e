# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Files of volumes, read and written without VTK."""

from __future__ import annotations

import ctypes
import functools
import json
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _library as _c
from ._library import Call, encode, encode_text, library
from ._numbers import as_numbers
from ._piece import make_array, to_buffer
from ._sources import Handle, get_ranges, get_text
from ._targets import check_target
from ._types import Path, Source

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

_FUNCTIONS = (
    library.gatun_open_volume,
    library.gatun_open_volume_source,
    library.gatun_close_volume,
)
_RATES = {"quality": 0, "rms_error": 1, "psnr": 2, "bits_per_voxel": 3}
_DEFAULT_QUALITY = 60.0


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

    @functools.cached_property
    def info(self) -> dict[str, Any]:
        """A description of the file, that of ``gtn volume info --json``."""
        return json.loads(get_text(self._handle, library.gatun_describe_volume))

    @property
    def bytes_read(self) -> int:
        """The bytes of the file that have been read since it was opened."""
        return self._get_info().bytes_read

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
        progress: Callable[[float], Any] | None = None,
    ) -> np.ndarray:
        """Reads voxels as ``values[z, y, x]``.

        Args:
            first, end: the first voxel along x, y and z, and the one behind the last. Default: all.
            progress: a function of the fraction that is done; it may return False to stop.
        """
        box = self._find_box(first, end)
        fetch = getattr(self._handle.source, "fetch", None)
        if fetch:
            fetch(self.plan(first, end))
        values = make_array(tuple(high - low for low, high in zip(*box))[::-1], self.dtype)
        buffer = to_buffer(values)
        self._handle.call(
            library.gatun_read_voxels, *box, ctypes.byref(buffer), progress=progress
        )
        return values

    def verify(self, progress: Callable[[float], Any] | None = None) -> None:
        """Checks all checksums, and decodes everything.

        Args:
            progress: as for ``read``.

        Raises:
            Error: the file is damaged.
        """
        self._handle.call(library.gatun_verify_volume, progress=progress)


def write_volume(
    path: Path,
    values: ArrayLike,
    *,
    overwrite: bool = False,
    spacing: Sequence[float] = (1.0, 1.0, 1.0),
    origin: Sequence[float] = (0.0, 0.0, 0.0),
    direction: ArrayLike | None = None,
    first_index: Sequence[int] = (0, 0, 0),
    name: str = "values",
    quality: float | None = None,
    rms_error: float | None = None,
    psnr: float | None = None,
    bits_per_voxel: float | None = None,
    block_size: int = 8,
    progress: Callable[[float], Any] | None = None,
) -> int:
    """Writes a volume to a .ghv file without VTK.

    Args:
        path: the file to write.
        values: the voxels as ``values[z, y, x]``.
        overwrite: whether to replace a file that is there.
        spacing: the distances of voxels along x, y and z.
        origin: the coordinates of the first voxel.
        direction: a 3 x 3 matrix, whose columns are the directions of x, y and z. Default: those of
            the coordinates.
        first_index: the index of the first voxel in VTK.
        name: of the array.
        quality, rms_error, psnr, bits_per_voxel: one of these: quality from 1 to 100 (default: 60),
            largest root mean square error (0: lossless), least peak signal-to-noise ratio in dB, or size.
        block_size: voxels of a block along each axis, 2 to 64.
        progress: a function of the fraction that is done; it may return False to stop.

    Returns:
        The size of the file in bytes.

    Raises:
        OSError: the file cannot be written; FileExistsError: there is a file.
        ValueError: a parameter or data that do not fit.
    """
    check_target(path, overwrite, ".ghv")
    array = np.ascontiguousarray(as_numbers(values, "values"))
    if array.ndim != 3 or array.dtype.kind == "U":
        raise ValueError(f"values: have to be numbers with 3 dimensions, and have {array.ndim}")
    rates = {"quality": quality, "rms_error": rms_error, "psnr": psnr, "bits_per_voxel": bits_per_voxel}
    chosen = [rate for rate, value in rates.items() if value is not None] or ["quality"]
    if len(chosen) > 1:
        raise ValueError(f"{' and '.join(chosen)} exclude each other")
    number = _DEFAULT_QUALITY if rates[chosen[0]] is None else float(rates[chosen[0]])
    volume = _c.VolumeInfo(type=_c.TYPES[array.dtype.name], name=encode_text(name, "name"))
    volume.dimensions[:] = array.shape[::-1]
    volume.spacing[:] = spacing
    volume.origin[:] = origin
    volume.first_index[:] = first_index
    if direction is not None:
        volume.direction[:] = np.asarray(direction, float).reshape(9)
    if not 2 <= block_size <= 64:
        raise ValueError(f"block_size: {block_size} is not from 2 to 64")
    buffer, call, written = to_buffer(array), Call(progress), _c.VolumeInfo()
    status = library.gatun_write_volume(
        encode(path),
        ctypes.byref(volume),
        ctypes.byref(buffer),
        block_size,
        _RATES[chosen[0]],
        number,
        *call.arguments,
        ctypes.byref(written),
    )
    call.check(status, path)
    return written.file_bytes
