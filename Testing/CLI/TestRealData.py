# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Each mesh of GATUN_DATA_DIR is the same after packing, in any order and with all order kept."""

import json
import os

from gatunCli import enter_folder, gtn, skip

folder = os.environ.get("GATUN_DATA_DIR")
if not folder:
    skip("GATUN_DATA_DIR is not set")
names = sorted(name for name in os.listdir(folder) if name.endswith((".vtu", ".e")))
if not names:
    skip("no meshes in " + folder)
folder = os.path.abspath(folder)
enter_folder("real")
for name in names:
    original = os.path.join(folder, name)
    for order in ("none", "all"):
        packed = f"{name}-{order}.gtn"
        gtn("pack", "--keep-order", order, original, packed)
        gtn("verify", "--no-sets", packed, original, says="identical")
        os.remove(packed) if name != "mug.e" else None
if "mug.e" in names:
    assert len(json.loads(gtn("info", "--json", "mug.e-none.gtn"))["times"]) == 21
    # With side sets and node sets: more blocks, which the file tells apart.
    original = os.path.join(folder, "mug.e")
    gtn("pack", "--sets", original, "sets.gtn")
    gtn("verify", "sets.gtn", original, says="identical")
    gtn("verify", "mug.e-none.gtn", original, code=1, says="--sets keeps them")
    cells = [json.loads(gtn("info", "--json", name))["cells"] for name in ("mug.e-none.gtn", "sets.gtn")]
    assert cells[0] < cells[1], cells
