# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Where the bytes of files come from: paths, memory, addresses and objects of callers."""

from __future__ import annotations

import contextlib
import ctypes
import errno
import os
import threading

from ._exceptions import NotHere
from ._library import SOURCE_NOT_HERE, Call, Close, Fetch, Range, Read, Source, check, encode


class BytesSource:
    """A file in memory."""

    name = "bytes"

    def __init__(self, data):
        self._data = memoryview(data).cast("B")
        self.size = len(self._data)

    def read(self, offset, length):
        """The bytes at an offset."""
        return self._data[offset : offset + length]


class _Adapter:
    """An object with ``size``, ``read`` and perhaps ``fetch`` as a source of the library, whose
    exceptions it keeps."""

    def __init__(self, source):
        self._source = source
        self._lock = threading.Lock()
        self._failures = []
        name = getattr(source, "name", None)
        self._read = Read(self._read_bytes)
        self._fetch = Fetch(self._fetch_ranges) if hasattr(source, "fetch") else Fetch()
        self.structure = Source(
            bytes=int(source.size),
            read=self._read,
            close=Close(),
            name=name.encode("utf-8", "replace").replace(b"\0", b"?") if isinstance(name, str) else None,
            fetch=self._fetch,
        )

    def _read_bytes(self, _, offset, to, length):
        try:
            data = memoryview(self._source.read(offset, length)).cast("B")
            if len(data) != length:
                raise EOFError(f"the source has given {len(data)} bytes at {offset} in place of {length}")
            target = (ctypes.c_char * length).from_address(to)
            memoryview(target).cast("B")[:] = data
            return 0
        except BaseException as error:  # pylint: disable=broad-except
            return self._keep(error)

    def _fetch_ranges(self, _, ranges, count):
        try:
            self._source.fetch([(r.offset, r.length) for r in ranges[:count]])
            return 0
        except BaseException as error:  # pylint: disable=broad-except
            return self._keep(error)

    def _keep(self, error):
        """Keeps what the source has raised. Returns its number for the library."""
        if isinstance(error, NotHere):
            return SOURCE_NOT_HERE
        with self._lock:
            self._failures.append(error)
        number = getattr(error, "errno", None)
        return number if isinstance(number, int) and number > 0 else errno.EIO

    def take_failure(self):
        """What the source has raised last, if it has not been taken before."""
        with self._lock:
            found, self._failures = self._failures[-1:], []
        return found[0] if found else None


class Handle:
    """An open file or volume of the library, which any number of threads may use.

    Args:
        source: a path, bytes, or an object with ``size`` and ``read(offset, length)``.
        functions: of the library: to open a path, to open a source, and to close.
        arguments: of the first two, behind path or source.
    """

    def __init__(self, source, functions, *arguments):
        open_path, open_source, self._close = functions
        self._pointer = ctypes.c_void_p()
        self._lock = threading.Lock()
        self._users = 0
        self._is_closed = False
        self._adapter = None
        self.path = None
        self.source = None
        if isinstance(source, (bytes, bytearray, memoryview)):
            source = BytesSource(source)
        to = ctypes.byref(self._pointer)
        if isinstance(source, (str, os.PathLike)):
            self.path = os.fspath(source)
            # The system's exceptions are more exact than a status.
            if os.path.isdir(self.path):
                raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), self.path)
            check(open_path(encode(self.path), *arguments, to), self.path)
            return
        if not (hasattr(source, "size") and hasattr(source, "read")):
            raise TypeError(f"a {type(source).__name__} is no path, and has not size and read of a source")
        self.source = source
        self._adapter = _Adapter(source)
        self.check(open_source(ctypes.byref(self._adapter.structure), *arguments, to))

    @property
    def name(self):
        """The name of the file, for messages."""
        return os.fsdecode(self.path) if self.path is not None else str(getattr(self.source, "name", "the file"))

    @contextlib.contextmanager
    def use(self):
        """The pointer, which stays valid in a block even if another thread closes the file."""
        with self._lock:
            if self._is_closed:
                raise ValueError("the file is closed")
            self._users += 1
        try:
            yield self._pointer
        finally:
            with self._lock:
                self._users -= 1
            self._free()

    def check(self, status, call=None):
        """Raises what the source or a callback has raised, or else the failure of the library."""
        if status != 0 and self._adapter is not None:
            failure = self._adapter.take_failure()
            if failure is not None:
                raise failure
        (call or Call()).check(status, self.path)

    def call(self, function, *arguments, progress=None):
        """Calls a function of the library that may report progress or fail."""
        call = Call(progress)
        with self.use() as pointer:
            self.check(function(pointer, *arguments, *call.arguments), call)

    def get(self, function, *arguments):
        """Calls a function of the library that does not report progress."""
        with self.use() as pointer:
            self.check(function(pointer, *arguments))

    def close(self):
        """Closes the file; calls of other threads end first."""
        with self._lock:
            self._is_closed = True
        self._free()

    def _free(self):
        with self._lock:
            if not self._is_closed or self._users > 0 or not self._pointer:
                return
            pointer, self._pointer = self._pointer, ctypes.c_void_p()
        self._close(pointer)

    def __del__(self):
        if getattr(self, "_lock", None):
            self.close()


def get_text(handle, function):
    """The text of a function of the library that tells its length."""
    length = ctypes.c_size_t()
    handle.get(function, 0, None, 0, ctypes.byref(length))
    while True:
        text = ctypes.create_string_buffer(length.value)
        handle.get(function, 0, text, len(text), ctypes.byref(length))
        if length.value <= len(text):
            return text.value.decode("utf-8", "surrogateescape")


def get_ranges(handle, function, *arguments):
    """The ranges of a function of the library that plans, as pairs of offset and length."""
    count = ctypes.c_size_t(64)
    while True:
        ranges = (Range * count.value)()
        try:
            handle.get(function, *arguments, ranges, len(ranges), ctypes.byref(count))
        except NotHere as error:
            if count.value <= len(ranges):
                error.ranges = [(r.offset, r.length) for r in ranges[: count.value]]
                raise
        if count.value <= len(ranges):
            return [(r.offset, r.length) for r in ranges[: count.value]]
