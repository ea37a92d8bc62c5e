# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The demo shows each mesh of GATUN_DATA_DIR."""

import os

from gatunCli import skip
from gatunDemo import run_demo

folder = os.environ.get("GATUN_DATA_DIR")
names = sorted(os.listdir(folder)) if folder else []
files = [os.path.abspath(os.path.join(folder, n)) for n in names if n.endswith((".vtu", ".e"))]
if not files:
    skip("GATUN_DATA_DIR is not set, or has no meshes")
run_demo("demo-real", files)
