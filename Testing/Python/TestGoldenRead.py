# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""vtkGatunReader reads the golden files as expected."""

import gatunGolden as golden

for name, expected in golden.expected().items():
    golden.assert_same(expected, golden.describe_read(golden.path_of(name)), name)
