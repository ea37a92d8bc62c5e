# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""A decoder written from Documentation/format.md and cell-codec.md alone reads all golden files as
expected, and as vtkGatunReader does, with their trees of merges, base meshes and layers; it rejects
all that is cut short or damaged."""

import os
import sys

import gatunGolden as golden

try:
    from describe_decoded import (
        describe_decoded, describe_decoder, describe_layers, describe_tree)
except ImportError as error:
    print(error)
    sys.exit(golden.gm.SKIPPED)

from gtn_boundary import check_boundary
from gtn_bytes import FormatError
from gtn_decoder import Decoder
from gtn_dependencies import check_dependencies
from gtn_layers import check_layers
from gtn_tree import check_level, check_ranges

SMALLEST = {"v1.0": "one_tet.gtn", "v1.1": "two_tets_and_one.gtn", "v1.2": "two_layers.gtn",
            "v1.3": "two_cells.gtn", "v1.4": "two_faces.gtn",
            "v1.5": "one_tet.gtn", "v1.6": "seam_and_one.gtn", "v1.7": "two_tets.gtn",
            "v1.8": "small.gtn", "v1.9": "bounded_small.gtn", "v1.10": "moving_small.gtn",
            "v1.11": "dying_small.gtn", "v1.12": "frames_small.gtn"}


def is_rejected(data):
    try:
        describe_decoded(data)
    except FormatError:
        return True
    return False


for folder in golden.folders():
    decoders = {}
    for name, expected in golden.expected(folder).items():
        path = os.path.join(folder, name)
        with open(path, "rb") as file:
            decoders[name] = Decoder(file.read())
        described = describe_decoder(decoders[name])
        golden.assert_same(expected, described, path)
        golden.assert_same(golden.describe_read(path), described, path)

    for name, decoder in decoders.items():
        boundary = decoder.boundary()
        has_boundary = folder.endswith("v1.5") or name in (
            "bounded_boundary.gtn", "moving_tree.gtn", "returning_levels.gtn", "series_levels.gtn")
        assert (boundary is not None) == has_boundary, name
        if boundary is not None:
            check_boundary(decoder, boundary)

    trees = os.path.join(folder, "trees.txt")
    if os.path.exists(trees):
        lines = []
        for name, decoder in decoders.items():
            lines += describe_tree(decoder, name)
            check_ranges(decoder)
            check_dependencies(decoder)
            for i in range(len(decoder.container.tree.levels)):
                level = decoder.level(i)
                check_level(decoder, i, level)
                check_dependencies(level)
        with open(trees, encoding="utf-8") as file:
            golden.assert_same(file.read().splitlines(), lines, trees)

    layers = os.path.join(folder, "layers.txt")
    if os.path.exists(layers):
        lines = []
        for name, decoder in decoders.items():
            lines += describe_layers(decoder, name)
            check_layers(decoder)
        with open(layers, encoding="utf-8") as file:
            golden.assert_same(file.read().splitlines(), lines, layers)

    with open(os.path.join(folder, SMALLEST[os.path.basename(folder)]), "rb") as file:
        data = file.read()
    assert not is_rejected(data)
    for length in range(len(data)):
        assert is_rejected(data[:length]), length
    for at in range(len(data)):
        assert is_rejected(data[:at] + bytes([data[at] ^ 1 << at % 8]) + data[at + 1 :]), at
