# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""verify finds every kind of difference, and says what differs and where."""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid

from gatunCli import (
    corners_of,
    enter_folder,
    gtn,
    lattice,
    make_grid,
    permute,
    standard_mesh,
    write,
)

enter_folder("verify")
original = standard_mesh(5)
write(original, "mesh.vtu")
for order in ("none", "points", "cells", "all"):
    gtn("pack", "-q", "--keep-order", order, "mesh.vtu", order + ".gtn")


def expect(name, change, *says, orders=("none", "points", "cells", "all")):
    """Compares with a copy of the mesh to which something was done."""
    grid = vtkUnstructuredGrid()
    grid.DeepCopy(original)
    change(grid)
    write(grid, name + ".vtu")
    for order in orders:
        output = gtn("verify", order + ".gtn", name + ".vtu", code=1, says=says[0])
        assert output == ""
        for words in says[1:]:
            gtn("verify", order + ".gtn", name + ".vtu", code=1, says=words)


def values(grid, name):
    data = grid.GetPointData() if grid.GetPointData().HasArray(name) else grid.GetCellData()
    return vtk_to_numpy(data.GetArray(name))


def next_up(array, index):
    array[index] = np.nextafter(array[index], array.dtype.type(np.inf))


def move_point(grid):
    points = vtk_to_numpy(grid.GetPoints().GetData())
    next_up(points, (17, 2))


def change_pressure(grid):
    next_up(values(grid, "pressure"), 33)


def negate_zero(grid):
    values(grid, "quality")[0] = -0.0


def not_a_number(grid):
    values(grid, "velocity")[4, 1] = np.nan


def turn_inside_out(grid):
    corners = corners_of(grid)
    corners[12] = corners[12][[1, 0, 2, 3]]


def repeat_cell(grid):
    corners = corners_of(grid)
    corners[12] = corners[40]


def change_material(grid):
    values(grid, "material")[77] += 1


def exchange_pressure(grid):
    array = values(grid, "pressure")
    array[[10, 50]] = array[[50, 10]]


def rename(grid):
    grid.GetPointData().GetArray("pressure").SetName("p")


def rename_component(grid):
    grid.GetPointData().GetArray("velocity").SetComponentName(0, "east")


def remove_array(grid):
    grid.GetCellData().RemoveArray("quality")


def change_role(grid):
    grid.GetPointData().SetActiveScalars("pressure")


def change_text(grid):
    grid.GetFieldData().GetAbstractArray("remarks").SetValue(1, "more")


expect("moved", move_point, "the coordinates of point 17: ", orders=("points", "all"))
expect("moved", move_point, "point 17 of moved.vtu, at (", orders=("none", "cells"))
expect("pressure", change_pressure, "point array 'pressure' ", "point 33", "in pressure.vtu")
expect("zero", negate_zero, "cell array 'quality' of cell 0", "-0")
expect("nan", not_a_number, "point array 'velocity' ", "point 4", "nan(0x")
expect("turned", turn_inside_out, "cell 12", orders=("none", "points", "all"))
expect("repeated", repeat_cell, "cell", orders=("none", "points", "all"))
expect("turned", turn_inside_out, "differs: ", orders=("cells",))
expect("material", change_material, "cell array 'material' of cell 77", "in material.vtu")
expect("exchanged", exchange_pressure, "point array 'pressure' ")
expect("renamed", rename, "array number 0 is point array 'pressure'")
expect("component", rename_component, "point array 'velocity': component names are ")
expect("removed", remove_array, "cell array 'quality' is in ")
expect("role", change_role, "point array 'pressure': roles ")
expect("text", change_text, "field array 'remarks': text 1 is \"\" in ", '"more" in text.vtu')

# Points that coincide in everything are told apart by their neighbours: two pairs of tetrahedra
# with doubled points, glued in one way or in the other.
points, tets = lattice(2)
doubled = np.concatenate([points, points])
apart = np.concatenate([tets, tets + len(points)])
write(make_grid(doubled, apart), "apart.vtu")
gtn("pack", "-q", "apart.vtu", "apart.gtn")
gtn("verify", "-v", "apart.gtn", "apart.vtu", says="coincide")
crossed = apart.copy()
crossed[0, 0] += len(points)
crossed[len(tets), 0] -= len(points)
write(make_grid(doubled, crossed), "crossed.vtu")
gtn("verify", "apart.gtn", "crossed.vtu", code=1, says="do not belong together in the same way")

# And the glued one is itself, in any order.
gtn("pack", "-q", "crossed.vtu", "crossed.gtn")
gtn("verify", "crossed.gtn", "crossed.vtu", says="identical")
gtn("verify", "crossed.gtn", "apart.vtu", code=1, says="do not belong together in the same way")
mixed_points, mixed_tets, _, _ = permute(doubled, crossed, 8)
write(make_grid(mixed_points, mixed_tets), "mixed.vtu")
gtn("verify", "crossed.gtn", "mixed.vtu", says="identical")
gtn("verify", "apart.gtn", "mixed.vtu", code=1, says="do not belong together in the same way")

# Many copies of one point: place by place they can always be compared.
one = np.zeros((40, 3), np.float32)
write(make_grid(one, np.arange(40).reshape(10, 4)), "heap.vtu")
gtn("pack", "-q", "--keep-order", "all", "heap.vtu", "heap.gtn")
gtn("verify", "heap.gtn", "heap.vtu", says="identical")

# Values that are all there, but belong to others of equal coordinates, at another time.
gtn("pack", "-q", "mesh.vtu", "mesh.vtu", "twice.gtn")
gtn("verify", "twice.gtn", "mesh.vtu", code=1, says="2 time steps, not 1")
gtn("verify", "twice.gtn", "mesh.vtu", "mesh.vtu", says="identical to mesh.vtu and 1 more")
gtn("verify", "twice.gtn", "mesh.vtu", "pressure.vtu", code=1, says="differs at step 1 (time 1): ")
