# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""A decoder written from Documentation/ghv-format.md alone reads the golden files of volumes as
expected, as Testing/Core/Hartley/testHartleyGolden.cxx does with the library; it rejects what is cut
short."""

import sys

import gatunGolden as golden

try:
    from describe_decoded import describe_volume
    from ghv_decoder import Volume
except ImportError as error:
    print(error)
    sys.exit(golden.gm.SKIPPED)

from gtn_bytes import FormatError

for name, expected in golden.expected("volumes").items():
    golden.assert_same(expected, describe_volume(name, Volume(golden.bytes_of(name))), name)

small = golden.bytes_of("small_volume.ghv")
assert Volume(small).voxels().shape == (2, 2, 4)
for length in range(len(small)):
    try:
        Volume(small[:length])
    except FormatError:
        continue
    raise AssertionError(f"{length} bytes of {len(small)} were taken for a file")
