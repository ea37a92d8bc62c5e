# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""pack takes errors of arrays, info tells them, and verify proves them."""

import json
import os
import re

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPointData, vtkUnstructuredGrid

from gatunCli import enter_folder, gtn, read, standard_mesh, write

enter_folder("array-errors")
write(standard_mesh(8), "mesh.vtu")
gtn("pack", "-q", "mesh.vtu", "exact.gtn")
gtn("pack", "-q", "--tolerance", "velocity=rel:1e-2", "--tolerance", "*=abs:1e-3", "mesh.vtu", "mesh.gtn")
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
gtn("pack", "-q", "--keep-order", "all", "--tolerance", "velocity=rel:1e-2", "mesh.vtu", "ordered.gtn")
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
gtn("pack", "-q", "--keep-order", "all", "--tolerance", "velocity=rel:1e-6", "back.vtu", "finer.gtn")
gtn("verify", "finer.gtn", "mesh.vtu", code=1, says="velocity")


# What verify finds in arrays with errors: other arrays, types, values and ranges, and steps that are missing.
def velocity_of(grid):
    return grid.GetPointData().GetArray("velocity")


def replace(grid, values):
    """Puts values in the place of the velocity."""
    data = grid.GetPointData()
    arrays = [data.GetArray(i) for i in range(data.GetNumberOfArrays())]
    array = numpy_to_vtk(values, deep=True)
    array.SetName("velocity")
    others = vtkPointData()
    for old in arrays:
        others.AddArray(array if old.GetName() == "velocity" else old)
    data.ShallowCopy(others)


def move_to_cells(grid):
    array = numpy_to_vtk(np.zeros((grid.GetNumberOfCells(), 3)), deep=True)
    array.SetName("velocity")
    grid.GetPointData().RemoveArray("velocity")
    grid.GetCellData().AddArray(array)


def narrow(grid):
    """Cuts off the ends of the range by less than the bound."""
    values = vtk_to_numpy(velocity_of(grid))
    for c in range(3):
        low, high = values[:, c].min(), values[:, c].max()
        step = 1e-3 * (high - low)
        values[:, c] = np.clip(values[:, c], low + step, high - step)


def copy_of_mesh():
    grid = vtkUnstructuredGrid()
    grid.DeepCopy(standard_mesh(8))
    return grid


for name, change, says in (
        ("removed", lambda grid: grid.GetPointData().RemoveArray("velocity"),
         "point array 'velocity' is in {} only"),
        ("renamed", lambda grid: velocity_of(grid).SetName("v"), "point array 'v' is in renamed.vtu only"),
        ("other-type", lambda grid: replace(grid, vtk_to_numpy(velocity_of(grid)).astype(np.float32)),
         "point array 'velocity' is double, 3 component(s) in {}, float, 3 component(s)"),
        ("two", lambda grid: replace(grid, vtk_to_numpy(velocity_of(grid))[:, :2].copy()),
         "point array 'velocity' is double, 3 component(s) in {}, double, 2 component(s)"),
        ("on-cells", move_to_cells, "point array 'velocity' is in {} only"),
        ("nan", lambda grid: vtk_to_numpy(velocity_of(grid)).__setitem__((4, 1), np.nan),
         "point array 'velocity' is not within its bound (rel:0.01)"),
        ("narrow", narrow, "point array 'velocity' is ")):
    grid = copy_of_mesh()
    change(grid)
    write(grid, name + ".vtu")
    for packed in "mesh.gtn", "ordered.gtn":
        gtn("verify", packed, name + ".vtu", code=1, says="differs: ")
        gtn("verify", packed, name + ".vtu", code=1, says=says.format(packed))

# A range that is smaller by less than the bound is smaller all the same, if no value tells.
tight = copy_of_mesh()
values = np.linspace(0, 1, tight.GetNumberOfPoints())
replace(tight, np.stack([values, values, values], axis=1))
write(tight, "wide.vtu")
gtn("pack", "-q", "--keep-order", "all", "--tolerance", "velocity=rel:0.25", "wide.vtu", "wide.gtn")
gtn("verify", "wide.gtn", "wide.vtu", says="but for bounded errors")
replace(tight, np.stack([np.minimum(values, 0.999)] * 3, axis=1))
write(tight, "tight.vtu")
gtn("verify", "wide.gtn", "tight.vtu", code=1,
    says="point array 'velocity' is rounded by more than its bound (rel:0.25) allows for the range of component 0")

gtn("pack", "-q", "--tolerance", "velocity=rel:1e-2", "mesh.vtu", "mesh.vtu", "twice.gtn")
gtn("verify", "twice.gtn", "mesh.vtu", code=1, says="2 time steps, not 1")
gtn("verify", "twice.gtn", "mesh.vtu", "mesh.vtu", says="2 time steps but for bounded errors")
gtn("verify", "twice.gtn", "mesh.vtu", "nan.vtu", code=1, says="differs at step 1 (time 1): point array 'velocity'")
gtn("verify", "mesh.gtn", "mesh.vtu", "mesh.vtu", code=1, says="1 time steps, not 2")
gtn("verify", "--arrays", "pressure", "mesh.gtn", "nan.vtu", says="identical")

# Usage.
for error in "velocity", "velocity=abs:0", "velocity=abs:nan", "velocity=up:1", "velocity=bits:99", \
        "velocity=abs:1,one", "velocity=abs:", "velocity=abs:1e999":
    gtn("pack", "--tolerance", error, "mesh.vtu", "no.gtn", code=2, says="--tolerance")
gtn("pack", "--tolerance", "nobody=abs:1", "mesh.vtu", "no.gtn", code=1, says="nobody")
assert not os.path.exists("no.gtn")
