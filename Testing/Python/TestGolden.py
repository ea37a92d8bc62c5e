# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""A decoder written from Documentation/format.md and cell-codec.md alone reads all golden files as
expected, with their merges, base meshes, boundaries and layers; it rejects all that is cut short or
damaged."""

import sys

import gatunGolden as golden

try:
    from describe_decoded import describe_core, describe_decoded, describe_decoder
except ImportError as error:
    print(error)
    sys.exit(golden.gm.SKIPPED)

from gtn_bytes import FormatError
from gtn_decoder import Decoder

#: Small files, of which every byte is damaged.
SMALL = ("one_tet", "two_tets", "seam", "two_layers", "two_cells", "two_faces", "boundary",
         "two_tets_and_one")
BOUNDARIES = ("boundary", "boundary_of_cells", "bounded_errors", "fast_bounded_errors", "hierarchy_of_moving_points",
              "series_of_hierarchies")


def is_rejected(data):
    try:
        describe_decoded(data)
    except FormatError:
        return True
    return False


lines = {kind: golden.expected(kind) for kind in ("merges", "layers")}
for name, expected in golden.expected().items():
    decoder = Decoder(golden.bytes_of(name))
    golden.assert_same(expected, describe_decoder(decoder), name)
    described = describe_core(name, decoder)
    for kind in lines:
        golden.assert_same(lines[kind].get(name, []), described.get(kind, []), name)
    assert (decoder.boundary() is not None) == (name[:-4] in BOUNDARIES), name

for name in SMALL:
    data = golden.bytes_of(name + ".gtn")
    assert not is_rejected(data)
    for length in range(len(data)):
        assert is_rejected(data[:length]), (name, length)
    for at in range(len(data)):
        assert is_rejected(data[:at] + bytes([data[at] ^ 1 << at % 8]) + data[at + 1 :]), (name, at)
