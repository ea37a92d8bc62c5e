# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""pack takes errors of arrays, info tells them, and verify proves them."""

import json
import os
import re

from vtkmodules.util.numpy_support import vtk_to_numpy

from gatunCli import enter_folder, gtn, read, standard_mesh, write

enter_folder("array-errors")
write(standard_mesh(8), "mesh.vtu")
gtn("pack", "-q", "mesh.vtu", "exact.gtn")
gtn("pack", "-q", "--error", "velocity=rel:1e-2", "--error", "*=abs:1e-3", "mesh.vtu", "mesh.gtn")
assert os.path.getsize("mesh.gtn") < os.path.getsize("exact.gtn")

# All kinds of errors are told, with the largest one; and none where there is none.
for row in json.loads(gtn("info", "--json", "mesh.gtn"))["arrays"]:
    if row["name"] == "velocity":
        bound, reached = re.fullmatch(r"(rel:0.01), reached ([0-9.e+-]+)", row["error"]).groups()
        assert bound == "rel:0.01" and float(reached) > 0
        shown = float(reached)
assert all(not row.get("error") for row in json.loads(gtn("info", "--json", "exact.gtn"))["arrays"])
gtn("info", "mesh.gtn", says="rel:0.01, reached")

# The error that is told is the largest one there is.
gtn("pack", "-q", "--keep-order", "all", "--error", "velocity=rel:1e-2", "mesh.vtu", "ordered.gtn")
gtn("unpack", "-q", "ordered.gtn", "back.vtu")
before, after = (vtk_to_numpy(read(name).GetPointData().GetArray("velocity")).astype(float)
                 for name in ("mesh.vtu", "back.vtu"))
largest = abs(before - after).max()
assert 0 < largest <= 1e-2 * (before.max(0) - before.min(0)).max()
assert f"rel:0.01, reached {largest:.6g}"[:24] in gtn("info", "ordered.gtn")

# What verify finds: errors within the bounds, and others.
for name in "mesh.gtn", "ordered.gtn":
    said = gtn("verify", name, "mesh.vtu", says="but for bounded errors")
    worst = float(re.search(r"the largest is ([0-9.]+) of its bound", said).group(1))
    assert 0 < worst <= 1
gtn("verify", "exact.gtn", "back.vtu", code=1, says="velocity")
gtn("pack", "-q", "--keep-order", "all", "--error", "velocity=rel:1e-6", "back.vtu", "finer.gtn")
gtn("verify", "finer.gtn", "mesh.vtu", code=1, says="velocity")

# Usage.
for error in "velocity", "velocity=abs:0", "velocity=abs:nan", "velocity=up:1", "velocity=bits:99":
    gtn("pack", "--error", error, "mesh.vtu", "no.gtn", code=2, says="--error")
gtn("pack", "--error", "nobody=abs:1", "mesh.vtu", "no.gtn", code=1, says="nobody")
gtn("pack", "--keep-zeros", "mesh.vtu", "no.gtn", code=2, says="--error")
assert not os.path.exists("no.gtn")
