#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Writes next to golden files with layers, which makeGoldenLayers has made, what they hold:

    build/release/bin/makeGoldenLayers FOLDER
    PYTHONPATH=build/release/lib/python3/dist-packages Testing/Python/make_golden_layers.py FOLDER

expected.json is as for other golden files, layers.txt tells of layers. Both come from gtn_decoder,
which shares no code with Gatun. It checks, too, that the values of chunks are in their layers.
"""

import glob
import json
import os
import sys

import gatunGolden as golden
from describe_decoded import describe_decoded, describe_layers
from gtn_decoder import Decoder
from gtn_layers import check_layers

MAX_BYTES, MAX_BYTES_IN_TOTAL = 30000, 100000


def main(folder):
    expected, lines, total = {}, [], 0
    for path in sorted(glob.glob(os.path.join(folder, "*.gtn"))):
        name = os.path.basename(path)
        with open(path, "rb") as file:
            data = file.read()
        assert len(data) < MAX_BYTES, name
        total += len(data)
        decoder = Decoder(data)
        decoder.container.verify_layout()
        check_layers(decoder)
        expected[name] = describe_decoded(data)
        golden.assert_same(expected[name], golden.describe_read(path), path)
        lines += describe_layers(decoder, name)
        print("%7d %s" % (len(data), name), flush=True)
    assert total < MAX_BYTES_IN_TOTAL, total
    with open(os.path.join(folder, "expected.json"), "w", encoding="utf-8") as file:
        json.dump(expected, file, indent=1, sort_keys=False)
        file.write("\n")
    with open(os.path.join(folder, "layers.txt"), "w", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")
    print(total, "bytes")


if __name__ == "__main__":
    main(sys.argv[1])
