# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Files of cells with right checksums around wrong content: the decoder written from the
specification and gtn verify refuse the same ones, and read the same from others."""

import os
import random
import subprocess
import sys

import gatunGolden as golden

try:
    import gtn_hostile as hostile
except ImportError as error:
    print(error)
    sys.exit(golden.gm.SKIPPED)

from describe_decoded import describe_decoded
from gtn_bytes import Bytes, FormatError
from gtn_container import Container
from gtn_tables import read_cells

DAMAGES = 250
path = golden.gm.temporary("hostile-cells.gtn")


def content(name):
    return golden.bytes_of(name + ".gtn")


def gtn_says(data):
    """Nothing, or why gtn verify fails with these bytes."""
    with open(path, "wb") as file:
        file.write(data)
    run = subprocess.run(
        [os.environ["GATUN_TEST_GTN"], "verify", path], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
        universal_newlines=True, check=False, timeout=60)
    assert run.returncode == (1 if run.stderr else 0), (run.returncode, run.stderr)
    return run.stderr


def decode(data):
    """A description, or a message."""
    try:
        return describe_decoded(data)
    except FormatError as error:
        return str(error)


# --------------------------------------------------------------------------------------------------
# Section CELL


def with_cells(data, change):
    """The file after a change of section CELL, as read_cells gives it."""
    sections = hostile.sections_of(data)
    at = [name for name, _ in sections].index(b"CELL")
    cells = read_cells(Bytes(hostile.content_of(sections[at][1])))
    cells.types = list(cells.types.items())
    change(cells)
    table = hostile.varint(len(cells.types))
    for kind, count in cells.types:
        table += bytes([kind]) + hostile.varint(count)
    table += hostile.varint(len(cells.chunks))
    for chunk in cells.chunks:
        if chunk is None or isinstance(chunk, bytes):
            table += chunk or b"\0"
            continue
        table += b"\1"
        for number in (chunk.cells, chunk.corners, chunk.face_values, chunk.polyhedra):
            table += hostile.varint(number)
    table += hostile.varint(len(cells.shapes)) + cells.shapes
    return hostile.build(hostile.replace_sections(sections, b"CELL", lambda _: hostile.pack(table)))


def setting(**values):
    """A change of the first chunk of cells."""

    def change(cells):
        for name, value in values.items():
            number = getattr(cells.chunks[0], name)
            setattr(cells.chunks[0], name, value(number) if callable(value) else value)

    return change


def shapes(*codes):
    def change(cells):
        cells.shapes = hostile.varint(len(codes))
        for code in codes:
            cells.shapes += hostile.varint(len(code)) + bytes(code)

    return change


def types(*pairs):
    def change(cells):
        cells.types = list(pairs)

    return change


def chunks(*numbers):
    def change(cells):
        cells.chunks = list(numbers)

    return change


TETRAHEDRON = [3, 3, 3, 3, 3, 3, 3]
LENS = [3, 3, 2]  # two triangles
PYRAMID = [4, 3, 4, 3, 4, 3, 4, 3, 4]
two_cells = content("two_cells")  # which make no use of shapes
for change in (
    lambda cells: None, shapes(), shapes(TETRAHEDRON), shapes(LENS), shapes(PYRAMID, TETRAHEDRON),
):
    data = with_cells(two_cells, change)
    assert gtn_says(data) == ""
    golden.assert_same(golden.describe_read(path), decode(data), path)
for i, change in enumerate((
    types((12, 1), (13, 1), (14, 0)), types((13, 1), (12, 1)), types((12, 1), (12, 1)),
    types((12, 1), (13, 2)), types((12, 1)), types(), types((12, 2)), types((12, 1), (14, 1)),
    chunks(), chunks(None), chunks(None, None), chunks(b"\2"),
    setting(cells=0), setting(cells=1), setting(cells=3), setting(cells=(1 << 20) + 1),
    setting(corners=lambda n: n - 1), setting(corners=lambda n: n + 1), setting(corners=1 << 24),
    setting(corners=(1 << 24) + 1), setting(corners=11), setting(face_values=1),
    setting(polyhedra=1), setting(polyhedra=3), setting(polyhedra=1, face_values=1),
    shapes([]), shapes([2]), shapes([255]), shapes([3]), shapes(TETRAHEDRON[:-1]),
    shapes([*TETRAHEDRON, 0]), shapes(TETRAHEDRON, TETRAHEDRON), shapes([3, 3, 4, 3, 3, 3, 3]),
    shapes([3, 3, 3, 3, 2, 3, 1]), shapes([3, 2]), shapes([3, 3, 0]), shapes([3, 4, 3, 2]),
    shapes(PYRAMID, [3, *PYRAMID[1:]]), shapes(PYRAMID, [3, 3, 3, 3, 4, 4, 3, 3, 4]),
    lambda cells: setattr(cells, "shapes", b""),
    lambda cells: setattr(cells, "shapes", cells.shapes + b"\0"),
)):
    data = with_cells(two_cells, change)
    assert isinstance(decode(data), str) and gtn_says(data) != "", (i, decode(data), gtn_says(data))

# --------------------------------------------------------------------------------------------------
# Streams of chunks

# Flags of the walks that a stream has.
data = content("closed_shell")
reference = Container(data).table.chunks[0].connectivity
stream = data[reference.offset : reference.offset + reference.length]
assert stream[0] == 20
for flags in (0, 1, 2, 3, 4, 5, 6, 8, 9, 10, 12, 14, 16, 17, 21, 36, 148):
    changed = hostile.replace_stream(data, reference, bytes([flags]) + stream[1:])
    decoded, message = decode(changed), gtn_says(changed)
    assert isinstance(decoded, str) and message != "", (flags, decoded, message)
    if flags in (2, 6, 8, 10, 12, 14, 16, 17) or flags >= 32:
        assert decoded.startswith("flags"), (flags, decoded)

surfaces = ("closed_shell", "shells_of_cells", "large_polygons", "two_faces",
            "surface_in_any_order")
others = ("two_cells", "hexahedra", "mixed_cells", "polyhedra", "polygons_and_hanging_nodes",
          "cells_in_any_order", "degenerate_cells", "odd_places_of_cells", "nonlinear_cells")
rng = random.Random(1)
refused = same = 0
while refused + same < DAMAGES:
    data = content(rng.choice(rng.choice((surfaces, others))))
    chunk = rng.choice(Container(data).table.chunks)
    reference = getattr(chunk, rng.choice(["connectivity"] * 4 + ["geometry", "corners"]))
    if reference is None:
        continue
    stream = bytearray(data[reference.offset : reference.offset + reference.length])
    for _ in range(rng.choice((1, 1, 1, 2, 5))):
        at = rng.randrange(len(stream))
        stream[at] = rng.choice((stream[at] ^ 1 << rng.randrange(8), rng.randrange(256), 255, 0))
    try:
        data = hostile.replace_stream(data, reference, bytes(stream))
    except AssertionError:
        continue  # two streams with the same checksum
    decoded, message = decode(data), gtn_says(data)
    if message:
        assert isinstance(decoded, str), message
        refused += 1
    else:
        # gtn may take missing bits for 0 (11.2).
        if decoded != "raw part ends too early":
            golden.assert_same(golden.describe_read(path), decoded, path)
        same += 1
assert refused > 100 and same > 10
