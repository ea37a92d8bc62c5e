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
from vtkmodules.vtkCommonDataModel import vtkBezierWedge, vtkLagrangeWedge, vtkUnstructuredGrid

import gatunMeshes as gm
from gatun.vtk import vtkGatunReader
from gatunCells import CURVED, LINEAR, RANDOM, described, finish, polyhedron, zoo

def check(grid, **options):
    gm.assert_equal(grid, gm.round_trip(grid, "types.gtn", KeepOrder=7, **options))
    path = gm.temporary("types-free.gtn")
    gm.write(grid, path, **options)
    back = gm.read(path)
    assert back.GetNumberOfPoints() == grid.GetNumberOfPoints()
    assert described(back) == described(grid)
    return path


for kind in LINEAR + list(CURVED) + [36, 41, 63, 99, 200]:
    check(zoo([kind], 3))
    check(zoo([kind, c.VTK_TETRA], 5, wide=False))
everything = zoo(LINEAR + list(CURVED) + [36, 41, 99], 12)
for chunk in (0, 64, 500):
    check(everything, ChunkSize=chunk)

# The same bytes with any number of threads.
written = set()
threads_path = gm.temporary("threads.gtn")
for threads in (1, 2, 3):
    vtkSMPTools.Initialize(threads)
    gm.write(everything, threads_path, ChunkSize=200)
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
path = check(grid, ChunkSize=600)

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

def volumes(tets):
    a, b, d, e = np.moveaxis(gm.coordinates(tets)[gm.connectivity(tets)], 1, 0)
    return np.einsum("ij,ij->i", np.cross(b - a, d - a), e - a) / 6


# The tetrahedra of the cells fill the same space, and have their values.
tets = gm.read(path, SplitCells=True)
volume = volumes(tets)
assert volume.min() > 0 and 0.9 * n**3 < volume.sum() < 1.1 * n**3
values = {tuple(v) for v in gm.values_of(whole.GetCellData().GetArray("pair"))}
assert {tuple(v) for v in gm.values_of(tets.GetCellData().GetArray("pair"))} < values

# Those of wedges of any order, whose nodes are where VTK has them, and of hexahedra of which corners coincide.
for wedge, order in itertools.product((vtkLagrangeWedge(), vtkBezierWedge()), (1, 2, 3, 4)):
    count = (order + 1) ** 2 * (order + 2) // 2
    wedge.GetPointIds().SetNumberOfIds(count)
    wedge.GetPoints().SetNumberOfPoints(count)
    wedge.SetUniformOrderFromNumPoints(count)
    wedge.Initialize()
    places = np.array([wedge.GetParametricCoords()[i] for i in range(3 * count)]).reshape(-1, 3)
    grid = gm.make_grid(places * (2, 3, 5), [])
    grid.InsertNextCell(wedge.GetCellType(), count, list(range(count)))
    gm.write(grid, path)
    volume = volumes(gm.read(path, SplitCells=True))
    assert volume.min() > 0 and abs(volume.sum() - 15) < 1e-5, (wedge.GetClassName(), order, volume)
for ids, share in (([0, 1, 2, 2, 4, 5, 6, 6], 1 / 2), ([0, 1, 2, 3, 4, 4, 4, 4], 1 / 3), ([0, 1, 2, 2, 4, 4, 4, 4], 1 / 6)):
    grid = gm.make_grid(np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0),
                                  (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]), [])
    grid.InsertNextCell(c.VTK_HEXAHEDRON, 8, ids)
    gm.write(grid, path)
    volume = volumes(gm.read(path, SplitCells=True))
    print(ids, volume)
    assert volume.min() > 0 and abs(volume.sum() - share) < 1e-6, (ids, volume)
