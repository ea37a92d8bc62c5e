# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Series whose points move, by gtn: from a .pvd list and from several files into one file, and back."""

import json
import os

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from gatunCli import enter_folder, gtn, lattice, make_grid, read, write

enter_folder("moving")
points, tets = lattice(6)
STEPS = 9


def places(step):
    step -= step in (4, 5)  # stands still at step 4, and goes back to 4's points at step 5
    moved = points * (1 + 0.02 * step)
    moved[:, 1] += 0.1 * np.sin(3 * points[:, 0] + step) * (step > 1)
    return moved.astype(np.float32) if step > 1 else points.astype(np.float32)


def grid_at(step):
    return make_grid(places(step), tets, {"field": np.sin(points[:, 2] + step).astype(np.float32)})


files = [f"step{step}.vtu" for step in range(STEPS)]
for step, name in enumerate(files):
    write(grid_at(step), name)
with open("run.pvd", "w", encoding="ascii") as file:
    sets = "".join(f'<DataSet timestep="{s / 4}" file="{f}"/>' for s, f in enumerate(files))
    file.write(f'<VTKFile type="Collection"><Collection>{sets}</Collection></VTKFile>')

for arguments in (["run.pvd"], files):
    gtn("pack", "-f", "--keep-order", "all", "--key-step-interval", 3, *arguments, "run.gtn", says="9 time steps")
    gtn("verify", "run.gtn", *arguments, says="identical")
    gtn("verify", "run.gtn")
    for step in (8, 0, 4, 3):
        gtn("unpack", "-q", "-f", "--step", step, "run.gtn", "back.vtu")
        back = read("back.vtu")
        assert vtk_to_numpy(back.GetPoints().GetData()).tobytes() == places(step).tobytes(), step
info = json.loads(gtn("info", "--json", "run.gtn"))
assert info["pointsMove"] is True and info["formatVersion"] == 1
sizes = {part: row["bytes"] for part, row in info["sizes"].items()}
assert sizes["motion"] > 0
assert sum(bytes for part, bytes in sizes.items() if part != "file") == sizes["file"]

# gtn verify finds points of another step.
write(grid_at(7), "other.vtu")
gtn("verify", "run.gtn", *files[:6], "other.vtu", *files[7:], code=1, says="differs at step 6")

# What stands still is stored once, as before.
write(make_grid(places(0), tets, {"field": np.zeros(len(points), np.float32)}), "still.vtu")
gtn("pack", "-q", "-f", files[0], "still.vtu", "still.gtn")
assert json.loads(gtn("info", "--json", "still.gtn"))["pointsMove"] is False

# With an error of the coordinates the file is smaller, and verified.
gtn("pack", "-q", "-f", "run.pvd", "exact.gtn")
gtn("pack", "-q", "-f", "--point-tolerance", "rel:1e-3", "run.pvd", "rounded.gtn")
assert os.path.getsize("rounded.gtn") < 0.8 * os.path.getsize("exact.gtn")

# Packed again, with a hierarchy.
gtn("pack", "-q", "-f", "--hierarchy", "--boundary", "run.gtn", "tree.gtn")
gtn("verify", "tree.gtn", "run.gtn", says="identical")
gtn("render", "-q", "-f", "--step", 8, "--size", "80x60", "tree.gtn", "picture.png")
gtn("contour", "-q", "-f", "--step", 8, "--value", 0.3, "tree.gtn", "surface.vtp")
assert os.path.getsize("surface.vtp") > 1000

# What is refused says why.
gtn("pack", "-q", "--pieces", 3, "run.pvd", "never.gtn", code=1, says="points that move")
assert not os.path.exists("never.gtn")
