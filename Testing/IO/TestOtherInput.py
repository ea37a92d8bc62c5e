# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Input that has to be changed on the way: other cells, quadratic ones, ghosts, integer points,
arrays that are not laid out tuple by tuple."""

import numpy as np
from vtkmodules.util import vtkConstants as c
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints, vtkSOADataArrayTemplate
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid

import gatunMeshes as gm
from gatun.vtk import vtkGatunWriter


class Warnings:
    def __init__(self, writer):
        self.messages = []

        @gm.calldata_type(c.VTK_STRING)
        def note(_object, _event, text):
            self.messages.append(text)

        writer.AddObserver("WarningEvent", note)

    def __str__(self):
        return "\n".join(self.messages)


def written(grid, *warnings, **options):
    path = gm.temporary("other.gtn")
    writer = vtkGatunWriter()
    texts = Warnings(writer)
    writer.SetInputDataObject(grid)
    writer.SetFileName(path)
    writer.SetKeepOrderToAll()
    gm.set_options(writer, **options)
    assert writer.Write() == 1
    assert len(texts.messages) == len(warnings), str(texts)
    for text in warnings:
        assert text in str(texts), str(texts)
        assert path in str(texts)
    return gm.read(path)


def volumes(points, tets):
    a, b, d, e = np.moveaxis(points[tets].astype(float), 1, 0)
    return np.einsum("ij,ij->i", np.cross(b - a, d - a), e - a) / 6


def values(attributes, name):
    return vtk_to_numpy(attributes.GetArray(name))


# Each cell type that is split, and its volume.
hexagon = [(np.cos(t), np.sin(t)) for t in np.arange(6) * np.pi / 3]
pentagon = [(np.cos(t), np.sin(t)) for t in np.arange(5) * 2 * np.pi / 5]
SHAPES = {
    c.VTK_HEXAHEDRON: ([(0, 0, 0), (2, 0, 0), (2, 1, 0), (0, 1, 0), (0, 0, 1), (2, 0, 1), (2, 1, 1),
                        (0, 1, 1)], 2),
    c.VTK_VOXEL: ([(0, 0, 0), (2, 0, 0), (0, 1, 0), (2, 1, 0), (0, 0, 1), (2, 0, 1), (0, 1, 1),
                   (2, 1, 1)], 2),
    c.VTK_WEDGE: ([(0, 0, 0), (0, 1, 0), (1, 0, 0), (0, 0, 1), (0, 1, 1), (1, 0, 1)], 0.5),
    c.VTK_PYRAMID: ([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0.5, 0.5, 1)], 1 / 3),
    c.VTK_PENTAGONAL_PRISM: ([(x, y, z) for z in (0, 1) for x, y in pentagon],
                             2.5 * np.sin(2 * np.pi / 5)),
    c.VTK_HEXAGONAL_PRISM: ([(x, y, z) for z in (0, 1) for x, y in hexagon],
                            1.5 * np.sqrt(3)),
    c.VTK_TETRA: ([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], 1 / 6)}

# All of them in one grid, tetrahedra first, in the middle and last; some of these turned over.
order = [c.VTK_TETRA, *[k for k in SHAPES if k != c.VTK_TETRA], c.VTK_TETRA,
         c.VTK_HEXAHEDRON, c.VTK_TETRA]
for storage in (32, 64):
    points, kinds, grid = [], [], vtkUnstructuredGrid()
    cells = []
    for i, kind in enumerate(order):
        shape = np.array(SHAPES[kind][0], float) + [10 * i, 0, 0]
        ids = np.arange(len(shape)) + len(points)
        if kind == c.VTK_TETRA and i:
            ids = ids[[1, 0, 2, 3]]
        points.extend(shape)
        cells.append(ids)
    points = np.array(points + [(99, 99, 99)])
    coordinates = vtkPoints()
    coordinates.SetData(gm.numpy_to_vtk(points, deep=True))
    grid.SetPoints(coordinates)
    grid.Allocate(len(cells))
    for kind, ids in zip(order, cells):
        grid.InsertNextCell(kind, len(ids), list(ids))
    if storage == 32:
        grid.GetCells().ConvertTo32BitStorage()
    gm.add_array(grid.GetPointData(), np.arange(len(points)), "point")
    gm.add_array(grid.GetCellData(), (1 << 60) + np.arange(len(cells)), "big")
    gm.add_array(grid.GetCellData(), np.random.default_rng(1).random((len(cells), 3)), "vector")
    gm.add_array(grid.GetCellData(), np.arange(len(cells)), "global", c.VTK_ID_TYPE)
    grid.GetCellData().SetActiveGlobalIds("global")
    grid.GetCellData().SetActiveVectors("vector")
    back = written(grid, "2 vtkHexahedron", SplitCells=True)
    assert gm.has_wide_ids(back.GetCells()) == (storage == 64)
    tets = gm.connectivity(back)
    origin = values(back.GetCellData(), "OriginalCellIds")
    assert back.GetCellData().GetArray("OriginalCellIds").GetDataType() == c.VTK_ID_TYPE
    assert np.array_equal(gm.coordinates(back), points)
    assert np.array_equal(values(back.GetPointData(), "point"), np.arange(len(points)))
    assert (np.diff(origin) >= 0).all()
    for i, (kind, ids) in enumerate(zip(order, cells)):
        mine = tets[origin == i]
        if kind == c.VTK_TETRA:
            assert np.array_equal(mine, [ids])
        else:
            assert len(mine) > 1 and set(mine.ravel()) <= set(ids)
            assert np.isclose(np.abs(volumes(points, mine)).sum(), SHAPES[kind][1])
    for name in ("big", "vector"):
        assert np.array_equal(values(back.GetCellData(), name),
                              values(grid.GetCellData(), name)[origin])
    assert back.GetCellData().GetVectors().GetName() == "vector"
    assert back.GetCellData().GetGlobalIds() is None and back.GetCellData().HasArray("global")
    # The input is as it was.
    assert grid.GetCellData().GetNumberOfArrays() == 3 and grid.GetCellData().GetGlobalIds()

# Neighboring hexahedra are split so that their tetrahedra meet: no new boundary inside.
n = 4
axis = np.arange(n + 1)
x, y, z = (a.ravel() for a in np.meshgrid(axis[:-1], axis[:-1], axis[:-1], indexing="ij"))
at = lambda i, j, k: ((x + i) * (n + 1) + y + j) * (n + 1) + z + k
hexes = np.stack([at(0, 0, 0), at(1, 0, 0), at(1, 1, 0), at(0, 1, 0),
                  at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)], 1)
points = np.stack(np.meshgrid(axis, axis, axis, indexing="ij"), -1).reshape(-1, 3)
grid = gm.make_grid(points.astype(np.float32), [])
grid.Allocate(len(hexes))
for ids in hexes:
    grid.InsertNextCell(c.VTK_HEXAHEDRON, 8, list(ids))
gm.add_array(grid.GetCellData(), np.arange(len(hexes)) * 2, "OriginalCellIds")
back = written(grid, "%d vtkHexahedron" % len(hexes), SplitCells=True)
tets = gm.connectivity(back)
faces = np.sort(np.concatenate([np.delete(tets, i, 1) for i in range(4)]), 1)
_, count = np.unique(faces, axis=0, return_counts=True)
assert (count == 1).sum() == 12 * n * n and count.max() == 2
assert np.isclose(np.abs(volumes(points, tets)).sum(), n ** 3)
# An array of that name is kept, being older.
assert set(values(back.GetCellData(), "OriginalCellIds")) == set(range(0, 2 * len(hexes), 2))

# Quadratic tetrahedra, on request: the points in the middle of the edges go, unused ones stay.
points = np.random.default_rng(5).random((16, 3))
grid = gm.make_grid(points, [])
grid.Allocate(2)
grid.InsertNextCell(c.VTK_QUADRATIC_TETRA, 10, [0, 1, 2, 3, 4, 5, 6, 7, 8, 9])
grid.InsertNextCell(c.VTK_QUADRATIC_TETRA, 10, [0, 1, 2, 9, 4, 5, 6, 10, 11, 12])
gm.add_array(grid.GetPointData(), np.arange(16), "point")
back = written(grid, "2 vtkQuadraticTetra", SplitCells=True)
ids = values(back.GetPointData(), "point")
assert np.array_equal(ids, [0, 1, 2, 3, 9, 13, 14, 15])
assert np.array_equal(ids[gm.connectivity(back)], [[0, 1, 2, 3], [0, 1, 2, 9]])
assert np.array_equal(gm.coordinates(back), points[ids])
assert not back.GetCellData().HasArray("OriginalCellIds")

# Ghosts are kept. Where they go, with split cells, what they alone use goes as well, and other flags
# stay.
points, tets = gm.lattice(4)
rng = np.random.default_rng(6)
points = np.concatenate([points, rng.random((3, 3)).astype(np.float32)])
flags = np.zeros(len(tets), np.uint8)
flags[points[tets].mean(1)[:, 0] > 0.6] = 1
kept = flags == 0
for hidden in (False, True):
    grid = gm.make_grid(points, tets)
    gm.add_array(grid.GetPointData(), np.arange(len(points)), "point")
    gm.add_array(grid.GetCellData(), np.arange(len(tets)), "cell")
    cell_flags = flags.copy()
    point_flags = np.zeros(len(points), np.uint8)
    point_flags[::2] = 1
    if hidden:
        cell_flags[::5] |= 32
        point_flags[::7] |= 2
    gm.add_array(grid.GetCellData(), cell_flags, "vtkGhostType")
    gm.add_array(grid.GetPointData(), point_flags, "vtkGhostType")
    gm.assert_same_mesh(written(grid), grid)
    lost = "%d ghost cells are left out (vtkGhostType)" % np.count_nonzero(flags)
    back = written(grid, lost, SplitCells=True)
    ids = values(back.GetPointData(), "point")
    unused = np.setdiff1d(np.arange(len(points)), tets)
    assert np.array_equal(ids, np.union1d(np.unique(tets[kept]), unused))
    assert np.array_equal(values(back.GetCellData(), "cell"), np.flatnonzero(kept))
    assert np.array_equal(ids[gm.connectivity(back)], tets[kept])
    assert np.array_equal(gm.coordinates(back), points[ids])
    for attributes, expected in ((back.GetCellData(), cell_flags[kept] & 254),
                                 (back.GetPointData(), point_flags[ids] & 254)):
        assert attributes.HasArray("vtkGhostType") == hidden
        if hidden:
            assert np.array_equal(values(attributes, "vtkGhostType"), expected)
    assert np.array_equal(values(grid.GetPointData(), "vtkGhostType"), point_flags)
    assert grid.GetNumberOfCells() == len(tets)

# Integer coordinates.
points, tets = gm.lattice(3)
for dtype in (np.int8, np.uint16, np.int32, np.uint32, np.int64):
    whole = np.round(points * 100).astype(dtype)
    if dtype == np.int64:
        whole = whole * (1 << 45) - 77
    back = written(gm.make_grid(whole, tets), "integer coordinates")
    assert back.GetPoints().GetDataType() == c.VTK_DOUBLE
    assert np.array_equal(gm.coordinates(back).astype(dtype), whole)
    assert np.array_equal(gm.connectivity(back), tets)

# Arrays of which each component lies apart.
grid = gm.make_grid(points, tets)
expected = {}
for kind, dtype in (("int64", np.int64), ("float64", np.float64), ("uint64", np.uint64),
                    ("float32", np.float32)):
    soa = vtkSOADataArrayTemplate[kind]()
    soa.SetNumberOfComponents(3)
    soa.SetNumberOfTuples(len(points))
    numbers = rng.integers(-(1 << 62), 1 << 62, (len(points), 3))
    numbers = numbers.astype(dtype) if dtype in (np.int64, np.uint64) else \
        rng.random((len(points), 3)).astype(dtype)
    for i in range(len(points)):
        for j in range(3):
            soa.SetTypedComponent(i, j, numbers[i, j].item())
    soa.SetName(kind)
    assert not soa.HasStandardMemoryLayout()
    grid.GetPointData().AddArray(soa)
    expected[kind] = numbers
back = written(grid)
for kind, numbers in expected.items():
    assert np.array_equal(values(back.GetPointData(), kind), numbers), kind
    assert back.GetPointData().GetArray(kind).GetDataType() == \
        grid.GetPointData().GetArray(kind).GetDataType()

# Field arrays of variants are left out.
from vtkmodules.vtkCommonCore import vtkVariantArray

grid = gm.make_grid(points, tets)
odd = vtkVariantArray()
odd.SetName("odd")
grid.GetFieldData().AddArray(odd)
gm.add_array(grid.GetFieldData(), np.arange(3), "even")
back = written(grid, "'odd'")
assert [a.GetName() for a in gm.arrays_of(back.GetFieldData())] == ["even"]
