# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""What was packed comes back bit for bit, with the order kept or not."""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from gatunCli import (
    add_text,
    corners_of,
    enter_folder,
    gtn,
    lattice,
    make_grid,
    permute,
    read,
    standard_mesh,
    waves,
    write,
)

enter_folder("roundtrip")


def same_bits(a, b):
    return a.dtype == b.dtype and a.shape == b.shape and a.tobytes() == b.tobytes()


def check(grid, name):
    """Packs in each way; verify agrees, and so does numpy where all order is kept."""
    write(grid, name + ".vtu")
    for order in ("none", "points", "cells", "all"):
        packed = f"{name}-{order}.gtn"
        gtn("pack", "-q", "--keep-order", order, name + ".vtu", packed)
        gtn("verify", packed, says="intact: all checksums are right, and everything decodes (")
        gtn("verify", packed, name + ".vtu", says="identical")
    gtn("unpack", f"{name}-all.gtn", name + "-back.vtu")
    back = read(name + "-back.vtu")
    assert back.GetNumberOfCells() == grid.GetNumberOfCells()
    if grid.GetNumberOfCells():
        assert np.array_equal(corners_of(back), corners_of(grid))
    if grid.GetNumberOfPoints():
        assert same_bits(
            vtk_to_numpy(back.GetPoints().GetData()), vtk_to_numpy(grid.GetPoints().GetData())
        )
    for data, original in (
        (back.GetPointData(), grid.GetPointData()),
        (back.GetCellData(), grid.GetCellData()),
    ):
        assert data.GetNumberOfArrays() == original.GetNumberOfArrays()
        for i in range(data.GetNumberOfArrays()):
            assert data.GetArrayName(i) == original.GetArrayName(i)
            assert same_bits(vtk_to_numpy(data.GetArray(i)), vtk_to_numpy(original.GetArray(i)))


check(standard_mesh(7), "standard")

# All types, and values that are hard to keep.
points, tets = lattice(4, dtype=np.float64)
random = np.random.default_rng(5)
point_data = {
    np.dtype(kind).name: random.integers(0, 256, (len(points), 1 + i % 4) + (np.dtype(kind).itemsize,))
    .astype(np.uint8)
    .view(kind)[..., 0]
    for i, kind in enumerate("bBhHiIqQfd")
}
cell_data = {"c" + name: values[: len(tets) % len(points)] for name, values in point_data.items()}
cell_data = {
    name: np.resize(values, (len(tets),) + values.shape[1:]) for name, values in cell_data.items()
}
check(make_grid(points, tets, point_data, cell_data), "types")

# Duplicate, unused and infinite points; flat, turned and repeated cells; text with odd bytes.
points, tets = lattice(3)
points[5] = points[6]
points[7] = [np.nan, np.inf, -np.inf]
points[8] = [-0.0, 0.0, 1e-45]
points = np.concatenate([points, points[:9], [[1e30, 0, 0]]]).astype(np.float32)
tets[3] = tets[3][[1, 0, 2, 3]]
tets[4] = tets[9]
tets[10, 3] = tets[10, 2]
grid = make_grid(points, tets, waves(points))
add_text(grid, "odd", ["tab\there", "new\nline", "caf\u00e9"])
check(grid, "odd")

# Nothing at all, points only, one cell.
check(make_grid(np.zeros((0, 3), np.float32), np.zeros((0, 4), int)), "empty")
check(make_grid(points[:3], np.zeros((0, 4), int)), "points")
check(make_grid(np.eye(4, 3, dtype=np.float32), [[0, 1, 2, 3]]), "single")

# Another order of everything is the same mesh, unless order counts.
points, tets = lattice(6)
data = waves(points)
grid = make_grid(points, tets, data, {"n": np.arange(len(tets), dtype=np.float32)})
write(grid, "ordered.vtu")
gtn("pack", "-q", "ordered.vtu", "any.gtn")
gtn("pack", "-q", "--keep-order", "all", "ordered.vtu", "kept.gtn")
mixed_points, mixed_tets, old_point, old_cell = permute(points, tets, 3)
mixed = make_grid(
    mixed_points,
    mixed_tets,
    {name: values[old_point] for name, values in data.items()},
    {"n": old_cell.astype(np.float32)},
)
write(mixed, "mixed.vtu")
gtn("verify", "any.gtn", "mixed.vtu", says="identical")
gtn("verify", "kept.gtn", "mixed.vtu", code=1, says="differs: the coordinates of point 0: ")

# What was checked is said.
gtn("verify", "kept.gtn", says="(1 chunk, 4 arrays, the order of points, cells, corners)")

# Threads and chunks make no difference.
for chunk in (64, 300):
    for threads in (1, 3):
        name = f"c{chunk}-t{threads}.gtn"
        gtn("pack", "-q", "--chunk-size", chunk, "--threads", threads, "standard.vtu", name)
        gtn("verify", "--threads", threads, name, "standard.vtu", says="identical")
    with open(f"c{chunk}-t1.gtn", "rb") as one, open(f"c{chunk}-t3.gtn", "rb") as three:
        assert one.read() == three.read(), "the bytes depend on the number of threads"

# Only some arrays.
gtn("pack", "-q", "--arrays", "pressure,material", "standard.vtu", "some.gtn")
gtn("verify", "some.gtn", "standard.vtu", code=1, says="is in standard.vtu only")
gtn("verify", "--arrays", "pressure,material", "some.gtn", "standard.vtu", says="identical")
