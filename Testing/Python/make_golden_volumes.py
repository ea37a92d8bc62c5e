# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Describes the golden files of volumes by the decoder that was written from
Documentation/ghv-format.md alone:

    make_golden_volumes.py FOLDER > FOLDER/volumes.txt

The files themselves are written by the program makeGoldenVolumes.
"""

import os
import struct
import sys

from ghv_decoder import Volume
from gtn_bytes import checksum


def describe(path):
    """Lines as Testing/Core/testHartleyGolden.cxx makes them."""
    with open(path, "rb") as file:
        volume = Volume(file.read())
    yield f"= {os.path.basename(path)}"
    yield "size {} {} {} type {} block {} {} {} chunks {}".format(
        *volume.size, volume.kind, *volume.block, len(volume.chunks))
    place = [*volume.origin, *volume.spacing, *volume.direction, volume.min, volume.max]
    packed = struct.pack(f"<{len(place)}d3ii", *place, *volume.first_index, volume.vtk_type)
    yield f"place {checksum(packed):016x} name {volume.name}"
    for chunk in range(len(volume.chunks)):
        packed = b""
        terms = 0
        for number, block in enumerate(volume.integers(chunk)):
            values = volume.coefficients(block)
            for index, value in enumerate(values):
                if value:
                    packed += struct.pack("<IIf", number, index, value)
                    terms += 1
        yield f"chunk {chunk} terms {terms} {checksum(packed):016x}"
    # Those of floating point may differ in their last bits.
    if volume.kind <= 8:
        yield f"voxels {checksum(volume.voxels().tobytes()):016x}"


def describe_all(folder):
    lines = []
    for name in sorted(os.listdir(folder)):
        if name.endswith(".ghv"):
            lines += describe(os.path.join(folder, name))
    return lines


if __name__ == "__main__":
    print("\n".join(describe_all(sys.argv[1])))
