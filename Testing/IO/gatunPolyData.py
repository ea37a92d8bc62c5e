# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Surfaces (vtkPolyData), and ways to compare them that are not ours."""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints, vtkTypeInt32Array, vtkTypeInt64Array
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

import gatunMeshes as gm
from gatun.vtk import vtkGatunSurfaceReader

LISTS = ("Verts", "Lines", "Polys", "Strips")


def cell_array(cells, wide=True):
    """A cell array of lists of ids."""
    kind, array = (np.int64, vtkTypeInt64Array) if wide else (np.int32, vtkTypeInt32Array)
    ids, offsets = array(), array()
    flat = np.array([i for cell in cells for i in cell], kind)
    ends = np.cumsum([0] + [len(cell) for cell in cells]).astype(kind)
    ids.SetNumberOfValues(len(flat))
    offsets.SetNumberOfValues(len(ends))
    if len(flat):
        vtk_to_numpy(ids)[:] = flat
    vtk_to_numpy(offsets)[:] = ends
    result = vtkCellArray()
    result.SetData(offsets, ids)
    return result


def make(points, wide=True, **lists):
    """A surface of points and lists of cells: Verts, Lines, Polys, Strips."""
    surface = vtkPolyData()
    places = vtkPoints()
    points = np.ascontiguousarray(points).reshape(-1, 3)
    places.SetData(numpy_to_vtk(points, deep=True))
    surface.SetPoints(places)
    for name, cells in lists.items():
        getattr(surface, "Set" + name)(cell_array(cells, wide))
    return surface


def cells_of(surface):
    """For each list, its cells as lists of ids."""
    result = []
    for name in LISTS:
        cells = getattr(surface, "Get" + name)()
        ids = vtk_to_numpy(cells.GetConnectivityArray()).tolist() if cells.GetNumberOfCells() else []
        ends = vtk_to_numpy(cells.GetOffsetsArray()).tolist()
        result.append([ids[a:b] for a, b in zip(ends, ends[1:])])
    return result


def coordinates(surface):
    if not surface.GetNumberOfPoints():
        return np.zeros((0, 3), np.float32)
    values = vtk_to_numpy(surface.GetPoints().GetData())
    return np.ascontiguousarray(values).view("u%d" % values.dtype.itemsize)


def add_arrays(surface):
    """Arrays of several kinds on points and cells, with roles, and field data."""
    rng = np.random.default_rng(5)
    n, m = surface.GetNumberOfPoints(), surface.GetNumberOfCells()
    point, cell = surface.GetPointData(), surface.GetCellData()
    gm.add_array(point, np.arange(n, dtype=np.int32), "point")
    point.SetNormals(gm.add_array(point, rng.random((n, 3)).astype(np.float32), "Normals"))
    point.SetTCoords(gm.add_array(point, rng.random((n, 2)).astype(np.float32), "places"))
    point.SetScalars(gm.add_array(
        point, rng.integers(0, 256, (n, 3)).astype(np.uint8), "colors", components=["r", "g", "b"]))
    gm.add_array(cell, np.arange(m, dtype=np.int64), "cell")
    cell.SetNormals(gm.add_array(cell, rng.random((m, 3)), "of faces"))
    gm.add_array(surface.GetFieldData(), np.array([1.5, 2.5]), "field")
    return surface


def assert_same_head(one, other):
    assert isinstance(one, vtkPolyData) and isinstance(other, vtkPolyData)
    assert one.GetNumberOfPoints() == other.GetNumberOfPoints()
    if one.GetNumberOfPoints():
        assert one.GetPoints().GetDataType() == other.GetPoints().GetDataType()
    gm.assert_same_field(one.GetFieldData(), other.GetFieldData())


def assert_equal(one, other):
    """Everything in the same order, bit for bit."""
    assert_same_head(one, other)
    assert np.array_equal(coordinates(one), coordinates(other))
    for name, a, b in zip(LISTS, cells_of(one), cells_of(other)):
        assert a == b, name
    gm.assert_same_arrays(one.GetPointData(), other.GetPointData())
    gm.assert_same_arrays(one.GetCellData(), other.GetCellData())


def canonical(surface, skip=()):
    """Points and cells with their data in an order of their own. Points that are equal in all data
    are one to the cells; the points of a cell keep their order, but a triangle may begin with any."""
    points = [row.tobytes() for row in gm.rows(coordinates(surface), *[
        gm.values_of(a) for a in gm.arrays_of(surface.GetPointData()) if a.GetName() not in skip])]
    values = [a for a in gm.arrays_of(surface.GetCellData()) if a.GetName() not in skip]
    data = gm.rows(np.zeros((surface.GetNumberOfCells(), 1), np.uint8), *map(gm.values_of, values))
    cells, at = [], 0
    for kind, listed in enumerate(cells_of(surface)):
        for ids in listed:
            corners = [points[i] for i in ids]
            if LISTS[kind] == "Polys" and len(ids) == 3:
                corners = min(corners[i:] + corners[:i] for i in range(3))
            cells.append((kind, corners, data[at].tobytes()))
            at += 1
    return sorted(points), sorted(cells)


def assert_same_surface(one, other, skip=()):
    """The same but for the order of points and cells."""
    assert_same_head(one, other)
    assert canonical(one, skip) == canonical(other, skip)


def reader_of(path, **options):
    reader = vtkGatunSurfaceReader()
    reader.SetFileName(path)
    gm.set_options(reader, **options)
    return reader


def read(path, **options):
    reader = reader_of(path, **options)
    reader.Update()
    assert reader.GetErrorCode() == 0, path
    return reader.GetOutput()


def wave(n=30, dtype=np.float32):
    """A surface of triangles and quadrilaterals with holes."""
    x, y = np.meshgrid(np.arange(n), np.arange(n))
    points = np.stack([x, y, 3 * np.sin(x / 5) * np.cos(y / 7)], -1).reshape(-1, 3).astype(dtype)
    polygons = []
    for i in range(n - 1):
        for j in range(n - 1):
            a, b, c, d = i * n + j, i * n + j + 1, (i + 1) * n + j + 1, (i + 1) * n + j
            if (i // 4 + j // 4) % 5 == 2:
                continue
            polygons += [[a, b, c, d]] if (i + j) % 3 == 0 else [[a, b, c], [c, d, a]]
    return make(points, Polys=polygons)


def moebius(n=40):
    """A strip with one side."""
    t = 2 * np.pi * np.arange(n) / n
    points = [[(1 + w * np.cos(s / 2)) * np.cos(s), (1 + w * np.cos(s / 2)) * np.sin(s),
               w * np.sin(s / 2)] for s in t for w in (-0.3, 0.3)]
    polygons = []
    for i in range(n):
        a, b = 2 * i, 2 * i + 1
        c, d = (a + 2, b + 2) if i + 1 < n else (1, 0)
        polygons += [[a, b, c], [b, d, c]]
    return make(np.array(points), Polys=polygons)


def odd():
    """Everything that a surface may have and ought not to: NaN and infinite coordinates, edges of
    three and more faces, folded, double and degenerate faces, points of no face and at one place,
    polygons that are neither flat nor convex, cells with too few points."""
    rng = np.random.default_rng(2)
    points = rng.random((60, 3))
    points[3] = np.nan
    points[4, 1] = np.inf
    points[5] = points[6]
    points[7] = -0.0
    fan = [[0, 1, i] for i in range(2, 12)]
    polygons = fan + [[0, 1, 2], [2, 1, 0], [1, 2, 0], [8, 8, 8], [8, 8, 9], [5, 6, 7], [3, 4, 5],
                      [10, 14, 11, 13, 12], list(range(20, 45)), [1, 1], [2], [], [0, 1, 0, 1]]
    return make(points, Verts=[[46], [47, 46, 47], [], [3]], Lines=[[0, 1], [5, 4, 3, 2, 5], [9], []],
                Polys=polygons, Strips=[[0, 1, 2, 3], [4, 5, 6], [7], [8, 8, 9, 9, 8], []])


def mixed(n=20):
    """A surface with many cells of all lists."""
    base = wave(n)
    rng = np.random.default_rng(3)
    count = base.GetNumberOfPoints()
    some = lambda least, most: rng.integers(0, count, rng.integers(least, most)).tolist()
    return make(
        gm.vtk_to_numpy(base.GetPoints().GetData()), Verts=[some(1, 4) for _ in range(40)],
        Lines=[some(2, 9) for _ in range(40)], Polys=cells_of(base)[2],
        Strips=[list(range(i, i + 9)) for i in range(0, count - 9, 7)])
