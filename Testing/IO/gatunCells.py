# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Cells of any type: random ones, and a description of cells that does not depend on their order."""

import itertools

import numpy as np
from vtkmodules.util import vtkConstants as c
from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkCommonDataModel import VTK_POLYHEDRON

import gatunMeshes as gm

# The number of points of each type; any for those that are not listed.
SIZES = {0: 0, 1: 1, 3: 2, 5: 3, 8: 4, 9: 4, 10: 4, 11: 8, 12: 8, 13: 6, 14: 5, 15: 10, 16: 12,
         21: 3, 22: 6, 23: 8, 24: 10, 25: 20, 26: 15, 27: 13, 28: 9, 29: 27, 30: 6, 31: 12, 32: 18,
         33: 24, 34: 7, 35: 4, 37: 19}
CURVED = {68: 4, 69: 10, 70: 16, 71: 20, 72: 64, 73: 40, 74: 55,
          75: 4, 76: 10, 77: 16, 78: 20, 79: 64, 80: 40, 81: 55}
LINEAR = [t for t in range(0, 43) if t not in (17, 18, 19, 20, 36, 38, 39, 40)]
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
    elif kind == c.VTK_TRIANGLE and len(corners) == 3:
        corners = min(corners[i:] + corners[:i] for i in range(3))
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
