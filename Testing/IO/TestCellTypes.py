# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Cells of every type come back: one by one in the original order, and as sets by default, whole
and in pieces with ghosts. What a file is made of does not depend on threads."""

import itertools

import numpy as np
from vtkmodules.util import vtkConstants as c
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkCommonCore import vtkSMPTools
from vtkmodules.vtkCommonDataModel import VTK_POLYHEDRON, vtkUnstructuredGrid

import gatunMeshes as gm
from gatun import vtkGatunReader

# The number of points of each type; any for those that are not listed.
SIZES = {0: 0, 1: 1, 3: 2, 5: 3, 8: 4, 9: 4, 10: 4, 11: 8, 12: 8, 13: 6, 14: 5, 15: 10, 16: 12,
         21: 3, 22: 6, 23: 8, 24: 10, 25: 20, 26: 15, 27: 13, 28: 9, 29: 27, 30: 6, 31: 12, 32: 18,
         33: 24, 34: 7, 35: 4, 37: 19}
CURVED = {68: 4, 69: 10, 70: 16, 71: 20, 72: 64, 73: 40, 74: 55,
          75: 4, 76: 10, 77: 16, 78: 20, 79: 64, 80: 40, 81: 55}
RANDOM = np.random.default_rng(17)


def polyhedron(grid, ids):
    """A prism over a polygon with half of the points."""
    half = len(ids) // 2
    faces = [ids[:half][::-1], ids[half:]]
    faces += [[ids[i], ids[(i + 1) % half], ids[half + (i + 1) % half], ids[half + i]]
              for i in range(half)]
    stream = vtkIdList()
    stream.InsertNextId(len(faces))
    for face in faces:
        stream.InsertNextId(len(face))
        for point in face:
            stream.InsertNextId(int(point))
    grid.InsertNextCell(VTK_POLYHEDRON, stream)


def finish(grid):
    cells = grid.GetNumberOfCells()
    gm.add_array(grid.GetCellData(), RANDOM.integers(0, 9, cells), "kind")
    gm.add_array(grid.GetCellData(), RANDOM.random((cells, 2)).astype(np.float32), "pair")
    gm.add_array(grid.GetPointData(), RANDOM.random(grid.GetNumberOfPoints()), "heat")
    return grid


def zoo(types, count, wide=True):
    """Random cells of each type over random points; some points have no cell."""
    grid = gm.make_grid(RANDOM.random((300, 3)), [])
    grid.Allocate(1)
    for _ in range(count):
        for kind in types:
            size = SIZES.get(kind, CURVED.get(kind, int(RANDOM.integers(3, 9))))
            ids = RANDOM.permutation(280)[:size].tolist()
            if kind == VTK_POLYHEDRON:
                polyhedron(grid, RANDOM.permutation(280)[:2 * int(RANDOM.integers(3, 7))].tolist())
            else:
                grid.InsertNextCell(kind, size, ids)
    if not wide:
        grid.GetCells().ConvertTo32BitStorage()
    return finish(grid)


def describe(grid, cell):
    """A cell by the places of its points, up to what the default leaves free."""
    at = gm.coordinates(grid)
    places = lambda ids: [tuple(at[i]) for i in ids]
    ids = vtkIdList()
    grid.GetCells().GetCellAtId(cell, ids)
    corners = places([ids.GetId(i) for i in range(ids.GetNumberOfIds())])
    kind = grid.GetCellType(cell)
    if kind == c.VTK_TETRA:
        even = [p for p in itertools.permutations(range(4))
                if sum(p[i] > p[j] for i in range(4) for j in range(i, 4)) % 2 == 0]
        corners = min([corners[i] for i in p] for p in even)
    faces = []
    if kind == VTK_POLYHEDRON:
        stream = gm.faces_of(grid, cell)[1:]
        while stream:
            face = places(stream[1:stream[0] + 1])
            faces.append(min(tuple(face[i:] + face[:i]) for i in range(len(face))))
            stream = stream[len(face) + 1:]
        corners.sort()
        faces.sort()
    values = [tuple(gm.values_of(a)[cell]) for a in gm.arrays_of(grid.GetCellData())
              if a.GetName() != "vtkGhostType"]
    return kind, tuple(corners), tuple(faces), tuple(values)


def described(grid, cells=None):
    return sorted(describe(grid, i) for i in (range(grid.GetNumberOfCells()) if cells is None
                                              else cells))


def check(grid, **options):
    gm.assert_equal(grid, gm.round_trip(grid, "types.gtn", KeepOrder=7, **options))
    path = gm.temporary("types-free.gtn")
    gm.write(grid, path, **options)
    back = gm.read(path)
    assert back.GetNumberOfPoints() == grid.GetNumberOfPoints()
    assert described(back) == described(grid)
    return path


linear = [t for t in range(0, 43) if t not in (17, 18, 19, 20, 36, 38, 39, 40)]
for kind in linear + list(CURVED) + [36, 41, 63, 99, 200]:
    check(zoo([kind], 3))
    check(zoo([kind, c.VTK_TETRA], 5, wide=False))
everything = zoo(linear + list(CURVED) + [36, 41, 99], 12)
for chunk in (0, 64, 500):
    check(everything, ChunkTets=chunk)

# The same bytes with any number of threads.
written = set()
threads_path = gm.temporary("threads.gtn")
for threads in (1, 2, 3):
    vtkSMPTools.Initialize(threads)
    gm.write(everything, threads_path, ChunkTets=200)
    with open(threads_path, "rb") as file:
        written.add(file.read())
assert len(written) == 1
vtkSMPTools.Initialize()

# Layers of cells of all kinds: pieces are disjoint, and their ghosts are those of a neighborhood.
n = 9
axis = np.arange(n + 1)
points = np.stack(np.meshgrid(axis, axis, axis, indexing="ij"), -1).reshape(-1, 3)
points = points + 0.1 * RANDOM.random(points.shape)
grid = gm.make_grid(points, [])
grid.Allocate(1)
at = lambda i, j, k: int((i * (n + 1) + j) * (n + 1) + k)
for i, j, k in itertools.product(range(n), repeat=3):
    corner = [at(i + a, j + b, k + d) for d in (0, 1) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
    choice = (i + 2 * j + 3 * k) % 5
    if choice == 0:
        grid.InsertNextCell(c.VTK_WEDGE, 6, [corner[x] for x in (0, 2, 1, 4, 6, 5)])
        grid.InsertNextCell(c.VTK_WEDGE, 6, [corner[x] for x in (0, 3, 2, 4, 7, 6)])
    elif choice == 1:
        polyhedron(grid, corner)
    elif choice == 2:
        grid.InsertNextCell(c.VTK_VOXEL, 8, [corner[x] for x in (0, 1, 3, 2, 4, 5, 7, 6)])
        grid.InsertNextCell(c.VTK_QUAD, 4, corner[:4])
        grid.InsertNextCell(c.VTK_LINE, 2, corner[1:3])
    else:
        grid.InsertNextCell(c.VTK_HEXAHEDRON, 8, corner)
finish(grid)
path = check(grid, ChunkTets=600)

reader = vtkGatunReader()
reader.SetFileName(path)
reader.GenerateGlobalIdsOn()
reader.Update()
whole = vtkUnstructuredGrid()
whole.ShallowCopy(reader.GetOutput())
cells = vtk_to_numpy(whole.GetCellData().GetGlobalIds())
assert sorted(cells) == list(range(grid.GetNumberOfCells()))


def points_of(mesh, cell):
    ids = vtkIdList()
    mesh.GetCells().GetCellAtId(cell, ids)
    return {ids.GetId(i) for i in range(ids.GetNumberOfIds())}


users = [points_of(whole, i) for i in range(whole.GetNumberOfCells())]
seen = []
for levels in (0, 1):
    for piece in range(4):
        reader.UpdatePiece(piece, 4, levels)
        part = reader.GetOutput()
        ids = vtk_to_numpy(part.GetCellData().GetGlobalIds())
        ghosts = part.GetCellData().GetArray("vtkGhostType")
        ghosts = vtk_to_numpy(ghosts) if ghosts else np.zeros(len(ids), np.uint8)
        own = set(ids[ghosts == 0])
        if levels == 0:
            seen += list(own)
        touched = set().union(*(users[i] for i in np.flatnonzero(np.isin(cells, list(own)))))
        around = {cells[i] for i in range(len(users)) if users[i] & touched}
        assert set(ids) == (around if levels else own)
        same = [int(np.flatnonzero(cells == i)[0]) for i in ids]
        part.GetCellData().RemoveArray("vtkGhostType")
        assert described(part) == described(whole, same)
assert sorted(seen) == list(range(grid.GetNumberOfCells()))

# The tetrahedra of the cells fill the same space, and have their values.
tets = gm.read(path, SplitCells=True)
corners = gm.coordinates(tets)[gm.connectivity(tets)]
a, b, d, e = np.moveaxis(corners, 1, 0)
volume = np.einsum("ij,ij->i", np.cross(b - a, d - a), e - a) / 6
assert volume.min() > 0 and 0.9 * n**3 < volume.sum() < 1.1 * n**3
values = {tuple(v) for v in gm.values_of(whole.GetCellData().GetArray("pair"))}
assert {tuple(v) for v in gm.values_of(tets.GetCellData().GetArray("pair"))} < values
