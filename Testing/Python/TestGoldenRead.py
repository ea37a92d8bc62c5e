# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""vtkGatunReader reads the golden files of every version of the format as expected."""

import os

import gatunGolden as golden

for folder in golden.folders():
    for name, expected in golden.expected(folder).items():
        path = os.path.join(folder, name)
        golden.assert_same(expected, golden.describe_read(path), path)
