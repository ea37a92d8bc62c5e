# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Meshes and volumes from NumPy arrays and back, with VTK's own access as the reference."""

import gc
import sys
import warnings

import gatun
import numpy as np
from gatunCube import make_cube, require_equal, require_raises
from vtkmodules.vtkCommonCore import vtkBitArray, vtkSOADataArrayTemplate
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

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

# Meshes have memory of their own: no array of NumPy has to outlive a shallow copy of one of VTK.
for _ in range(100):
    values = np.arange(20000.0) + len(points)
    chain = gatun.from_numpy(np.zeros((20000, 3)), np.zeros((1, 4), int), point_data={"a": values})
    array = chain.GetPointData().GetArray("a")
    copy = array.NewInstance()
    copy.ShallowCopy(array)
    view = gatun.to_numpy(chain).point_data["a"]
    values[:] = -1
    del values, chain, array
    gc.collect()
    np.full(20000, 3.0)  # in memory that would have become free
    assert copy.GetValue(5) == len(points) + 5 and view[19999] == len(points) + 19999
values = np.arange(len(points), dtype=float)
count = sys.getrefcount(values)
chain = gatun.from_numpy(points, tets, point_data={"a": values})
assert sys.getrefcount(values) == count

# Masks are no part of a mesh: NaN takes their place where there is one.
masked = np.ma.masked_where(values == 7, values)
with warnings.catch_warnings(record=True) as caught:
    warnings.simplefilter("always")
    back = gatun.to_numpy(gatun.from_numpy(points, tets, point_data={"m": masked})).point_data["m"]
assert np.flatnonzero(np.isnan(back)).tolist() == [7] and back[8] == 8
assert [str(w.message) for w in caught] == ["point_data 'm': 1 masked values become NaN"]
assert caught[0].filename == __file__
integers = masked.astype(int)
require_raises(ValueError, "'m': has 1 masked values", gatun.from_numpy, points, tets, point_data={"m": integers})
unmasked = np.ma.array(values)
require_equal(gatun.to_numpy(gatun.from_numpy(points, tets, point_data={"m": unmasked})).point_data["m"], values)

# Arrays of NumPy are copies, or views that change the mesh. Whatever VTK does with its array, a copy is the same.
for _ in range(100):
    mesh = gatun.from_numpy(np.zeros((20000, 3)), {"tetra": np.zeros((5000, 4), int)}, point_data={"a": np.arange(20000.0)})
    back = gatun.to_numpy(mesh)
    mesh.GetPointData().GetArray("a").Resize(10**6)
    mesh.GetPointData().GetArray("a").Initialize()
    mesh.GetPoints().Initialize()
    mesh.GetCells().Initialize()
    np.full(20000, 3.0), np.full((20000, 3), 3.0), np.full((5000, 4), 3)
    assert back.point_data["a"][19999] == 19999 and not back.points.any() and not back.cells[0][1].any()
mesh = gatun.from_numpy(points, tets, point_data={"a": values})
gatun.to_numpy(mesh).point_data["a"][5] = -1
assert mesh.GetPointData().GetArray("a").GetValue(5) == 5
view = gatun.to_numpy(mesh, copy=False)
view.point_data["a"][5] = -1
assert mesh.GetPointData().GetArray("a").GetValue(5) == -1 and np.shares_memory(
    view.cells[0][1], gatun.to_numpy(mesh, copy=False).cells[0][1]
)

# Types of numbers that VTK does not have, and those that NumPy does not have.
halves = (points[:, 0] / 3).astype(np.float16)
mesh = gatun.from_numpy(points, tets, point_data={"h": halves, "texts": [f"p{i}" for i in range(64)]})
back = gatun.to_numpy(mesh).point_data
require_equal(back["h"], halves.astype(np.float32))
assert back["texts"].tolist() == [f"p{i}" for i in range(64)]
bits = vtkBitArray()
parts = vtkSOADataArrayTemplate["float64"]()
for array, width in ((bits, 1), (parts, 2)):
    array.SetName(array.GetClassName())
    array.SetNumberOfComponents(width)
    array.SetNumberOfTuples(64)
    for i in range(64):
        for j in range(width):
            array.SetComponent(i, j, i % 3 == j)
    mesh.GetPointData().AddArray(array)
back = gatun.to_numpy(mesh).point_data
require_equal(back[bits.GetName()], (np.arange(64) % 3 == 0).astype(np.uint8))
assert back[parts.GetName()].tolist() == [[float(i % 3 == 0), float(i % 3 == 1)] for i in range(64)]

# Cells without a fixed number of points.
curve = gatun.from_numpy(points, {"VTK_LAGRANGE_CURVE": [[0, 2, 1]]})
assert curve.GetCellType(0) == 68 and gatun.to_numpy(curve).cells[0][0] == "VTK_LAGRANGE_CURVE"

# Texts in field data.
mesh = gatun.from_numpy(points, tets, field_data={"names": ["a", "\u00e4\u6f22"], "one": "text"})
assert gatun.to_numpy(mesh).field_data == {"names": ["a", "\u00e4\u6f22"], "one": ["text"]}

# Volumes.
voxels = rng.integers(0, 1000, (4, 3, 2)).astype(np.int16)
image = gatun.image_from_numpy(voxels, spacing=(1, 2, 3), origin=(5, 6, 7), name="v")
assert image.GetDimensions() == (2, 3, 4) and image.GetBounds() == (5, 6, 6, 10, 7, 16)
assert image.GetScalarComponentAsDouble(1, 2, 3, 0) == voxels[3, 2, 1]
require_equal(gatun.image_to_numpy(image), voxels)
require_equal(gatun.image_to_numpy(image, "v"), voxels)

# What does not fit.
marks = np.zeros(voxels.shape, bool)
marks[1, 1, 1] = True
make = gatun.from_numpy
require_raises(ValueError, "points: has to be n x 3", make, np.zeros(3), tets)
require_raises(ValueError, "from 0 to 63 only", make, points, tets + 1)
require_raises(ValueError, "from 0 to 63 only", make, points, tets - 1)
require_raises(ValueError, "row per cell", make, points, tets.astype(float))
require_raises(ValueError, "'tetra' has 4 points, not 3", make, points, tets[:, :3])
require_raises(ValueError, "'tet' is not known", make, points, {"tet": tets})
require_raises(ValueError, "has 2 values for 64", make, points, tets, point_data={"a": [1, 2]})
require_raises(ValueError, "has 2 values for 162", make, points, tets, cell_data={"a": [1, 2]})
require_raises(ValueError, "no values in a row", make, points, tets, point_data={"a": np.zeros((64, 0))})
for remedy, values in (
    ("real and the imaginary", points[:, 0] * 1j),
    ("astype('float64')", points[:, 0].astype(np.longdouble)),
    ("each of its fields", np.zeros(64, [("x", float), ("y", int)])),
    ("astype('int64')", np.zeros(64, "M8[s]")),
    ("numpy.char.decode", np.full(64, b"text")),
    ("numbers or texts", np.array([None] * 64)),
):
    error = require_raises(ValueError, remedy, make, points, tets, point_data={"a": values})
    assert str(error).startswith("point_data 'a': arrays of type "), error
    require_raises(ValueError, remedy, make, points, tets, field_data={"a": values})
require_raises(ValueError, "at which VTK ends it", make, points, tets, field_data={"a": ["a\0b"]})
require_raises(ValueError, "cells: 'tetra' has masked values", make, points, np.ma.masked_equal(tets, 3))
require_raises(ValueError, "has 1 masked values", gatun.image_from_numpy, np.ma.array(voxels, mask=marks))
require_raises(ValueError, "no 'tetra'", make, points, tets, surface=True)
require_raises(
    ValueError, "vertices first", make, points, [("quad", [[0, 1, 2, 3]]), ("line", [[0, 1]])], surface=True
)
require_raises(TypeError, "no vtkUnstructuredGrid", gatun.to_numpy, image)
require_raises(ValueError, "3 dimensions", gatun.image_from_numpy, np.zeros((2, 2)))
require_raises(ValueError, "no array 'w'", gatun.image_to_numpy, image, "w")

# Cells that no points are there for, and cells without points.
bare = vtkPolyData()
cells = vtkCellArray()
for corners in ([0], [3, 4], []):
    cells.InsertNextCell(len(corners), corners)
bare.SetVerts(cells)
blocks = gatun.to_numpy(bare).cells
assert [(name, corners.tolist()) for name, corners in blocks] == [
    ("vertex", [[0]]), ("poly_vertex", [[3, 4]]), ("poly_vertex", [[]])
], blocks
