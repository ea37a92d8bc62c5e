# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Series in which cells die, and in which meshes return, by gtn: pack, info, verify, unpack, contour,
simplify and render."""

import json
import os

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

from gatunCli import enter_folder, gtn, lattice, make_grid, read, write

enter_folder("dying")
points, tets = lattice(8)
centers = points[tets].mean(axis=1)[:, 0] / points[:, 0].max()
FRONTS = [0, 0.1, 0.3, 0.3, 0.45, 0]


def grid_at(step, drops=True):
    alive = tets[centers >= FRONTS[step]]
    kept = np.unique(alive) if drops else np.arange(len(points))
    number = np.zeros(len(points), int)
    number[kept] = np.arange(len(kept))
    field = np.sin(3 * points[kept, 2] + 0.1 * step).astype(np.float32)
    return make_grid(points[kept], number[alive], {"field": field},
                     {"cell": np.flatnonzero(centers >= FRONTS[step])})


def count_triangles(name):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(name)
    reader.Update()
    return reader.GetOutput().GetNumberOfCells()


files = [f"step{step}.vtu" for step in range(len(FRONTS))]
for step, name in enumerate(files):
    write(grid_at(step), name)
gtn("pack", "--keep-order", "all", *files, "run.gtn", says="6 time steps")
gtn("verify", "run.gtn", *files, says="identical")
gtn("verify", "run.gtn", says="time steps")
info = json.loads(gtn("info", "--json", "run.gtn"))
assert [mesh["cells"] for mesh in info["meshes"]] == [
    int((centers >= front).sum()) for front in (0, 0.1, 0.3, 0.45)]
assert [mesh["someCellsOf"] for mesh in info["meshes"]] == [None, 1, 1, 1]
assert [mesh["steps"] for mesh in info["meshes"]] == [2, 1, 2, 1]
assert "some cells of" in gtn("info", "run.gtn")
sizes = {part: row["bytes"] for part, row in info["sizes"].items()}
assert sum(bytes for part, bytes in sizes.items() if part != "file") == sizes["file"]
for step in (4, 0, 2, 5):
    gtn("unpack", "-q", "-f", "--step", step, "run.gtn", "back.vtu")
    back = read("back.vtu")
    assert back.GetNumberOfCells() == grid_at(step).GetNumberOfCells()
    assert back.GetNumberOfPoints() == grid_at(step).GetNumberOfPoints()

# It is smaller than a mesh for each step, and about as large as without deaths.
other = list(files)
rng = np.random.default_rng(1)
for step in (1, 2, 4):
    grid = grid_at(step)
    order = rng.permutation(grid.GetNumberOfCells())
    ids = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4)[order]
    other[step] = f"other{step}.vtu"
    coordinates = vtk_to_numpy(grid.GetPoints().GetData())
    field = vtk_to_numpy(grid.GetPointData().GetArray("field"))
    cell = vtk_to_numpy(grid.GetCellData().GetArray("cell"))[order]
    write(make_grid(coordinates, ids, {"field": field}, {"cell": cell}), other[step])
gtn("pack", "-q", *other, "other.gtn")
gtn("pack", "-q", *files, "small.gtn")
assert len(json.loads(gtn("info", "--json", "other.gtn"))["meshes"]) >= 4
assert os.path.getsize("small.gtn") < 0.7 * os.path.getsize("other.gtn")

# Everything else takes the remaining cells.
gtn("contour", "-q", "--step", 4, "--value", 0.3, "run.gtn", "file.vtp")
gtn("contour", "-q", "--value", 0.3, "step4.vtu", "grid.vtp")
assert count_triangles("file.vtp") == count_triangles("grid.vtp") > 0
gtn("simplify", "-q", "--step", 4, "--ratio", 0.5, "run.gtn", "simple.vtu")
assert 0 < read("simple.vtu").GetNumberOfCells() < grid_at(4).GetNumberOfCells()
gtn("render", "-q", "--step", 4, "--size", "80x60", "run.gtn", "file.png")
assert os.path.getsize("file.png") > 200
gtn("pack", "-q", "run.gtn", "again.gtn")
gtn("verify", "again.gtn", "run.gtn", says="identical")

# With a hierarchy each step has a mesh of its own, and returning meshes are stored once.
order = [0, 4, 1, 4, 1, 4, 1, 4, 1]
names = []
for time, step in enumerate(order):
    names.append(f"time{time}.vtu")
    grid = grid_at(step)
    write(grid, names[-1])
once = names[:3]
options = ["-q", "--hierarchy", "--boundary"]
gtn("pack", *options, *once, "once.gtn")
gtn("pack", *options, *names, "returns.gtn")
gtn("verify", "returns.gtn", *names, says="identical")
gtn("verify", "returns.gtn")
info = json.loads(gtn("info", "--json", "returns.gtn"))
assert len(info["meshes"]) == len(order)
# Six meshes more, nearly for nothing: their values have not changed either.
assert os.path.getsize("returns.gtn") < 1.35 * os.path.getsize("once.gtn")
