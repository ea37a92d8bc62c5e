# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Steps that are added to a file: its meshes are not stored again, all steps come back, and what does
not fit leaves the file as it was."""

import json
import os
import shutil

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk

from gatunCli import enter_folder, gtn, lattice, make_grid, write

enter_folder("append")
points, tets = lattice(12)
random = np.random.default_rng(7)


def make(time, points=points, tets=tets, **arrays):
    values = {"u": random.random(len(points)), **arrays}
    grid = make_grid(points, tets, values)
    array = numpy_to_vtk(np.array([float(time)]), deep=True)
    array.SetName("TimeValue")
    grid.GetFieldData().AddArray(array)
    return grid


def info(file):
    return json.loads(gtn("info", "--json", file))


def refuse(*arguments, says):
    with open("run.gtn", "rb") as file:
        before = file.read()
    gtn("pack", "--append", *arguments, "run.gtn", code=1, says=says)
    with open("run.gtn", "rb") as file:
        assert file.read() == before
    assert not [name for name in os.listdir() if ".part-" in name]


names = []
for time in range(7):
    names.append(f"step{time}.vtu")
    write(make(time), names[-1])

# The mesh is stored once, whether steps come one by one or several at a time.
for more in [], ["--keep-order", "all"]:
    gtn("pack", "-f", *more, names[0], names[1], "run.gtn")
    gtn("pack", "--append", names[2], "run.gtn")
    gtn("pack", "--append", "-q", names[4], names[3], "run.gtn")
    gtn("pack", "--append", "-q", *names[5:], "run.gtn")
    assert info("run.gtn")["times"] == list(range(7))
    gtn("verify", "run.gtn", says="intact")
    gtn("verify", "run.gtn", *names, says="identical")
    gtn("pack", "-f", "-q", *more, *names, "whole.gtn")
    gtn("pack", "-f", "-q", *more, "--skip", "u", names[0], "mesh.gtn")
    mesh = os.path.getsize("mesh.gtn")
    added = os.path.getsize("run.gtn") - os.path.getsize("whole.gtn")
    assert added < 0.2 * mesh, f"{added} bytes more, and the mesh has {mesh}"

# Another mesh, which returns; it is stored once, too. Points that move.
moved, others = lattice(9, seed=3)
for time in 7, 8, 9:
    names.append(f"step{time}.vtu")
    write(make(time, moved + (0.01 * (time - 8) if time > 8 else 0), others), names[-1])
gtn("pack", "--append", "-q", names[7], "run.gtn")
before = os.path.getsize("run.gtn")
gtn("pack", "--append", "-q", names[8], "run.gtn")
gtn("pack", "-f", "-q", names[8], "--keep-order", "all", "alone.gtn")
assert os.path.getsize("run.gtn") - before < 0.7 * os.path.getsize("alone.gtn")
gtn("pack", "--append", "-q", names[9], "run.gtn")
gtn("verify", "run.gtn", *names, says="identical")

# Options of the mesh may differ: a hierarchy for the new steps only.
shutil.copy("run.gtn", "levels.gtn")
write(make(10), "step10.vtu")
gtn("pack", "--append", "-q", "--hierarchy", "step10.vtu", "levels.gtn")
gtn("verify", "levels.gtn", *names, "step10.vtu", says="identical")

# A file that is not there is made.
gtn("pack", "--append", "-q", names[0], "new.gtn")
gtn("pack", "--append", "-q", names[1], "new.gtn")
gtn("verify", "new.gtn", names[0], names[1], says="identical")

# What does not fit.
refuse(names[3], says="the times of the steps must ascend: 3 follows 9")
write(make_grid(points, tets, {"u": np.zeros(len(points))}), "timeless.vtu")
refuse("timeless.vtu", says="a step without time follows 9")
write(make(11, v=np.zeros(len(points))), "more.vtu")
refuse("more.vtu", says="'v' (double with 1 component) appears, which the file does not have")
gtn("pack", "--append", "-q", "--skip", "v", "more.vtu", "run.gtn")
less = make(12)
less.GetPointData().RemoveArray("u")
write(less, "less.vtu")
refuse("less.vtu", says="the point array 'u' (double with 1 component) of the steps before is missing")
gtn("pack", "--append", "-q", "--fill-missing", "less.vtu", "run.gtn")
write(make(13, u=np.zeros(len(points), dtype=np.int32)), "type.vtu")
refuse("type.vtu", says="'u' is int with 1 component, and in the steps before double")
gtn("pack", "-q", "timeless.vtu", "timeless.gtn")
gtn("pack", "--append", names[0], "timeless.gtn", code=1,
    says="timeless.gtn: the file has no time, so that no steps can be added")
gtn("pack", "--append", "-f", names[0], "run.gtn", code=2, says="--force excludes --append")
gtn("pack", "--append", "--pieces", 2, names[0], "run.gtn", code=2, says="--append needs the whole mesh")

# A damaged file is not copied.
with open("new.gtn", "r+b") as file:
    file.seek(200)
    byte = file.read(1)[0]
    file.seek(200)
    file.write(bytes([byte ^ 1]))
gtn("pack", "--append", names[5], "new.gtn", code=1, says="is damaged")
