# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Random changes of `.gtn` and `.ghv` files: of their bytes, or of what is in their sections, with
checksums that are right again."""

import struct
import sys

import xxhash
import zstandard

from soakContext import ROOT

sys.path.append(str(ROOT / "Testing" / "Python"))
from gtn_hostile import varint  # pylint: disable=wrong-import-position

HEADER, SECTION, TRAILER = 16, 24, 32
MAGICS = {bytes.fromhex("8947544E0D0A1A0A"): b"GTNEND\r\n", b"\x89GHV\r\n\x1a\n": b"GHVEND\r\n"}
EMBEDDED = (b"LEVL", b"BNDY", b"GRID")  # whole files
UNKNOWN = b"ROOM"


def unpack(packed):
    """The content of a packed part, or None if it is none."""
    length = shift = 0
    for at, byte in enumerate(packed[:5]):
        length |= (byte & 127) << shift
        shift += 7
        if byte < 128:
            break
    else:
        return None
    try:
        content = zstandard.ZstdDecompressor().decompress(packed[at + 1:], max_output_size=1 << 24)
    except zstandard.ZstdError:
        return None
    return content if len(content) == length else None


def pack(content):
    return varint(len(content)) + zstandard.ZstdCompressor().compress(content)


def change_bytes(data, random):
    """The bytes with one of the usual accidents."""
    data = bytearray(data)
    at = random.randrange(len(data) + 1)
    count = min(random.choice((1, 2, 4, 8, 64, 512)), len(data))
    how = random.randrange(8)
    if how == 0 and data:
        data[at % len(data)] ^= 1 << random.randrange(8)
    elif how == 1:
        data[at:at + count] = random.randbytes(len(data[at:at + count]))
    elif how == 2:
        del data[at:]
    elif how == 3:
        del data[at:at + count]
    elif how == 4:
        data[at:at] = random.randbytes(count)
    elif how == 5:
        data[at:at + count] = bytes([random.choice((0, 255))]) * len(data[at:at + count])
    elif how == 6:
        other = random.randrange(len(data) + 1)
        data[at:at + count] = data[other:other + count]
    else:
        number = random.choice((0, 1, 127, 128, 255, 1 << 16, 1 << 31, (1 << 32) - 1, 1 << 63))
        encoded = random.choice((varint(number), struct.pack("<Q", number)))
        data[at:at + len(encoded)] = encoded
    return bytes(data)


def split(data):
    """(name, version, flags, payload) of each section, or None if this is no such file."""
    if data[:8] not in MAGICS:
        return None
    at, sections = HEADER, []
    while at + SECTION <= len(data) - TRAILER:
        name, version, flags, length, _ = struct.unpack_from("<4sHHQQ", data, at)
        if name == b"DIRY":
            return sections
        sections.append((name, version, flags, data[at + SECTION:at + SECTION + length]))
        at += SECTION + length
    return None


def join(header, sections):
    """The file of these sections."""
    checksum = xxhash.xxh3_64_intdigest
    data = bytearray(header)
    directory = varint(len(sections))
    for name, version, flags, payload in sections:
        entry = struct.pack("<4sHHQQ", name, version, flags, len(payload), checksum(payload))
        data += entry
        directory += entry + struct.pack("<Q", len(data))
        data += payload
    data += struct.pack("<4sHHQQ", b"DIRY", 1, 1, len(directory), checksum(directory))
    trailer = struct.pack("<3Q", len(data), len(directory), checksum(header + directory))
    return bytes(data) + directory + trailer + MAGICS[header[:8]]


def change_section(data, random):
    """The file with a change in one of its sections, and right checksums around it."""
    sections = split(data)
    if not sections:
        return change_bytes(data, random)
    at = random.randrange(len(sections))
    name, version, flags, payload = sections[at]
    content = unpack(payload)
    if name in EMBEDDED and random.random() < 0.9:
        # In front of a mesh that is in one piece is the length of its list of runs, 0.
        begin = 1 if name == b"GRID" and payload[:1] == b"\0" else 0
        changed = payload[:begin] + change_section(payload[begin:], random)
    elif content is not None and random.random() < 0.9:
        for _ in range(random.choice((1, 1, 1, 2, 4))):
            content = change_bytes(content, random)
        changed = pack(content)
    else:
        changed = change_bytes(payload, random)
    how = random.randrange(20)
    if how == 0:
        del sections[at]
    elif how == 1:
        sections.insert(at, sections[at])
    elif how == 2:
        version, flags = random.randrange(6), random.randrange(3)
        sections[at] = name, version, flags, payload
    elif len(changed) == len(payload):
        sections[at] = name, version, flags, changed
    else:
        # Readers skip the old payload, so that streams behind it stay at their places.
        sections[at] = UNKNOWN, 1, 0, payload
        sections.append((name, version, flags, changed))
    return join(data[:HEADER], sections)
