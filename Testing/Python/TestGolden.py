# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""A decoder written from Documentation/format.md alone reads all golden files as expected, and as
vtkGatunReader does; it rejects all that is cut short or damaged."""

import os
import sys

import gatunGolden as golden

try:
    from describe_decoded import describe_decoded
except ImportError as error:
    print(error)
    sys.exit(golden.gm.SKIPPED)

from gtn_container import FormatError


def is_rejected(data):
    try:
        describe_decoded(data)
    except FormatError:
        return True
    return False


for folder in golden.folders():
    for name, expected in golden.expected(folder).items():
        path = os.path.join(folder, name)
        with open(path, "rb") as file:
            described = describe_decoded(file.read())
        golden.assert_same(expected, described, path)
        golden.assert_same(golden.describe_read(path), described, path)

    with open(os.path.join(folder, "one_tet.gtn"), "rb") as file:
        data = file.read()
    assert not is_rejected(data)
    for length in range(len(data)):
        assert is_rejected(data[:length]), length
    for at in range(len(data)):
        assert is_rejected(data[:at] + bytes([data[at] ^ 1 << at % 8]) + data[at + 1 :]), at
