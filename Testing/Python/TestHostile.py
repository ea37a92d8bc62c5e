# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Files with right checksums around wrong content: the decoder written from the specification and
gtn refuse the same ones, and gtn verify decodes every stream there is."""

import os
import subprocess
import sys

import gatunGolden as golden

try:
    import gtn_hostile as hostile
except ImportError as error:
    print(error)
    sys.exit(golden.gm.SKIPPED)

from gtn_bytes import FormatError
from gtn_container import Container

folder = os.path.join(os.environ["GATUN_TEST_TEMP"], "hostile")
os.makedirs(folder, exist_ok=True)
path = os.path.join(folder, "hostile.gtn")


def gtn_says(command, data):
    """Nothing, or why gtn fails with these bytes."""
    with open(path, "wb") as file:
        file.write(data)
    run = subprocess.run(
        [os.environ["GATUN_TEST_GTN"], command, path],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        universal_newlines=True,
        check=False,
        timeout=60,
    )
    assert run.returncode == (1 if run.stderr else 0), (run.returncode, run.stderr)
    return run.stderr


def decoder_says(data):
    try:
        Container(data)
    except FormatError as error:
        return str(error)
    return ""


# --------------------------------------------------------------------------------------------------
# Tables may not be larger than they can honestly be (11.1 of the specification).

sections = hostile.sections_of(golden.bytes_of("one_tet.gtn"))
good = hostile.build(sections)
assert decoder_says(good) == "" and gtn_says("info", good) == ""


def with_content(name, content):
    return hostile.build(hostile.replace_sections(sections, name, lambda _: hostile.pack(content)))


def meta_of(size):
    """META with a name of the writer that makes it so large."""
    meta = hostile.content_of(next(payload for name, payload in sections if name == b"META"))
    rest = meta[1 + meta[0] :]
    name = b"x" * (size - len(rest) - 3)
    meta = hostile.varint(len(name)) + name + rest
    assert len(meta) == size
    return meta


largest = with_content(b"META", meta_of(1 << 20))
assert decoder_says(largest) == "" and gtn_says("info", largest) == ""
for name, content in (
    (b"META", meta_of((1 << 20) + 1)),
    (b"TABL", bytes((1 << 20) + 1)),
    (b"STEP", bytes((1 << 24) + 1)),
):
    data = with_content(name, content)
    assert decoder_says(data) == "packed part too large", (name, decoder_says(data))
    assert f"claims to hold {len(content)} bytes" in gtn_says("info", data), (name, len(content))
# Of this size it is looked at, and what is in it is wrong.
data = with_content(b"STEP", bytes(1 << 24))
assert "too large" not in decoder_says(data) != "" and "claims" not in gtn_says("info", data) != ""

# --------------------------------------------------------------------------------------------------
# Each stream of the mesh, the original order included, is decoded by gtn verify.

points, tets = golden.gm.lattice(6)
mixed = tets[:, [1, 2, 0, 3]]
mixed[::2] = tets[::2]
golden.gm.write(golden.gm.make_grid(points, mixed), path, ChunkSize=64, KeepOrder=7)
with open(path, "rb") as file:
    data = file.read()
assert gtn_says("verify", data) == ""
container = Container(data)
assert len(container.table.chunks) > 16, "more than verify decodes at once"
chunk = container.table.chunks[1]
for stream, says in (
    ("connectivity", "the mesh of chunk 1"),
    ("geometry", "the mesh of chunk 1"),
    ("original_points", "the original order of the points of chunk 1"),
    ("original_cells", "the original order of the cells of chunk 1"),
    ("corners", "the corners of chunk 1"),
):
    reference = getattr(chunk, stream)
    for noise in (b"\xff", b"\x55\xaa\x0f"):
        content = (noise * reference.length)[: reference.length]
        damaged = hostile.replace_stream(data, reference, content)
        assert gtn_says("info", damaged) == "", stream
        message = gtn_says("verify", damaged)
        assert message.startswith(f"gtn: {path}: {says} at byte "), (stream, message)
