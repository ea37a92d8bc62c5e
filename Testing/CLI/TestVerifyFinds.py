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
expect("renamed", rename, "differs: point array 'pressure' is in ", "point array 'p' is in renamed.vtu only")
expect("component", rename_component, "point array 'velocity' is double, 3 component(s) in ", " (east, , ) in component.vtu")
expect("removed", remove_array, "cell array 'quality' is in ")
expect("role", change_role, "point array 'pressure' is float, 1 component(s) in ", ", active Scalars in role.vtu")
expect("text", change_text, "field array 'remarks': string 1 is \"\" in ", '"more" in text.vtu')

# Points that coincide in everything are indistinguishable, and their number is reported: doubled
# points that are connected in one way or in another.
points, tets = lattice(2)
doubled = np.concatenate([points, points])
apart = np.concatenate([tets, tets + len(points)])
write(make_grid(doubled, apart), "apart.vtu")
gtn("pack", "-q", "apart.vtu", "apart.gtn")
alike = f", up to {len(doubled)} indistinguishable points\n"
gtn("verify", "apart.gtn", "apart.vtu", says="identical to apart.vtu" + alike)
crossed = apart.copy()
crossed[0, 0] += len(points)
crossed[len(tets), 0] -= len(points)
write(make_grid(doubled, crossed), "crossed.vtu")
gtn("verify", "apart.gtn", "crossed.vtu", says="identical to crossed.vtu" + alike)
mixed_points, mixed_tets, _, _ = permute(doubled, crossed, 8)
write(make_grid(mixed_points, mixed_tets), "mixed.vtu")
gtn("verify", "apart.gtn", "mixed.vtu", says=alike)

# By their place they can be distinguished.
gtn("pack", "-q", "--keep-order", "points", "apart.vtu", "ordered.gtn")
gtn("verify", "ordered.gtn", "apart.vtu", says="identical to apart.vtu\n")
gtn("verify", "ordered.gtn", "crossed.vtu", code=1, says="cell 0 of crossed.vtu, with corners ")

# By values, too. What is said of them is not said of others.
numbered = np.arange(len(doubled), dtype=np.float32)
write(make_grid(doubled, apart, {"number": numbered}), "numbered.vtu")
gtn("pack", "-q", "numbered.vtu", "numbered.gtn")
gtn("verify", "numbered.gtn", "numbered.vtu", says="identical to numbered.vtu\n")
write(make_grid(doubled, crossed, {"number": numbered}), "numbered-crossed.vtu")
gtn("verify", "numbered.gtn", "numbered-crossed.vtu", code=1, says="cell 0 of numbered-crossed.vtu")

# Indistinguishable points hide no other difference: a missing copy, a cell elsewhere or inside out.
for name, change_points, change_tets in (
        ("copy", lambda p: p.__setitem__(0, p[1]), None),
        ("elsewhere", None, lambda t: t.__setitem__((0, 0), t[5, 0])),
        ("inside-out", None, lambda t: t.__setitem__(0, t[0][[1, 0, 2, 3]]))):
    other_points, other_tets = doubled.copy(), apart.copy()
    if change_points:
        change_points(other_points)
    if change_tets:
        change_tets(other_tets)
    write(make_grid(other_points, other_tets), name + ".vtu")
    gtn("verify", "apart.gtn", name + ".vtu", code=1, says=f" of {name}.vtu, ")

# Many copies of one point: place by place they can always be compared.
one = np.zeros((40, 3), np.float32)
write(make_grid(one, np.arange(40).reshape(10, 4)), "heap.vtu")
gtn("pack", "-q", "--keep-order", "all", "heap.vtu", "heap.gtn")
gtn("verify", "heap.gtn", "heap.vtu", says="identical")

# Values of two steps that are all there, but belong to other points.
first, second = points[:, 0].copy(), points[:, 1].copy()
same_place = np.zeros_like(points)
for name, values in (("s0", first), ("s1", second), ("s2", second[::-1].copy())):
    write(make_grid(same_place, tets, {"v": values}), name + ".vtu")
gtn("pack", "-q", "s0.vtu", "s1.vtu", "s.gtn")
gtn("verify", "s.gtn", "s0.vtu", "s1.vtu", says="identical to s0.vtu and 1 more, 2 time steps")
gtn("verify", "s.gtn", "s0.vtu", "s2.vtu", code=1, says="differs at step 1 (time 1): point array 'v' ")

# Values that are all there, but belong to others of equal coordinates, at another time.
gtn("pack", "-q", "mesh.vtu", "mesh.vtu", "twice.gtn")
gtn("verify", "twice.gtn", "mesh.vtu", code=1, says="2 time steps, not 1")
gtn("verify", "twice.gtn", "mesh.vtu", "mesh.vtu", says="identical to mesh.vtu and 1 more")
gtn("verify", "twice.gtn", "mesh.vtu", "pressure.vtu", code=1, says="differs at step 1 (time 1): ")
