# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Grids of cells of many types: images, isosurfaces and simplified meshes are those of their tetrahedra
in a file, and surfaces, lines and vertices among the cells change nothing."""

import itertools

import numpy as np
from vtkmodules.util import vtkConstants as c
from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkCommonDataModel import VTK_POLYHEDRON, vtkUnstructuredGrid

import gatunContours as gc
import gatunMeshes as gm
import gatunVolumes as gv
from gatun.vtk import vtkGatunSimplify, vtkGatunWriter

N = 5
CORNERS = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
HEXAHEDRON = ((0, 4, 7, 3), (1, 2, 6, 5), (0, 1, 5, 4), (3, 7, 6, 2), (0, 3, 2, 1), (4, 5, 6, 7))
QUADRATIC = ((0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7))


def insert_polyhedron(grid, faces):
    stream = vtkIdList()
    for value in itertools.chain([len(faces)], *([len(face), *face] for face in faces)):
        stream.InsertNextId(int(value))
    grid.InsertNextCell(VTK_POLYHEDRON, stream)


def mixture(quadratic=False, seed=2):
    """Cubes, each as one or several cells of a random type; points inside are moved."""
    rng = np.random.default_rng(seed)
    axis = np.arange(N + 1)
    points = [np.array(p, float) for p in itertools.product(axis, axis, axis)]
    for p in points:
        p += np.where((p > 0) & (p < N), rng.uniform(-0.2, 0.2, 3), 0)
    cells = []
    for x, y, z in itertools.product(range(N), repeat=3):
        ids = [((x + i) * (N + 1) + y + j) * (N + 1) + z + k for i, j, k in CORNERS]
        kind = rng.integers(5)
        if (x + 2 * y) % 4 == 1:
            kind = 5  # columns, as triangles of wedges only fit each other
        if kind == 0:
            cells.append((c.VTK_HEXAHEDRON, ids))
        elif kind == 5:
            cells.append((c.VTK_WEDGE, [ids[i] for i in (0, 1, 3, 4, 5, 7)]))
            cells.append((c.VTK_WEDGE, [ids[i] for i in (1, 2, 3, 5, 6, 7)]))
        elif kind == 2:
            points.append(np.mean([points[i] for i in ids], 0))
            cells += [(c.VTK_PYRAMID, [ids[i] for i in face[::-1]] + [len(points) - 1])
                      for face in HEXAHEDRON]
        elif kind == 3:
            cells.append((VTK_POLYHEDRON, [np.roll([ids[i] for i in face], rng.integers(4))
                                             for face in HEXAHEDRON]))
        elif kind == 4 and quadratic:
            for a, b in QUADRATIC:
                points.append((points[ids[a]] + points[ids[b]]) / 2 + rng.uniform(-0.05, 0.05, 3))
            cells.append((c.VTK_QUADRATIC_HEXAHEDRON, ids + list(range(len(points) - 12, len(points)))))
        else:
            cells.append((c.VTK_VOXEL, [ids[i] for i in (0, 1, 3, 2, 4, 5, 7, 6)]))
    return make(np.array(points), cells)


def make(points, cells):
    grid = gm.make_grid(points, [])
    grid.Allocate(len(cells))
    for kind, ids in cells:
        if kind == VTK_POLYHEDRON:
            insert_polyhedron(grid, ids)
        else:
            grid.InsertNextCell(kind, len(ids), [int(i) for i in ids])
    x, y, z = points.T
    gm.add_array(grid.GetPointData(), np.sin(1.1 * x + y) * np.cos(z - 0.4 * y), "wave")
    gm.add_array(grid.GetCellData(), np.arange(len(cells)), "cell")
    grid.GetPointData().SetActiveScalars("wave")
    return grid


def cells_of(grid):
    cells = []
    for i in range(grid.GetNumberOfCells()):
        if grid.GetCellType(i) == VTK_POLYHEDRON:
            cell = grid.GetCell(i)
            ids = [[face.GetPointId(k) for k in range(face.GetNumberOfPoints())]
                   for face in map(cell.GetFace, range(cell.GetNumberOfFaces()))]
        else:
            corners = vtkIdList()
            grid.GetCellPoints(i, corners)
            ids = [corners.GetId(k) for k in range(corners.GetNumberOfIds())]
        cells.append((grid.GetCellType(i), ids))
    return cells


def with_others(grid):
    """The same with cells of lower dimensions before, among and after its own, some of points of
    their own."""
    points = np.concatenate([gm.coordinates(grid), [[9, 9, 9], [9, 8, 9], [8, 9, 30]]])
    first = grid.GetNumberOfPoints()
    others = [(c.VTK_TRIANGLE, [first, first + 1, first + 2]), (c.VTK_QUAD, [0, 1, 7, 6]),
              (c.VTK_LINE, [3, first]), (c.VTK_VERTEX, [5]), (c.VTK_POLYGON, [0, 1, 8, 7, 6]),
              (c.VTK_QUADRATIC_TRIANGLE, [0, 1, 2, 3, 4, 5]), (c.VTK_EMPTY_CELL, [])]
    cells = []
    numbers = []
    for i, cell in enumerate(cells_of(grid)):
        if i % 20 == 0:
            cells.append(others[i // 20 % len(others)])
            numbers.append(-1)
        cells.append(cell)
        numbers.append(i)
    whole = make(points, cells + others)
    whole.GetCellData().RemoveArray("cell")
    gm.add_array(whole.GetCellData(), np.array(numbers + [-1] * len(others)), "cell")
    return whole


def silent(algorithm):
    algorithm.AddObserver("WarningEvent", lambda *_: None)
    return algorithm


def write(grid, name, split=False):
    writer = silent(vtkGatunWriter())
    writer.SetInputDataObject(grid)
    writer.SetSplitCells(split)
    writer.SetFileName(gm.temporary(name))
    writer.SetKeepOrderToAll()
    assert writer.Write() == 1
    return gc.open_file(writer.GetFileName())


def simplify(grid, ratio):
    filter = silent(vtkGatunSimplify())
    filter.SetInputDataObject(grid)
    filter.SetArrayWeight("wave", 1)
    filter.SetSimplificationRatio(ratio)
    filter.Update()
    assert filter.GetErrorCode() == 0
    return filter.GetOutput()


def contour_of(source):
    contour = silent(gc.make_contour(source, [-0.3, 0.2], "wave"))
    contour.Update()
    assert contour.GetErrorCode() == 0
    return contour.GetOutput()


def faces_of(tets):
    return np.sort(tets[:, [[1, 2, 3], [0, 2, 3], [0, 1, 3], [0, 1, 2]]].reshape(-1, 3), 1)


for quadratic in (False, True):
    grid = mixture(quadratic)
    reader = write(grid, "cells-%d.gtn" % quadratic)
    tets = gm.read(reader.GetFileName(), SplitCells=True)

    # The tetrahedra fill the box, and each inner face is in two of them.
    points = gm.coordinates(tets)
    a, b, d, e = np.moveaxis(points[gm.connectivity(tets)], 1, 0)
    volumes = np.einsum("ij,ij->i", np.cross(b - a, d - a), e - a) / 6
    assert abs(abs(volumes).sum() - N ** 3) < 1e-9
    faces, counts = np.unique(faces_of(gm.connectivity(tets)), axis=0, return_counts=True)
    assert counts.max() == 2 and (counts == 1).sum() == 12 * N * N
    assert (points[faces[counts == 1]].std(1).min(1) == 0).all(), "a face inside"

    # All that is made of them is the same.
    drawn = gv.draw(grid)
    assert 0.05 < (drawn[0][..., 3] > 0.01).mean()
    assert gv.difference(drawn[0], gv.draw(reader)[0]) <= 1 / 255
    surface = contour_of(grid)
    assert gc.assert_same(surface, gc.reference(tets, [-0.3, 0.2], "wave")) > 100
    assert gc.assert_same(contour_of(reader), surface) > 100
    coarse = simplify(grid, 0.4)
    split = gm.read(write(grid, "cells-split.gtn", True).GetFileName())
    split.GetCellData().RemoveArray("OriginalCellIds")
    gm.assert_equal(coarse, simplify(split, 0.4))

    # Others disturb nothing.
    more = with_others(grid)
    assert more.GetNumberOfCells() > grid.GetNumberOfCells() + 10
    assert gv.difference(drawn[0], gv.draw(more)[0]) == 0
    assert gc.assert_same(contour_of(more), surface) > 100
    gm.assert_same_mesh(simplify(more, 0.4), coarse)

# One triangle beside tetrahedra, and nothing else.
plain = gv.box()
one = vtkUnstructuredGrid()
one.SetPoints(plain.GetPoints())
one.GetPointData().ShallowCopy(plain.GetPointData())
one.InsertNextCell(c.VTK_TRIANGLE, 3, [0, 1, 2])
for tet in gm.connectivity(plain):
    one.InsertNextCell(c.VTK_TETRA, 4, tet.tolist())
assert gv.difference(gv.draw(plain)[0], gv.draw(one)[0]) == 0
empty = vtkUnstructuredGrid()
empty.SetPoints(plain.GetPoints())
empty.GetPointData().ShallowCopy(plain.GetPointData())
empty.InsertNextCell(c.VTK_TRIANGLE, 3, [0, 1, 2])
assert gv.draw(empty)[0].max() == 0
assert gc.contour_of(empty, 0.5, "wave").GetNumberOfCells() == 0

# Pieces with numbers of points of their own fit: together they have the tetrahedra of the whole.
grid = mixture()
whole = gm.read(write(grid, "cells-whole.gtn").GetFileName(), SplitCells=True)
found = []
for part in range(2):
    order = np.random.default_rng(part).permutation(grid.GetNumberOfPoints())
    number = np.argsort(order)
    cells = [(kind, [number[face] for face in ids] if kind == VTK_POLYHEDRON else number[ids])
             for i, (kind, ids) in enumerate(cells_of(grid)) if (i * 7 // 5) % 2 == part]
    reader = write(make(gm.coordinates(grid)[order], cells), "cells-piece.gtn")
    piece = gm.read(reader.GetFileName(), SplitCells=True)
    found.append(gm.coordinates(piece)[gm.connectivity(piece)])


def sorted_places(tets):
    order = np.lexsort(np.moveaxis(tets, 2, 0)[::-1], axis=1)
    return np.unique(np.take_along_axis(tets, order[..., None], 1).reshape(len(tets), 12), axis=0)


expected = sorted_places(gm.coordinates(whole)[gm.connectivity(whole)])
np.testing.assert_array_equal(sorted_places(np.concatenate(found)), expected)
assert len(expected) == whole.GetNumberOfCells()

print("all good")
