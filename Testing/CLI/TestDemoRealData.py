# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The demo shows each mesh of GATUN_DATA_DIR, but for large files, which take long only."""

import os

from gatunCli import skip
from gatunDemo import run_demo

MOST_BYTES = 1500000

folder = os.environ.get("GATUN_DATA_DIR")
names = sorted(os.listdir(folder)) if folder else []
files = [os.path.abspath(os.path.join(folder, n)) for n in names if n.endswith((".vtu", ".e"))]
files = [file for file in files if os.path.getsize(file) < MOST_BYTES]
if not files:
    skip("GATUN_DATA_DIR is not set, or has no meshes")
run_demo("demo-real", files)
