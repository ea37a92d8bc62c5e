# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Several files, a list of files (.pvd) and an Exodus file become one file with time steps."""

import json
import os

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

from gatunCli import enter_folder, gtn, lattice, make_grid, read, waves, write

enter_folder("series")
points, tets = lattice(5)
STEPS = 11


def values_at(step):
    return {
        "pressure": np.sin(points[:, 0] + 0.1 * step).astype(np.float32),
        "constant": np.ones(len(points), np.float64),
    }


def grid_at(step, time=None):
    grid = make_grid(points, tets, values_at(step))
    if time is not None:
        array = numpy_to_vtk(np.array([time]), deep=True)
        array.SetName("TimeValue")
        grid.GetFieldData().AddArray(array)
    return grid


files = [f"run{step:02}.vtu" for step in range(STEPS)]
for step, name in enumerate(files):
    write(grid_at(step), name)
    write(grid_at(step, 0.5 + 0.25 * step), "timed" + name)

# Without times in the files they are numbered.
gtn("pack", "--key-step-interval", 4, *files, "run.gtn", says="11 time steps")
gtn("verify", "run.gtn", *files, says="identical")
assert json.loads(gtn("info", "--json", "run.gtn"))["times"] == list(range(STEPS))
gtn("verify", "run.gtn", *files[1:], code=1, says="11 time steps, not 10")
write(grid_at(2), "other01.vtu")
gtn("verify", "run.gtn", files[0], "other01.vtu", *files[2:], code=1, says="differs at step 1")

# With times in the files, they are those.
gtn("pack", "-q", *("timed" + name for name in files), "timed.gtn")
times = json.loads(gtn("info", "--json", "timed.gtn"))["times"]
assert times == [0.5 + 0.25 * step for step in range(STEPS)]

# One mesh for all steps.
assert os.path.getsize("run.gtn") < STEPS * os.path.getsize(files[0]) / 5

# Each step comes back.
gtn("pack", "-q", "--keep-order", "all", *files, "kept.gtn")
for step in (0, 7, STEPS - 1):
    gtn("unpack", "-q", "-f", "--step", step, "kept.gtn", "step.vtu")
    back = vtk_to_numpy(read("step.vtu").GetPointData().GetArray("pressure"))
    assert np.array_equal(back, values_at(step)["pressure"])
gtn("unpack", "-q", "-f", "--time", 7, "kept.gtn", "time.vtu")
back = vtk_to_numpy(read("time.vtu").GetPointData().GetArray("pressure"))
assert np.array_equal(back, values_at(7)["pressure"])
gtn("unpack", "-f", "--time", 7.5, "kept.gtn", "time.vtu", code=1, says="no step at time 7.5")
gtn("unpack", "-f", "--step", STEPS, "kept.gtn", "time.vtu", code=1, says="no step 11")

# A list of files, by time, with one step in two parts.
os.makedirs("parts", exist_ok=True)
half = len(tets) // 2
data = waves(points)
write(make_grid(points, tets[:half], data), "parts/a.vtu")
write(make_grid(points, tets[half:], data), "parts/b.vtu")
with open("run.pvd", "w") as file:
    file.write('<VTKFile type="Collection" version="0.1"><Collection>\n')
    for step in reversed(range(STEPS)):
        file.write(f'<DataSet timestep="{10 + step}" group="" part="0" file="{files[step]}"/>\n')
    file.write("</Collection></VTKFile>\n")
with open("parts.pvd", "w") as file:
    file.write('<VTKFile type="Collection" version="0.1"><Collection>\n')
    for part in "ab":
        file.write(f'<DataSet timestep="1" part="0" file="parts/{part}.vtu"/>\n')
    file.write("</Collection></VTKFile>\n")
gtn("pack", "-q", "run.pvd", "list.gtn")
gtn("verify", "list.gtn", "run.pvd", says="identical")
assert json.loads(gtn("info", "--json", "list.gtn"))["times"] == [10 + s for s in range(STEPS)]
gtn("pack", "parts.pvd", "parts.gtn", says="2 blocks were merged")
gtn("verify", "parts.gtn", "parts.pvd", says="identical")
assert json.loads(gtn("info", "--json", "parts.gtn"))["tets"] == len(tets)

# A mesh that changes, and returns.
write(make_grid(points + 1, tets[:half][::-1], values_at(3)), "other.vtu")
changing = [files[0], "other.vtu", files[1], files[2]]
gtn("pack", "--keep-order", "all", *changing, "changing.gtn", says="2 meshes, 4 time steps")
gtn("verify", "changing.gtn", says="2 meshes, 4 time steps")
gtn("verify", "changing.gtn", *changing, says="identical")
gtn("verify", "changing.gtn", *changing[1:], files[3], code=1, says="differs at step 0")
info = json.loads(gtn("info", "--json", "changing.gtn"))
assert info["times"] == [0, 1, 2, 3]
assert [(m["cells"], m["steps"], m["firstTime"]) for m in info["meshes"]] == [
    (len(tets), 3, 0), (half, 1, 1)]
for index, name in enumerate(changing):
    gtn("unpack", "-q", "-f", "--step", index, "changing.gtn", "step.vtu")
    assert read("step.vtu").GetNumberOfCells() == read(name).GetNumberOfCells()
gtn("contour", "-q", "--step", 1, "--number", 3, "changing.gtn", "surface.vtp")
gtn("render", "-q", "-f", "--step", 1, "--size", "32x32", "changing.gtn", "step.png")

# What cannot be one file.
write(make_grid(points, tets, waves(points)), "arrays.vtu")
gtn("pack", files[0], "arrays.vtu", "new.gtn", code=1, says="time step 1")
gtn("pack", files[0], "run.gtn", "new.gtn", code=1, says="run.gtn: has several time steps itself")
gtn("pack", files[0], "missing.vtu", "new.gtn", code=1, says="missing.vtu: no such file")
with open("recursive.pvd", "w") as file:
    file.write('<VTKFile type="Collection"><Collection><DataSet timestep="0" ')
    file.write('file="recursive.pvd"/></Collection></VTKFile>')
gtn("pack", "recursive.pvd", "new.gtn", code=1, says="cannot be part of another")
assert not os.path.exists("new.gtn")
