# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Sets and field data of a mesh of meshio come back from a .gtn file."""

import os
import warnings

import gatun
import meshio
import numpy as np
from gatunCube import make_cube, require_equal, require_raises

folder = os.path.join(os.environ["GATUN_TEST_TEMP"], os.environ["GATUN_TEST_NAME"])
os.makedirs(folder, exist_ok=True)
path = os.path.join(folder, "sets.gtn")

points, tets = make_cube(4)
cells = [("triangle", [[0, 1, 4], [1, 2, 5]]), ("tetra", tets[:30]), ("tetra", tets[30:])]


def make(**options):
    members = {
        "point_data": {"x": points[:, 0]},
        "cell_data": {"n": [np.arange(2), np.arange(30), np.arange(len(tets) - 30)]},
        "point_sets": {"inlet": np.array([3, 0, 60]), "none": np.array([], int), "w\u00e4nde, 2": np.arange(64)},
        "cell_sets": {"wall": [np.array([1]), np.array([], int), np.array([0, 7])]},
        "field_data": {"fluid": np.array([7, 3]), "wall": np.array([2, 2])},
    }
    return meshio.Mesh(points, cells, **{**members, **options})


gatun.write(make(), path, keep_order="all", overwrite=True)
back = gatun.to_meshio(gatun.read(path))
assert set(back.point_data) == {"x"} and set(back.cell_data) == {"n"}
assert {name: sorted(ids.tolist()) for name, ids in back.point_sets.items()} == {
    "inlet": [0, 3, 60],
    "none": [],
    "w\u00e4nde, 2": list(range(64)),
}
# The blocks of one type are one.
assert [part.tolist() for part in back.cell_sets["wall"]] == [[1], [30, 37]]
assert set(back.field_data) == {"fluid", "wall"}
require_equal(back.field_data["fluid"], [7, 3])

# Without an order, a set has the same points, where they are.
gatun.write(make(), path, overwrite=True)
back = gatun.to_meshio(gatun.read(path))
found = {tuple(p) for p in back.points[back.point_sets["inlet"]]}
assert found == {tuple(p) for p in points[[0, 3, 60]]}

# In VTK, a set is an array. gatun.Mesh keeps it as it is.
grid = gatun.from_meshio(make())
assert grid.GetPointData().GetArray("inlet").GetValue(3) == 1
again = gatun.from_meshio(gatun.to_numpy(grid))
assert set(gatun.to_meshio(again).point_sets) == {"inlet", "none", "w\u00e4nde, 2"}

# Numbers that are not those of cells are left out, with a warning.
with warnings.catch_warnings(record=True) as caught:
    warnings.simplefilter("always")
    other = make(cell_sets={"gmsh:bounding_entities": [np.array([-7, 900])] * 3, "wall": [[1], None, []]})
    other.gmsh_periodic = [[1, 2]]
    grid = gatun.from_meshio(other)
assert [str(w.message).split(" is left out")[0] for w in caught] == [
    "cell set 'gmsh:bounding_entities'",
    "gmsh_periodic",
], caught
assert list(gatun.to_meshio(grid).cell_sets) == ["wall"]

require_raises(ValueError, "'x' is the name of an array", gatun.from_meshio, make(point_sets={"x": [1]}))
require_raises(ValueError, "point set 'p': has to be numbers", gatun.from_meshio, make(point_sets={"p": [64]}))
require_raises(ValueError, "point set 'p': has to be numbers", gatun.from_meshio, make(point_sets={"p": [-1]}))
wrong = make()
wrong.cell_sets = {"c": [[0]]}
require_raises(ValueError, "cell set 'c': has 1 blocks", gatun.from_meshio, wrong)
