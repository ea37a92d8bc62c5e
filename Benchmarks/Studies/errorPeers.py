# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Other compressors of values with an error of at most a bound. Each function takes a one-dimensional array
and a bound and returns the compressed bytes and the values that come back."""

import ctypes
import ctypes.util
import lzma
import zlib

import numpy as np


def load_sz3(prefix):
    """SZ3 in a folder where it was installed, or None."""
    if not prefix:
        return None
    files = sorted(prefix.glob("lib*/**/libSZ3c.so*"))
    return Sz3(str(files[0])) if files else None


def load_zfp():
    """zfp of the system, or None."""
    name = ctypes.util.find_library("zfp")
    return Zfp(name) if name else None


def _is_double(values):
    return int(values.dtype == np.float64)


class Sz3:
    """SZ3 by its interface for C, with its default algorithm."""

    def __init__(self, file):
        library = ctypes.CDLL(file)
        size, real = ctypes.c_size_t, ctypes.c_double
        self._compress = library.SZ_compress_args
        self._compress.restype = ctypes.POINTER(ctypes.c_ubyte)
        self._compress.argtypes = ([ctypes.c_int, ctypes.c_void_p, ctypes.POINTER(size), ctypes.c_int]
                                   + 3 * [real] + 5 * [size])
        self._decompress = library.SZ_decompress
        self._decompress.restype = ctypes.c_void_p
        self._decompress.argtypes = [ctypes.c_int, ctypes.c_void_p, size] + 5 * [size]
        self._free = library.free_buf
        self._free.argtypes = [ctypes.c_void_p]

    def __call__(self, values, bound):
        kind, absolute = _is_double(values), 0
        values = np.array(values)  # SZ3 may write to it
        length = ctypes.c_size_t()
        packed = self._compress(kind, values.ctypes.data, ctypes.byref(length), absolute, bound, 0, 0,
                                0, 0, 0, 0, len(values))
        back = self._decompress(kind, packed, length.value, 0, 0, 0, 0, len(values))
        result = np.frombuffer(ctypes.string_at(back, values.nbytes), values.dtype)
        for memory in packed, back:
            self._free(memory)
        return length.value, result


class Zfp:
    """zfp with a fixed accuracy."""

    def __init__(self, file):
        self._zfp = ctypes.CDLL(file)
        pointer, size = ctypes.c_void_p, ctypes.c_size_t
        for name, result, arguments in (
                ("zfp_field_1d", pointer, [pointer, ctypes.c_int, size]),
                ("zfp_field_free", None, [pointer]),
                ("zfp_stream_open", pointer, [pointer]),
                ("zfp_stream_close", None, [pointer]),
                ("zfp_stream_set_accuracy", ctypes.c_double, [pointer, ctypes.c_double]),
                ("zfp_stream_maximum_size", size, [pointer, pointer]),
                ("zfp_stream_set_bit_stream", None, [pointer, pointer]),
                ("zfp_stream_rewind", None, [pointer]),
                ("zfp_compress", size, [pointer, pointer]),
                ("zfp_decompress", size, [pointer, pointer]),
                ("stream_open", pointer, [pointer, size]),
                ("stream_close", None, [pointer])):
            function = getattr(self._zfp, name)
            function.restype, function.argtypes = result, arguments

    def __call__(self, values, bound):
        zfp = self._zfp
        values = np.array(values)
        first_float = 3
        field = zfp.zfp_field_1d(values.ctypes.data, first_float + _is_double(values), len(values))
        stream = zfp.zfp_stream_open(None)
        zfp.zfp_stream_set_accuracy(stream, bound)
        room = zfp.zfp_stream_maximum_size(stream, field)
        memory = ctypes.create_string_buffer(room)
        bits = zfp.stream_open(memory, room)
        zfp.zfp_stream_set_bit_stream(stream, bits)
        zfp.zfp_stream_rewind(stream)
        written = zfp.zfp_compress(stream, field)
        zfp.zfp_stream_rewind(stream)
        values[:] = 0
        read = zfp.zfp_decompress(stream, field)
        if written == 0 or read == 0:
            raise RuntimeError("zfp fails")
        zfp.stream_close(bits)
        zfp.zfp_stream_close(stream)
        zfp.zfp_field_free(field)
        return written, values


def _rounded(values, bound, compress):
    """The better one of rounded values and of the numbers of their steps."""
    steps = np.rint(values.astype(np.float64) / (2 * bound))
    back = (steps * (2 * bound)).astype(values.dtype)
    whole = steps.astype(np.int32 if abs(steps).max() < 2**31 else np.int64)
    return min(len(compress(whole.tobytes())), len(compress(back.tobytes()))), back


def rounded_xz(values, bound):
    return _rounded(values, bound, lambda data: lzma.compress(data, preset=9 | lzma.PRESET_EXTREME))


def rounded_zlib(values, bound):
    return _rounded(values, bound, lambda data: zlib.compress(data, 9))
