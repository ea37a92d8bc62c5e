# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Small meshes of cells of all types, for the independent decoder. Each function gives a grid with
arrays on points and cells."""

import numpy as np
from vtkmodules.util import vtkConstants as c
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkCommonDataModel import VTK_POLYHEDRON, vtkCellArray

import gatunMeshes as gm
from gatunCells import CURVED, SIZES
from gtn_shapes import NODES, SURFACES

BIQUADRATIC_TRIANGLE = 34
HEXAHEDRON = SURFACES[c.VTK_HEXAHEDRON]

# --------------------------------------------------------------------------------------------------
# Grids from lists of cells


def grid_of(points, cells, rng, dtype=np.float32):
    """cells: pairs of a type and points, or faces for a polyhedron."""
    grid = gm.make_grid(np.asarray(points).astype(dtype), [])
    grid.Allocate(1)
    for kind, ids in cells:
        if kind != VTK_POLYHEDRON:
            grid.InsertNextCell(kind, len(ids), [int(i) for i in ids])
            continue
        stream = vtkIdList()
        for number in [len(ids), *(x for face in ids for x in (len(face), *face))]:
            stream.InsertNextId(int(number))
        grid.InsertNextCell(kind, stream)
    return with_arrays(grid, rng)


def with_arrays(grid, rng):
    """Adds smooth and random arrays of several types."""
    points, cells = gm.coordinates(grid).astype(float), grid.GetNumberOfCells()
    points[~(np.abs(points) < 100)] = 0
    on_points, on_cells = grid.GetPointData(), grid.GetCellData()
    gm.add_array(on_points, np.sin(points).sum(1).astype(np.float32), "wave")
    gm.add_array(on_points, points[:, ::-1] ** 2, "vector")
    gm.add_array(on_points, np.floor(3 * points[:, 0]).astype(np.int16), "slab")
    gm.add_array(on_cells, np.arange(cells, dtype=np.int64), "number")
    gm.add_array(on_cells, rng.random((cells, 2)).astype(np.float32), "pair")
    gm.add_array(on_cells, rng.integers(0, 3, cells).astype(np.uint8), "material")
    return grid


def cubes(n):
    """Points of n[0] * n[1] * n[2] cubes and, for each, its corners as those of a hexahedron."""
    points = np.array(list(np.ndindex(*(m + 1 for m in n))), float)
    at = lambda x, y, z: (x * (n[1] + 1) + y) * (n[2] + 1) + z
    around = [(0, 0), (1, 0), (1, 1), (0, 1)]
    boxes = [[at(x + i, y + j, z + k) for k in (0, 1) for i, j in around]
             for x, y, z in np.ndindex(*n)]
    return points, boxes


def bent(points, rng, jitter=0.1):
    """Points on curves, and off them."""
    x, y, z = points.T
    result = np.stack([x + 0.1 * np.sin(y), y + 0.05 * z * z, z + 0.1 * np.cos(x)], 1)
    return result + rng.uniform(-jitter, jitter, points.shape)


class Points:
    """Points that are added one by one, each only once."""

    def __init__(self, points):
        self.points = [tuple(p) for p in points]
        self.numbers = {p: i for i, p in enumerate(self.points)}

    def mean(self, ids):
        """The number of the point in the middle of others."""
        return self.at(tuple(np.mean([self.points[i] for i in ids], axis=0)))

    def at(self, p):
        """The number of the point with these coordinates."""
        if p not in self.numbers:
            self.numbers[p] = len(self.points)
            self.points.append(p)
        return self.numbers[p]


def voxel(box):
    return [box[i] for i in (0, 1, 3, 2, 4, 5, 7, 6)]


def box_faces(box):
    return [[box[i] for i in face] for face in HEXAHEDRON]


def outer(faces):
    """Those that are there just once, whatever their direction."""
    times = {}
    for face in faces:
        times.setdefault(frozenset(face), []).append(face)
    return [found[0] for found in times.values() if len(found) == 1]


# --------------------------------------------------------------------------------------------------
# Linear cells


def hexahedra(rng, n=(5, 5, 5), jitter=0.1):
    points, boxes = cubes(n)
    return grid_of(bent(points, rng, jitter), [(c.VTK_HEXAHEDRON, box) for box in boxes], rng)


def hexahedra_at_random(rng, n=(4, 4, 4)):
    """In any order, with any corner first."""
    points, boxes = cubes(n)
    turns = [[0, 1, 2, 3, 4, 5, 6, 7], [1, 2, 3, 0, 5, 6, 7, 4], [4, 7, 6, 5, 0, 3, 2, 1],
             [0, 4, 5, 1, 3, 7, 6, 2]]
    order = rng.permutation(len(boxes))
    cells = [(c.VTK_HEXAHEDRON, np.array(boxes[i])[turns[rng.integers(4)]]) for i in order]
    number = rng.permutation(len(points))
    place = np.argsort(number)
    cells = [(kind, place[ids]) for kind, ids in cells]
    return grid_of(bent(points, rng)[number], cells, rng, np.float64)


def voxels(rng, n=(5, 4, 4)):
    points, boxes = cubes(n)
    return grid_of(points * [1, 0.5, 0.25], [(c.VTK_VOXEL, voxel(box)) for box in boxes], rng)


def wedges(rng, n=(4, 4, 4)):
    points, boxes = cubes(n)
    cells = [(c.VTK_WEDGE, [box[i] for i in half])
             for box in boxes for half in ((0, 2, 1, 4, 6, 5), (0, 3, 2, 4, 7, 6))]
    return grid_of(bent(points, rng), cells, rng)


def pyramids(rng, n=(3, 3, 3)):
    points, boxes = cubes(n)
    added = Points(points)
    cells = []
    for box in boxes:
        top = added.mean(box)
        cells += [(c.VTK_PYRAMID, face[::-1] + [top]) for face in box_faces(box)]
    return grid_of(bent(np.array(added.points), rng, 0.05), cells, rng)


def transition(rng, n=(5, 3, 3)):
    """Hexahedra, then pyramids and tetrahedra, then wedges."""
    points, boxes = cubes(n)
    added = Points(points)
    cells = []
    middle = n[0] // 2
    tets = set(added.numbers[p] for p in added.points if p[0] > middle)
    for box in boxes:
        x = added.points[box[0]][0]
        if x < middle:
            cells.append((c.VTK_HEXAHEDRON, box))
        elif x > middle:
            cells += [(c.VTK_WEDGE, [box[i] for i in half])
                      for half in ((0, 2, 1, 4, 6, 5), (0, 3, 2, 4, 7, 6))]
        else:
            top = added.mean(box)
            for face in box_faces(box):
                if sum(p in tets for p in face) == 2:
                    cells.append((c.VTK_TETRA, [face[0], face[2], face[1], top]))
                    cells.append((c.VTK_TETRA, [face[0], face[3], face[2], top]))
                else:
                    cells.append((c.VTK_PYRAMID, face[::-1] + [top]))
    return grid_of(bent(np.array(added.points), rng, 0.05), cells, rng)


def prisms(rng, n=5, layers=3):
    """Hexagonal prisms, some of which are two pentagonal ones."""
    added = Points([])
    cells = []

    def at(p):
        return added.at(tuple(np.round(p, 6)))

    corners = [(np.cos(np.pi * i / 3), np.sin(np.pi * i / 3)) for i in range(6)]
    for i, j, k in np.ndindex(n, n, layers):
        middle = np.array([1.5 * i, np.sqrt(3) * (j + 0.5 * (i % 2))])
        ring = [middle + corner for corner in corners]
        ends = [[at((*p, z)) for p in ring] for z in (k, k + 1)]
        if (i + 2 * j) % 3:
            cells.append((c.VTK_HEXAGONAL_PRISM, ends[0] + ends[1]))
            continue
        halves = [[at((*(ring[m] + ring[m + 1]) / 2, z)) for m in (0, 3)] for z in (k, k + 1)]
        cells.append((c.VTK_PENTAGONAL_PRISM, [
            p for (a, b), end in zip(halves, ends) for p in (a, end[1], end[2], end[3], b)]))
        cells.append((c.VTK_PENTAGONAL_PRISM, [
            p for (a, b), end in zip(halves, ends) for p in (b, end[4], end[5], end[0], a)]))
    return grid_of(bent(np.array(added.points), rng, 0.02), cells, rng)


# --------------------------------------------------------------------------------------------------
# Polyhedra


def hanging(rng, n=(4, 4, 3), as_polyhedra=True):
    """Cubes, some of which are eight smaller ones; larger ones beside those are polyhedra whose
    faces are divided, or stay hexahedra with hanging nodes."""
    points, boxes = cubes(n)
    added = Points(points)
    fine = [rng.random() < 0.3 for _ in boxes]
    divided = {frozenset(face) for box, is_fine in zip(boxes, fine) if is_fine
               for face in box_faces(box)}
    cells = []
    for box, is_fine in zip(boxes, fine):
        if is_fine:
            for corner in range(8):
                small = [added.mean([box[corner], box[i]]) for i in range(8)]
                cells.append((c.VTK_HEXAHEDRON, small))
            continue
        faces = []
        for face in box_faces(box):
            if frozenset(face) in divided:
                sides = [added.mean([face[i], face[(i + 1) % 4]]) for i in range(4)]
                middle = added.mean(face)
                faces += [[face[i], sides[i], middle, sides[i - 1]] for i in range(4)]
            else:
                faces.append(face)
        if as_polyhedra and len(faces) > 6:
            faces = [with_hanging(face, added, divided, box) for face in faces]
            cells.append((VTK_POLYHEDRON, faces))
        else:
            cells.append((c.VTK_HEXAHEDRON, box))
    return grid_of(bent(np.array(added.points), rng, 0.03), cells, rng)


def with_hanging(face, added, divided, box):
    """A face with the middles of those sides that a divided face of the same box has, too."""
    result = []
    for a, b in zip(face, face[1:] + face[:1]):
        result.append(a)
        if any({a, b} <= f for f in divided if f <= set(box)) and a in box and b in box:
            result.append(added.mean([a, b]))
    return result


def polygons_in_layers(rng, n=7, layers=2, shift=0, most=3):
    """Polyhedra over polygons with many different numbers of corners: squares with random points on
    their sides, at most so many. shift: of the corner that each face begins with."""
    added = Points([])

    def at(x, y, z):
        return added.at((float(x), float(y), float(z)))

    between = {}
    cells = []
    for i, j, k in np.ndindex(n, n, layers):
        square = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
        ring = []
        for a, b in zip(square, square[1:] + square[:1]):
            side = tuple(sorted((a, b)))
            if side not in between:
                between[side] = sorted(rng.random(rng.integers(0, most + 1)).round(3))
            a_to_b = between[side] if a < b else between[side][::-1]
            low, high = np.array(side, float)
            ring += [a, *(tuple(low + t * (high - low)) for t in a_to_b)]
        bottom, top = [[at(*p, z) for p in ring] for z in (k, k + 1)]
        m = len(ring)
        faces = [bottom[::-1], top]
        faces += [[bottom[s], bottom[(s + 1) % m], top[(s + 1) % m], top[s]] for s in range(m)]
        faces = [face[shift * s % len(face) :] + face[: shift * s % len(face)]
                 for s, face in enumerate(faces)]
        cells.append((VTK_POLYHEDRON, faces))
    return grid_of(bent(np.array(added.points), rng, 0.01), cells, rng)


def polyhedra_and_others(rng):
    """Cubes as polyhedra, hexahedra, inside out, and in a soup."""
    points, boxes = cubes((4, 3, 3))
    cells = []
    for i, box in enumerate(boxes):
        faces = box_faces(box)
        if i % 4 == 1:
            faces = [face[::-1] for face in faces]
        cells.append((VTK_POLYHEDRON, faces) if i % 4 < 3 else (c.VTK_HEXAHEDRON, box))
    for _ in range(10):  # of no closed surface
        ids = [int(i) for i in rng.permutation(len(points))]
        cells.append((VTK_POLYHEDRON, [ids[:3], ids[3:7], ids[2:8][::-1], ids[1:3]]))
    cells.append((VTK_POLYHEDRON, [ids[:4]]))
    return grid_of(bent(points, rng), cells, rng)


# --------------------------------------------------------------------------------------------------
# Nonlinear cells


def with_nodes(kind, corners, added):
    """The points of a nonlinear cell over these corners."""
    return [*corners, *(added.mean([corners[i] for i in host]) for host in NODES[kind][1])]


def nonlinear(rng, kind, n=(3, 3, 2)):
    """A mesh of one nonlinear type of dimension 3, with surface cells of dimension 2 on it."""
    points, boxes = cubes(n)
    added = Points(points)
    solids, faces = [], []
    for box in boxes:
        if NODES[kind][0] == 5:
            middle = added.mean(box)
            parts = [face[::-1] + [middle] for face in box_faces(box)]
        else:
            around = ((1, 2), (2, 3), (3, 7), (7, 4), (4, 5), (5, 1))
            parts = {
                4: [[0, a, b, 6] for a, b in around],
                6: [[0, 2, 1, 4, 6, 5], [0, 3, 2, 4, 7, 6]],
                8: [list(range(8))]}[NODES[kind][0]]
            parts = [[box[i] for i in part] for part in parts]
        solids += parts
        faces += [[part[i] for i in face] for part in parts for face in SURFACES[kind]]
    cells = [(kind, with_nodes(kind, part, added)) for part in solids]
    for i, face in enumerate(outer(faces)):
        of_face = {3: [c.VTK_QUADRATIC_TRIANGLE, BIQUADRATIC_TRIANGLE],
                   4: [c.VTK_QUADRATIC_QUAD, c.VTK_BIQUADRATIC_QUAD]}[len(face)]
        face_kind = of_face[int(kind in (29, 32, 37, 33))]
        if i % 5:
            cells.append((face_kind, with_nodes(face_kind, face, added)))
    cells.append((c.VTK_QUADRATIC_EDGE, with_nodes(c.VTK_QUADRATIC_EDGE, solids[0][:2], added)))
    return grid_of(bent(np.array(added.points), rng, 0.03), cells, rng)


# --------------------------------------------------------------------------------------------------
# Surfaces


def with_boundary(rng, n=(4, 3, 3), part=0.9):
    """Hexahedra with many of their faces at the boundary as quadrilaterals of several types."""
    points, boxes = cubes(n)
    cells = [(c.VTK_HEXAHEDRON, box) for box in boxes]
    faces = outer([face for box in boxes for face in box_faces(box)])
    for i, face in enumerate(faces):
        if rng.random() < part:
            turn = int(rng.integers(4)) if i % 3 == 0 else 0
            face = face[turn:] + face[:turn]
            if i % 7 == 0:
                cells.append((c.VTK_PIXEL, [face[j] for j in (0, 1, 3, 2)]))
            else:
                cells.append((c.VTK_QUAD if i % 5 else c.VTK_POLYGON, face[:: 1 if i % 4 else -1]))
    return grid_of(bent(points, rng), cells, rng)


def shells(rng, n=10):
    """Surfaces, lines and vertices; no cell has a volume."""
    points, boxes = cubes((n, n, 1))
    cells = []
    for i, box in enumerate(boxes):
        a, b, d, e = box[:4]
        choice = i // 15 % 5
        if choice == 0:
            cells += [(c.VTK_TRIANGLE, [a, b, d]), (c.VTK_TRIANGLE, [a, d, e])]
        elif choice == 1:
            cells.append((c.VTK_PIXEL, [a, b, e, d]))
        elif choice == 2:
            cells.append((c.VTK_POLYGON, [a, b, d, e]))
        else:
            cells.append((c.VTK_QUAD, [a, b, d, e]))
    row = np.arange(n + 1)
    strip = np.stack([2 * row + 1, 2 * row + 1 + 2 * (n + 1)], 1).ravel()
    cells += [(c.VTK_TRIANGLE_STRIP, strip), (c.VTK_POLY_LINE, 2 * row + 1),
              (c.VTK_LINE, [1, 3]), (c.VTK_VERTEX, [5]), (c.VTK_POLY_VERTEX, [7, 9, 11]),
              (c.VTK_QUADRATIC_LINEAR_QUAD, [1, 23, 25, 3, 45, 47])]
    return grid_of(bent(points, rng), cells, rng)


def quadratic_shell(rng, kind, n=6):
    """A surface of one nonlinear type."""
    points, boxes = cubes((n, n, 1))
    added = Points(points)
    cells = []
    for box in boxes:
        parts = [box[:4]] if NODES[kind][0] == 4 else [box[:3], [box[0], box[2], box[3]]]
        cells += [(kind, with_nodes(kind, part, added)) for part in parts]
    return grid_of(bent(np.array(added.points), rng), cells, rng)


# --------------------------------------------------------------------------------------------------
# Odd ones


def degenerate(rng):
    """Hexahedra that have corners twice, flat ones, and several at the same place."""
    points, boxes = cubes((4, 3, 3))
    cells = []
    for i, box in enumerate(boxes):
        box = list(box)
        if i % 3 == 0:
            box[7], box[3] = box[6], box[2]
        if i % 10 == 0:
            box[5:] = [box[4]] * 3
        cells.append((c.VTK_HEXAHEDRON, box))
    cells += cells[:5]
    points = bent(points, rng)
    points[20:25] = points[20]
    points[30:40, 2] = 0
    return grid_of(points, cells, rng)


def odd_places(rng):
    """Coordinates that are not finite, huge and tiny, and zeros with signs."""
    points, boxes = cubes((4, 4, 3))
    points = bent(points, rng)
    odd = [np.nan, np.inf, -np.inf, -0.0, 1e300, 1e-310, -1e-300]
    for i, value in enumerate(odd):
        points[7 * i, i % 3] = value
    return grid_of(points, [(c.VTK_HEXAHEDRON, box) for box in boxes], rng, np.float64)


def around_an_edge(rng, n=40):
    """Wedges around a common edge, more than a walk looks at, in several turns."""
    angles = np.linspace(0, 6 * np.pi, n + 1)
    ring = np.stack([np.cos(angles), np.sin(angles), angles / 9], 1)
    points = np.concatenate([[[0, 0, 0], [0, 0, 1]], ring, ring + [0, 0, 1]])
    cells = [(c.VTK_WEDGE, [0, 2 + i, 3 + i, 1, 3 + n + i, 4 + n + i]) for i in range(n)]
    return grid_of(points, cells, rng)


def cone(rng, n=90):
    """Pyramids and tetrahedra with a common top, over a fan: many open faces at one vertex."""
    points, boxes = cubes((int(n ** 0.5), int(n ** 0.5), 1))
    top = len(points)
    points = np.concatenate([bent(points, rng), [[4, 4, 30]]])
    cells = []
    for i in rng.permutation(len(boxes)):
        base = boxes[i][:4]
        if i % 3:
            cells.append((c.VTK_PYRAMID, [*base, top]))
        else:
            cells += [(c.VTK_TETRA, [base[0], base[1], base[2], top]),
                      (c.VTK_TETRA, [base[0], base[2], base[3], top])]
    return grid_of(points, cells, rng)


def holes(rng, n=(6, 6, 5), part=0.6):
    """Hexahedra with many left out, so that the front touches itself at edges and vertices."""
    points, boxes = cubes(n)
    cells = [(c.VTK_HEXAHEDRON, box) for box in boxes if rng.random() < part]
    return grid_of(bent(points, rng), cells, rng)


def holes_among_many(rng, kinds, n=(4, 3, 3), part=0.9):
    """Cubes that are a hexahedron, two wedges or six tetrahedra, up to twelve cells around an edge,
    with some of the cells left out."""
    points, boxes = cubes(n)
    cells = []
    for box in boxes:
        kind = kinds[int(rng.integers(len(kinds)))]
        if kind == c.VTK_WEDGE:
            parts = [(0, 2, 1, 4, 6, 5), (0, 3, 2, 4, 7, 6)]
        elif kind == c.VTK_TETRA:
            parts = [(0, a, b, 6) for a, b in ((1, 2), (2, 3), (3, 7), (7, 4), (4, 5), (5, 1))]
        else:
            parts = [range(8)]
        cells += [(kind, [box[i] for i in ids]) for ids in parts]
    cells = [cell for cell in cells if rng.random() < part]
    return grid_of(bent(points, rng), cells, rng)


def soup(rng, kinds, count=6, points=120):
    """Cells of these types at random points, with points twice, too; some points have no cell."""
    cells = []
    for i in range(count):
        for kind in kinds:
            size = {c.VTK_TRIANGLE_STRIP: 70, c.VTK_POLY_LINE: 90}.get(kind)
            if size is None:
                size = SIZES.get(kind, CURVED.get(kind, int(rng.integers(3, 9))))
            if kind == VTK_POLYHEDRON:
                ids = rng.permutation(points - 9)
                cells.append((kind, [ids[:4], ids[2:6], ids[4:8], ids[6:9], ids[:1]]))
            elif i % 3 == 0:
                first = 3 * i  # close to others
                cells.append((kind, [(first + j) % (points - 9) for j in range(size)]))
            else:
                cells.append((kind, rng.integers(0, points - 9, size)))
    return grid_of(rng.random((points, 3)), cells, rng)


def one_place(rng):
    """A few cells whose points are all at the same place."""
    points, boxes = cubes((2, 2, 2))
    return grid_of(0 * points + 0.5, [(c.VTK_HEXAHEDRON, box) for box in boxes], rng)


def other_corners(rng):
    """Polyhedra with points that none of their faces has, or with fewer; some are not closed, or
    have empty faces."""
    points, boxes = cubes((4, 3, 2))
    cells, faces, at = vtkCellArray(), [], []
    for i, box in enumerate(boxes):
        of_cell = box_faces(box)[i % 2 :]
        if i % 5 == 0:
            of_cell[1:1] = [[]]
        ids = list(dict.fromkeys(p for face in of_cell for p in face))
        ids = [ids, ids, [*ids, len(points) - 1 - i], ids[2:]][i % 4]
        cells.InsertNextCell(len(ids), ids)
        at.append(len(faces))
        faces += [len(of_cell), *(x for face in of_cell for x in (len(face), *face))]
    kinds = numpy_to_vtk(np.full(len(boxes), VTK_POLYHEDRON, np.uint8), deep=True)
    at, faces = [numpy_to_vtkIdTypeArray(np.array(x, np.int64), deep=True) for x in (at, faces)]
    grid = gm.make_grid(bent(points, rng), [])
    grid.SetCells(kinds, cells, at, faces)
    return with_arrays(grid, rng)


def middles(rng, n=(3, 2, 2), part=0.7, kind=c.VTK_TETRA):
    """Tetrahedra or pyramids with points in the middle of some edges, as polyhedra: these points
    have just two neighbors, both in the same two faces."""
    points, boxes = cubes(n)
    added = Points(points)
    if kind == c.VTK_TETRA:
        around = ((1, 2), (2, 3), (3, 7), (7, 4), (4, 5), (5, 1))
        solids = [[box[0], box[a], box[b], box[6]] for box in boxes for a, b in around]
    else:
        solids = [face[::-1] + [added.mean(box)] for box in boxes for face in box_faces(box)]
    surface = SURFACES[kind]
    edges = sorted({tuple(sorted((ids[a], ids[b]))) for ids in solids
                    for face in surface for a, b in zip(face, face[1:] + face[:1])})
    middle = {edge: added.mean(edge) for edge in edges if rng.random() < part}
    cells = []
    for solid in solids:
        faces = []
        for face in surface:
            ids = [solid[i] for i in face]
            more = []
            for a, b in zip(ids, ids[1:] + ids[:1]):
                more += [a, *[middle[e] for e in [tuple(sorted((a, b)))] if e in middle]]
            faces.append(more)
        cells.append((VTK_POLYHEDRON, faces))
    return grid_of(bent(np.array(added.points), rng, 0.03), cells, rng)


def comb(rng, teeth=28, length=14):
    """Pyramids with a common top over a spine with teeth on both sides that are not connected but
    at the spine: more open faces at a vertex than a walk looks at."""
    added = {}

    def at(x, y, tooth):
        return added.setdefault((x, y, 0 if abs(y - 0.5) < 1 else tooth), len(added) + 1)

    squares = []
    for x in range(teeth // 2):
        squares.append((x, 0, 0))
        for y in range(1, length):
            squares += [(x, y, x + 1), (x, -y, x + 1)]
    cells = []
    for x, y, tooth in squares:
        base = [at(x + i, y + j, tooth) for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))]
        cells.append((c.VTK_PYRAMID, [*base, 0]))
    points = np.array([(0, 0, 30)] + [(x + 0.01 * z, y, 0) for x, y, z in added], float)
    return grid_of(bent(points, rng, 0.1), cells, rng)


def torn(rng, n=(4, 4, 4)):
    """Hexahedra of which every other layer has points of its own, at nearly the same places."""
    points, boxes = cubes(n)
    count = len(points)
    cells = [(c.VTK_HEXAHEDRON, [p + count * (int(points[box[0]][0]) % 2) for p in box])
             for box in boxes]
    return grid_of(np.concatenate([bent(points, rng), bent(points, rng, 0.2)]), cells, rng)


def two_blocks(rng, n=4):
    """Tetrahedra and, apart from them, hexahedra and wedges."""
    points, tets = gm.lattice(n, dtype=float)
    other, boxes = cubes((n, n, n))
    count = len(points)
    cells = [(c.VTK_TETRA, tet) for tet in tets]
    for i, box in enumerate(boxes):
        box = [count + p for p in box]
        if i % 5:
            cells.append((c.VTK_HEXAHEDRON, box))
        else:
            cells += [(c.VTK_WEDGE, [box[j] for j in half])
                      for half in ((0, 2, 1, 4, 6, 5), (0, 3, 2, 4, 7, 6))]
    points = np.concatenate([points * n, bent(other, rng) + [2 * n, 0, 0]])
    return grid_of(points, cells, rng)
