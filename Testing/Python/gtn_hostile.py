# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Changes what is in a `.gtn` file and makes the checksums around it right again."""

import struct

import zstandard

from gtn_container import MAGIC, checksum, table_limit, unpack


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
    """The file of these sections. Streams keep their places if MESH and VALS do."""
    data = MAGIC + struct.pack("<HHI", 1, 0, 0)
    directory = varint(len(sections))
    for name, payload in sections:
        header = struct.pack("<4sHHQQ", name, 1, 1, len(payload), checksum(payload))
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


def replace_stream(data, reference, content):
    """The file with other bytes, as many, in a stream that TABL names. No section may move: there
    must be no streams behind TABL."""
    assert len(content) == reference.length
    old, new = (struct.pack("<Q", number) for number in (reference.checksum, checksum(content)))
    place = slice(reference.offset, reference.offset + reference.length)
    data = data[: place.start] + content + data[place.stop :]
    sections = sections_of(data)
    names = [name for name, _ in sections]
    at = names.index(b"TABL")
    assert not {b"MESH", b"VALS"} & set(names[at:])
    tables = content_of(sections[at][1])
    assert tables.count(old) == 1
    sections[at] = (b"TABL", pack(tables.replace(old, new)))
    return build(sections)

