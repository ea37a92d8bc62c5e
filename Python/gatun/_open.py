# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Opening of files."""

from __future__ import annotations

import os

from ._exceptions import NotHere
from ._file import File
from ._library import KIND_VOLUME, encode, library
from ._sources import BytesSource
from ._types import Source
from ._volume import Volume

_VOLUME_START = b"\x89GHV"


def _is_volume(source):
    if isinstance(source, (str, os.PathLike)):
        return library.gatun_kind_of(encode(source)) == KIND_VOLUME
    start = min(len(_VOLUME_START), source.size)
    try:
        return bytes(source.read(0, start)) == _VOLUME_START
    except NotHere as error:
        error.ranges = error.ranges or [(0, start)]
        raise


def open(source: Source, *, cache_bytes: int = 0) -> File | Volume:  # pylint: disable=redefined-builtin
    """Opens a .gtn or .ghv file to read it without VTK.

    Args:
        source: the path of a file; its address, which begins with ``http://`` or ``https://``; its
            bytes; or an object with ``size`` and ``read(offset, length)`` as for ``gatun.File``. Of an
            address, only those parts are fetched that are needed.
        cache_bytes: memory for decoded parts, which further calls use; 0 for 512 MiB.

    Returns:
        A ``gatun.File``, or a ``gatun.Volume`` for a .ghv file. The contents tell what it is.

    Raises:
        OSError: the file cannot be opened, as FileNotFoundError.
        Error: the file is damaged, or no file of Gatun.
    """
    if isinstance(source, str) and source.lower().startswith(("http://", "https://")):
        from ._http import HttpSource

        source = HttpSource(source)
    elif isinstance(source, (bytes, bytearray, memoryview)):
        source = BytesSource(source)
    return Volume(source) if _is_volume(source) else File(source, cache_bytes=cache_bytes)
