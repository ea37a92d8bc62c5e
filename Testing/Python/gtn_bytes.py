# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Numbers, references and packed parts of `.gtn` files: sections 1.2, 2.6, 2.7, 3.1 and 11.1 of
Documentation/format.md.

Part of gtn_decoder, which is written from that text alone.
"""

import math
import struct
from types import SimpleNamespace as Record

import xxhash
import zstandard

MAX_PALETTE = 1 << 16
SCALES = SHIFT, DECIMAL, FIXED, BINARY = 65537, 65538, 65539, 65542
COPY = 65540
BOUND = 65541
PALETTE = 0

#: Bytes of a value of each type (5.1).
SIZES = {1: 1, 2: 1, 3: 2, 4: 2, 5: 4, 6: 4, 7: 8, 8: 8, 9: 4, 10: 8}


class FormatError(Exception):
    """What is not a conforming file."""


def require(condition, message):
    if not condition:
        raise FormatError(message)


def checksum(data):
    return xxhash.xxh3_64_intdigest(data)


class Bytes:
    """Reads the types of 1.2 from a run of bytes, front to back."""

    def __init__(self, data):
        self.data = data
        self.at = 0

    def left(self):
        return len(self.data) - self.at

    def take(self, count):
        require(count <= self.left(), "ends too early")
        self.at += count
        return self.data[self.at - count : self.at]

    def number(self, code):
        """One number, by the letter that the module struct has for its type."""
        return struct.unpack("<" + code, self.take(struct.calcsize("<" + code)))[0]

    def varint(self):
        value = 0
        for place in range(10):
            byte = self.number("B")
            require(place < 9 or byte & 127 <= 1, "varint of more than 64 bits")
            value |= (byte & 127) << (7 * place)
            if byte < 128:
                return value
        raise FormatError("varint of more than ten bytes")

    def raw_string(self):
        return self.take(self.varint())

    def string(self):
        """Text; bytes that are not UTF-8 become surrogates, as in Python's file names."""
        return self.raw_string().decode("utf-8", "surrogateescape")

    def end(self):
        require(self.left() == 0, "bytes behind the last field")

    # Of section 3.1 and 2.7.

    def range(self):
        low, high = self.number("d"), self.number("d")
        require(not math.isnan(low) and not math.isnan(high), "range of NaN")
        return low, high

    def ranges(self, count):
        return [self.range() for _ in range(count)]

    def reference(self):
        """A stream reference, or none."""
        length = self.varint()
        if length == 0:
            return None
        return Record(length=length, offset=self.varint(), checksum=self.number("Q"))

    def domain(self):
        """A domain reference, or none: a palette with entries and stream, a scale with kind, digits
        and first, a copy with array and component, or a bound with its bytes."""
        entries = self.varint()
        if entries == 0:
            return None
        if entries == COPY:
            return Record(kind=COPY, array=self.varint(), component=self.varint())
        if entries in SCALES:
            digits = None if entries == BINARY else self.number("B")
            first = self.number("b") if entries in (DECIMAL, BINARY) else None
            return Record(kind=entries, digits=digits, first=first)
        if entries == BOUND:
            return Record(kind=BOUND, bytes=self.take(26))
        require(entries <= MAX_PALETTE, "palette too large")
        stream = self.reference()
        require(stream is not None, "palette without a stream")
        require(stream.length >= entries // 256, "stream of a palette too short")
        return Record(kind=PALETTE, entries=entries, stream=stream)


def unpack(data, limit):
    """The content of a packed part (2.6)."""
    part = Bytes(data)
    length = part.varint()
    require(length <= limit(len(data)), "packed part too large")
    frame = part.take(part.left())
    try:
        decompressor = zstandard.ZstdDecompressor(max_window_size=1 << 27).decompressobj()
        content = decompressor.decompress(frame)
    except zstandard.ZstdError as error:
        raise FormatError(str(error)) from None
    require(decompressor.eof and not decompressor.unused_data, "not one Zstandard frame")
    require(len(content) == length, "packed part of another length")
    return content


def table_limit(packed):
    """Of META, TABL, TREE, LAYR and CELL (11.1)."""
    return max(1 << 20, 512 * packed)


def step_limit(packed):
    """Of STEP and TRNG."""
    return max(1 << 24, 512 * packed)


def steps_limit(file):
    """Of all STEP and TRNG together."""
    return max(1 << 24, 512 * file)


def field_data_limit(packed):
    return 65536 * (packed + 1)
