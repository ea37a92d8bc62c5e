#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Writes next to golden files with trees of merges, which makeGoldenTrees has made, what they hold:

    build/release/bin/makeGoldenTrees FOLDER        # or makeGoldenSurfaceTrees, or both
    PYTHONPATH=build/release/lib/python3/dist-packages Testing/Python/make_golden_trees.py FOLDER

expected.json is as for other golden files, trees.txt tells of trees and base meshes. Both come from
gtn_decoder, which shares no code with Gatun. It checks, too, that ranges after merges enclose just
what they have to, that base meshes are what is left, and that dependencies are those of the mesh.
"""

import glob
import json
import os
import sys

import gatunGolden as golden
from describe_decoded import describe_decoded, describe_tree
from gtn_decoder import Decoder
from gtn_dependencies import check_dependencies
from gtn_tree import check_level, check_ranges

MAX_BYTES, MAX_BYTES_IN_TOTAL = 30000, 150000


def check(decoder):
    decoder.container.verify_layout()
    check_ranges(decoder)
    check_dependencies(decoder)
    for i in range(len(decoder.container.tree.levels)):
        level = decoder.level(i)
        check_level(decoder, i, level)
        check(level)


def main(folder):
    expected, lines, total = {}, [], 0
    for path in sorted(glob.glob(os.path.join(folder, "*.gtn"))):
        name = os.path.basename(path)
        with open(path, "rb") as file:
            data = file.read()
        assert len(data) < MAX_BYTES, name
        total += len(data)
        decoder = Decoder(data)
        check(decoder)
        expected[name] = describe_decoded(data)
        golden.assert_same(expected[name], golden.describe_read(path), path)
        lines += describe_tree(decoder, name)
        print("%7d %s" % (len(data), name), flush=True)
    assert total < MAX_BYTES_IN_TOTAL, total
    with open(os.path.join(folder, "expected.json"), "w", encoding="utf-8") as file:
        json.dump(expected, file, indent=1, sort_keys=False)
        file.write("\n")
    with open(os.path.join(folder, "trees.txt"), "w", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")
    print(total, "bytes")


if __name__ == "__main__":
    main(sys.argv[1])
