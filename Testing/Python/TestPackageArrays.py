# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Meshes and volumes from NumPy arrays and back, with VTK's own access as the reference."""

import gc
import sys

import gatun
import numpy as np
from gatunCube import make_cube, require_equal, require_raises

points, tets = make_cube(4)
rng = np.random.default_rng(1)

# All types of numbers, in memory of their own once the arrays of the caller are gone.
for kind in "int8 uint8 int16 uint16 int32 uint32 int64 uint64 float32 float64".split():
    for shape in (len(points),), (len(points), 3), (len(points), 3, 3):
        values = rng.integers(0, 100, shape).astype(kind)
        mesh = gatun.from_numpy(points, tets, point_data={"a": values.copy()})
        gc.collect()
        array = mesh.GetPointData().GetArray("a")
        assert array.GetNumberOfComponents() == np.prod(shape[1:])
        assert array.GetTuple(5) == tuple(map(float, values[5].ravel()))
        back = gatun.to_numpy(mesh).point_data["a"]
        require_equal(back, values.reshape(back.shape))
booleans = np.arange(len(tets)) % 3 == 0
mesh = gatun.from_numpy(points, tets, cell_data={"b": booleans, "c": np.arange(len(tets))[::-1]})
assert [mesh.GetCellData().GetArray("b").GetValue(i) for i in range(4)] == [1, 0, 0, 1]
assert mesh.GetCellData().GetArray("c").GetValue(1) == len(tets) - 2
big = np.arange(len(points), dtype=">f8")
assert gatun.to_numpy(gatun.from_numpy(points, tets, point_data={"d": big})).point_data["d"][3] == 3

# The corners of every cell, in 32 and 64 bits.
for ids in (tets.astype(np.int32), tets.astype(np.int64), tets.astype(np.uint16)):
    mesh = gatun.from_numpy(points, ids)
    assert (mesh.GetCells().GetConnectivityArray().GetDataTypeSize() == 8) == (ids.dtype == np.int64)
    for cell in (0, 17, len(tets) - 1):
        corners = mesh.GetCell(cell).GetPointIds()
        assert [corners.GetId(i) for i in range(4)] == list(tets[cell])
assert mesh.GetBounds() == (0, 1, 0, 1, 0, 1)

# Blocks of several types. cell_data goes along, as one array or block by block.
cells = [("hexahedron", [[0, 1, 5, 4, 16, 17, 21, 20]]), ("tetra", tets[:3]), (13, [[0, 1, 2, 3, 4, 5]])]
mesh = gatun.from_numpy(
    points,
    cells,
    cell_data={"all": np.arange(5), "parts": [[7], [8, 9, 10], [11]]},
    field_data={"when": [1.5, 2.5]},
)
assert [mesh.GetCellType(i) for i in range(5)] == [12, 10, 10, 10, 13]
assert [mesh.GetCellData().GetArray("parts").GetValue(i) for i in range(5)] == [7, 8, 9, 10, 11]
back = gatun.to_numpy(mesh)
assert [name for name, _ in back.cells] == ["hexahedron", "tetra", "wedge"]
require_equal(back.cells_dict["tetra"], tets[:3])
assert [list(part) for part in back.cell_data["all"]] == [[0], [1, 2, 3], [4]]
assert list(back.field_data["when"]) == [1.5, 2.5]
assert gatun.from_meshio(back).GetCellData().GetArray("all").GetValue(3) == 3

# Types that alternate are collected, and their values with them.
mesh.Initialize()
mesh = gatun.from_numpy(points, [("tetra", tets[:1]), ("triangle", [[0, 1, 2]]), ("tetra", tets[1:2])])
numbers = gatun.from_numpy(points[:3], {}, point_data={"n": [5, 6, 7]}).GetPointData().GetArray(0)
mesh.GetCellData().AddArray(numbers)
back = gatun.to_numpy(mesh)
require_equal(back.cells[0][1], tets[:2])
assert [list(part) for part in back.cell_data["n"]] == [[5, 7], [6]]

# Surfaces, and polygons of several sizes.
surface = gatun.from_numpy(
    points[:, :2],
    [("line", [[0, 1]]), ("triangle", [[0, 1, 2], [1, 2, 3]]), ("quad", [[0, 1, 2, 3]])],
    cell_data={"n": [4, 5, 6, 7]},
    surface=True,
)
assert surface.IsA("vtkPolyData") and surface.GetPoint(5)[2] == 0
assert surface.GetNumberOfLines() == 1 and surface.GetNumberOfPolys() == 3
back = gatun.to_numpy(surface)
assert [(name, len(ids)) for name, ids in back.cells] == [("line", 1), ("triangle", 2), ("quad", 1)]
assert [list(part) for part in back.cell_data["n"]] == [[4], [5, 6], [7]]

# A mesh without anything, and memory that outlives the mesh.
empty = gatun.to_numpy(gatun.from_numpy(np.empty((0, 3)), []))
assert empty.points.shape == (0, 3) and empty.cells == []
kept = gatun.to_numpy(gatun.from_numpy(points.copy(), tets)).points
gc.collect()
require_equal(kept, points)

# A mesh keeps the arrays that it shares, and releases them at once, also through several meshes.
values = np.arange(len(points), dtype=float)
count = sys.getrefcount(values)
chain = gatun.from_numpy(points, tets, point_data={"a": values})
assert sys.getrefcount(values) > count
for _ in range(50):
    chain = gatun.from_meshio(gatun.to_numpy(chain))
gc.collect()
require_equal(gatun.to_numpy(chain).point_data["a"], values)
assert sys.getrefcount(values) > count
del chain, mesh
gc.collect()
assert sys.getrefcount(values) == count, (sys.getrefcount(values), count)

# Volumes.
voxels = rng.integers(0, 1000, (4, 3, 2)).astype(np.int16)
image = gatun.image_from_numpy(voxels, spacing=(1, 2, 3), origin=(5, 6, 7), name="v")
assert image.GetDimensions() == (2, 3, 4) and image.GetBounds() == (5, 6, 6, 10, 7, 16)
assert image.GetScalarComponentAsDouble(1, 2, 3, 0) == voxels[3, 2, 1]
require_equal(gatun.image_to_numpy(image), voxels)
require_equal(gatun.image_to_numpy(image, "v"), voxels)

# What does not fit.
make = gatun.from_numpy
require_raises(ValueError, "points: has to be n x 3", make, np.zeros(3), tets)
require_raises(ValueError, "from 0 to 63 only", make, points, tets + 1)
require_raises(ValueError, "from 0 to 63 only", make, points, tets - 1)
require_raises(ValueError, "row per cell", make, points, tets.astype(float))
require_raises(ValueError, "'tetra' has 4 points, not 3", make, points, tets[:, :3])
require_raises(ValueError, "'tet' is not known", make, points, {"tet": tets})
require_raises(ValueError, "has 2 values for 64", make, points, tets, point_data={"a": [1, 2]})
require_raises(ValueError, "has 2 values for 162", make, points, tets, cell_data={"a": [1, 2]})
require_raises(ValueError, "complex128", make, points, tets, point_data={"a": points[:, 0] * 1j})
require_raises(ValueError, "no 'tetra'", make, points, tets, surface=True)
require_raises(
    ValueError, "vertices first", make, points, [("quad", [[0, 1, 2, 3]]), ("line", [[0, 1]])], surface=True
)
require_raises(TypeError, "no vtkUnstructuredGrid", gatun.to_numpy, image)
require_raises(ValueError, "3 dimensions", gatun.image_from_numpy, np.zeros((2, 2)))
require_raises(ValueError, "no array 'w'", gatun.image_to_numpy, image, "w")
