# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Opening of files."""

from __future__ import annotations

import contextlib
import io
import os

from ._exceptions import NotHere
from ._file import File
from ._sources import BytesSource
from ._types import Source
from ._volume import Volume

_VOLUME_START = b"\x89GHV"


def _is_volume(source):
    if isinstance(source, (str, os.PathLike)):
        if os.path.isdir(source):
            return False
        with io.open(source, "rb") as file:
            return file.read(len(_VOLUME_START)) == _VOLUME_START
    start = min(len(_VOLUME_START), source.size)
    try:
        return bytes(source.read(0, start)) == _VOLUME_START
    except NotHere as error:
        error.ranges = error.ranges or [(0, start)]
        raise


def is_source(source):
    """Whether something is a source, or a file that is open, by its type."""
    kinds = (str, bytes, bytearray, memoryview, os.PathLike, File, Volume)
    return isinstance(source, kinds) or (hasattr(source, "size") and hasattr(source, "read"))


@contextlib.contextmanager
def opened(source, kind=object):
    """The file of a source in a block, at the end of which it is closed unless it was open before.

    Args:
        source: as for ``open``, or a File or Volume.
        kind: the only class of the file that fits.
    """
    is_open = isinstance(source, (File, Volume))
    file = source if is_open else open(source)
    try:
        if not isinstance(file, kind):
            raise ValueError(f"{file.file_name}: is a volume, and no mesh")
        yield file
    finally:
        if not is_open:
            file.close()


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
