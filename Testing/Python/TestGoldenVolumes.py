# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""A decoder written from Documentation/ghv-format.md alone reads the golden files of volumes as
their list says, as Testing/Core/testHartleyGolden.cxx does with the library; it rejects what is cut
short."""

import os
import sys

SKIPPED = 125

try:
    from make_golden_volumes import describe_all
    from ghv_decoder import Volume
    from gtn_bytes import FormatError
except ImportError as error:
    print(error)
    sys.exit(SKIPPED)

folder = os.path.join(os.environ["GATUN_TEST_DATA"], "Golden", "ghv-1.0")
with open(os.path.join(folder, "volumes.txt"), encoding="utf-8") as file:
    expected = file.read().splitlines()
described = describe_all(folder)
assert len(described) == len(expected), (len(described), len(expected))
for one, other in zip(expected, described):
    assert one == other, (one, other)

with open(os.path.join(folder, "small.ghv"), "rb") as file:
    small = file.read()
assert Volume(small).voxels().shape == (2, 2, 4)
for length in range(len(small)):
    try:
        Volume(small[:length])
    except FormatError:
        continue
    raise AssertionError(f"{length} bytes of {len(small)} were taken for a file")
