# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Changes what is in a `.gtn` file and makes the checksums around it right again."""

import struct
from types import SimpleNamespace as Record

import zstandard

from gtn_bytes import checksum, table_limit, unpack
from gtn_container import MAGIC, Container


UNKNOWN = b"ROOM"


def sections_of(data):
    """Header (24 bytes) and payload of each section, in the order of the file, without DIRY."""
    at = 16
    sections = []
    while at < len(data) - 32:
        name, length = data[at : at + 4], struct.unpack("<Q", data[at + 8 : at + 16])[0]
        if name == b"DIRY":
            break
        sections.append((name, data[at + 24 : at + 24 + length]))
        at += 24 + length
    return sections


def varint(number):
    encoded = bytearray()
    while number >= 128:
        encoded.append(number & 127 | 128)
        number >>= 7
    return bytes(encoded) + bytes([number])


def build(sections):
    """The file of these sections. Streams keep their places if MESH, VALS and PAGE do."""
    data = MAGIC + struct.pack("<II", 1, 0)
    directory = varint(len(sections))
    for name, payload in sections:
        flags = 0 if name == UNKNOWN else 1
        header = struct.pack("<4sHHQQ", name, 1, flags, len(payload), checksum(payload))
        directory += header + struct.pack("<Q", len(data) + 24)
        data += header + payload
    data += struct.pack("<4sHHQQ", b"DIRY", 1, 1, len(directory), checksum(directory))
    check = checksum(data[:16] + directory)
    trailer = struct.pack("<3Q", len(data), len(directory), check) + b"GTNEND\r\n"
    return data + directory + trailer


def content_of(payload):
    """What is in a packed part."""
    return unpack(payload, table_limit)


def pack(content):
    return varint(len(content)) + zstandard.ZstdCompressor(level=12).compress(content)


def reference(stream):
    """A stream reference as tables have it."""
    return varint(stream.length) + varint(stream.offset) + struct.pack("<Q", stream.checksum)


def replace_sections(sections, name, change):
    """The sections, those of a name with what change(payload) gives. These come last, and unknown
    ones, which readers skip, take their places, so that no stream moves."""
    kept = [(UNKNOWN if n == name else n, payload) for n, payload in sections]
    return kept + [(n, change(payload)) for n, payload in sections if n == name]


def replace_stream(data, stream, content):
    """The file with other bytes, as many, in a stream that TABL or one of its pages names."""
    assert len(content) == stream.length
    old, new = (struct.pack("<Q", number) for number in (stream.checksum, checksum(content)))
    data = data[: stream.offset] + content + data[stream.offset + stream.length :]
    container = Container(data)
    sections = sections_of(data)
    for page in container.table.pages:
        details = content_of(container.stream(page.details))
        if old in details:
            assert details.count(old) == 1
            packed = pack(details.replace(old, new))
            old = reference(page.details)
            size = 16 + sum(24 + len(payload) for _, payload in sections)
            place = Record(length=len(packed), offset=size + 24, checksum=checksum(packed))
            new = reference(place)
            sections.append((b"PAGE", packed))
            break

    def change(payload):
        tables = content_of(payload)
        assert tables.count(old) == 1
        return pack(tables.replace(old, new))

    return build(replace_sections(sections, b"TABL", change))
