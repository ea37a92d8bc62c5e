# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Small surfaces of cells of dimension 2, for the independent decoder. Each function gives a grid
with arrays on points and cells."""

import numpy as np
from vtkmodules.util import vtkConstants as c

from gatunCellMeshes import (
    BIQUADRATIC_TRIANGLE, Points, bent, box_faces, cubes, grid_of, outer, with_nodes)
from gtn_records import mix

# --------------------------------------------------------------------------------------------------
# Lists of faces


def sheet(n, m):
    """Points and quadrilaterals of a part of a plane."""
    points = [(x, y, 0) for x in range(n + 1) for y in range(m + 1)]
    at = lambda x, y: x * (m + 1) + y
    quads = [[at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)]
             for x in range(n) for y in range(m)]
    return np.array(points, float), quads


def torus(n, m):
    u, v = [2 * np.pi * i.ravel() for i in np.meshgrid(
        np.arange(n) / n, np.arange(m) / m, indexing="ij")]
    r = 3 + np.cos(v)
    quads = [[x * m + y, (x + 1) % n * m + y, (x + 1) % n * m + (y + 1) % m, x * m + (y + 1) % m]
             for x in range(n) for y in range(m)]
    return np.stack([r * np.cos(u), r * np.sin(u), np.sin(v)], 1), quads


def band(n, m, twists):
    """A closed band, which is a Moebius strip if the number of half twists is odd."""
    def at(x, y):
        return x % n * (m + 1) + (m - y if x >= n and twists % 2 else y)

    points = []
    for x in range(n):
        u = 2 * np.pi * x / n
        for y in range(m + 1):
            w = y / m - 0.5
            r = 2 + w * np.cos(twists * u / 2)
            points.append((r * np.cos(u), r * np.sin(u), w * np.sin(twists * u / 2)))
    quads = [[at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)]
             for x in range(n) for y in range(m)]
    return np.array(points), quads


def halves(quads, rng=None):
    """Two triangles for each quadrilateral, by one diagonal or by any."""
    faces = []
    for a, b, d, e in quads:
        if rng is not None and rng.random() < 0.5:
            faces += [[a, b, e], [b, d, e]]
        else:
            faces += [[a, b, d], [a, d, e]]
    return faces


def thirds(faces, added):
    """A quadrilateral at each corner of each face."""
    quads = []
    for face in faces:
        middle = added.mean(face)
        sides = [added.mean(sorted([a, b])) for a, b in zip(face, face[1:] + face[:1])]
        quads += [[p, sides[i], middle, sides[i - 1]] for i, p in enumerate(face)]
    return quads


def dual(points, faces):
    """A polygon for each point that has faces all around it, with a corner in each face."""
    behind = {}
    for f, face in enumerate(faces):
        for i, p in enumerate(face):
            behind.setdefault(p, {})[face[i - 1]] = (face[(i + 1) % len(face)], f)
    polygons = []
    for around in behind.values():
        polygon, at = [], next(iter(around))
        while at in around and len(polygon) < len(around):
            at, f = around[at]
            polygon.append(f)
        if at == next(iter(around)):
            polygons.append(polygon[::-1])
    return np.array([points[face].mean(0) for face in faces]), polygons


def kind_of(face):
    return {3: c.VTK_TRIANGLE, 4: c.VTK_QUAD}.get(len(face), c.VTK_POLYGON)


def cells_of(faces):
    return [(kind_of(face), face) for face in faces]


def surface(points, faces, rng, jitter=0.05, dtype=np.float32):
    points = np.asarray(points, float)
    return grid_of(points + rng.uniform(-jitter, jitter, points.shape), cells_of(faces), rng, dtype)


# --------------------------------------------------------------------------------------------------
# Triangles, quadrilaterals, polygons


def triangles(rng, n=8):
    points, quads = sheet(n, n)
    return surface(bent(points, rng), halves(quads), rng)


def triangles_irregular(rng, n=9):
    points, quads = sheet(n, n)
    return surface(bent(points, rng), halves(quads, rng), rng, dtype=np.float64)


def triangles_closed(rng, n=12, m=7, in_turn=False):
    points, quads = torus(n, m)
    return surface(points, halves(quads, None if in_turn else rng), rng, 0.02)


def quads(rng, n=9):
    points, faces = sheet(n, n)
    return surface(bent(points, rng), faces, rng)


def quads_closed(rng, n=12, m=7):
    return surface(*torus(n, m), rng, 0.01)


def quads_irregular(rng, n=4):
    """Around points with three to eight quadrilaterals."""
    points, faces = sheet(n, n)
    added = Points(points)
    faces = thirds(halves(faces, rng), added)
    return surface(bent(np.array(added.points), rng, 0.02), faces, rng, 0.02)


def polygons(rng, n=9, is_closed=False):
    """With a corner in each triangle of an irregular surface."""
    points, faces = torus(n + 3, n) if is_closed else sheet(n, n)
    return surface(*dual(points, halves(faces, rng)), rng, 0.01)


def large_polygons(rng, columns=((300, 60, 3), (51, 3), (48, 3))):
    """Closed columns of rings with fewer and fewer points; the ends are polygons, and so are the
    faces between rings."""
    points, faces = [], []
    for column, sizes in enumerate(columns):
        below = []
        for j, n in enumerate(sizes):
            u = 2 * np.pi * np.arange(n) / n
            ring = list(range(len(points), len(points) + n))
            points += list(np.stack([np.cos(u) + 3 * column, np.sin(u), 0 * u + 0.5 * j], 1))
            step = len(below) // n
            for i in range(n) if below else ():
                low = [below[k % len(below)] for k in range(i * step, (i + 1) * step + 1)]
                faces.append([*low, ring[(i + 1) % n], ring[i]])
            faces += [] if below else [ring[::-1]]
            below = ring
        faces.append(below)
    return surface(points, faces, rng, 0.001)


def pixels(rng, n=(4, 3, 3)):
    """On all six sides of a box."""
    points, boxes = cubes(n)
    faces = outer([face for box in boxes for face in box_faces(box)])
    cells = [(c.VTK_PIXEL, [face[i] for i in (0, 1, 3, 2)]) for face in faces]
    return grid_of(points * [1, 0.5, 0.25], cells, rng)


def mixed(rng, n=9, is_closed=False):
    """Triangles, quadrilaterals and polygons, also of three and four corners, and pixels."""
    points, faces = torus(n + 2, n) if is_closed else sheet(n, n)
    cells = []
    for face in faces:
        choice = rng.integers(6)
        if choice == 0:
            cells.append((c.VTK_PIXEL, [face[i] for i in (0, 1, 3, 2)]))
        elif choice == 1:
            cells.append((c.VTK_POLYGON, face))
        elif choice == 2:
            cells.append((c.VTK_QUAD, face))
        else:
            kind = c.VTK_POLYGON if choice == 3 else c.VTK_TRIANGLE
            cells += [(kind, half) for half in halves([face], rng)]
    points = bent(points, rng, 0.05) if not is_closed else points
    return grid_of(points, cells, rng)


def nonlinear_mixed(rng, n=5):
    """All types with nodes; some share nodes, some have nodes of their own at the same place."""
    points, faces = sheet(n, n)
    added = Points(bent(points, rng))
    cells = []
    for face in faces:
        kind = [c.VTK_QUADRATIC_TRIANGLE, BIQUADRATIC_TRIANGLE, c.VTK_QUADRATIC_QUAD,
                c.VTK_BIQUADRATIC_QUAD, c.VTK_QUADRATIC_LINEAR_QUAD][rng.integers(5)]
        parts = [face] if kind in (23, 28, 30) else halves([face], rng)
        for part in parts:
            ids = with_nodes(kind, part, added)
            if rng.random() < 0.1:
                added.points.append(added.points[ids[-1]])
                ids[-1] = len(added.points) - 1
            cells.append((kind, ids))
    return grid_of(np.array(added.points), cells, rng)


def in_a_plane(rng, n=9):
    """Of exact coordinates."""
    points, faces = sheet(n, n)
    return grid_of(points, cells_of(halves(faces[: n * n // 2]) + faces[n * n // 2 :]), rng)


# --------------------------------------------------------------------------------------------------
# Surfaces that are no manifolds, or not oriented


def junctions(rng, sheets=3, n=6):
    """Several sheets at a common line."""
    points, faces = sheet(n, n)
    added = Points([])
    result = []
    for i in range(sheets):
        u = 2 * np.pi * i / sheets
        places = [(y, x * np.cos(u), x * np.sin(u)) for x, y, _ in points]
        ids = [added.at(p if p[1:] != (0, 0) else (p[0], 0.0, 0.0)) for p in places]
        parts = [faces, halves(faces), halves(faces, rng)][i % 3]
        result += [[ids[p] for p in face] for face in parts]
    return surface(np.array(added.points), result, rng)


def moebius(rng, n=14, m=3, twists=1):
    points, faces = band(n, m, twists)
    third = len(faces) // 3
    return surface(points, faces[:third] + halves(faces[third:], rng), rng, 0.02)


def turned(rng, n=8):
    """Cells that begin with any corner, in any direction and order; some are there twice, also with
    the same corners in another order."""
    points, faces = sheet(n, n)
    faces = faces[: n * n // 2] + halves(faces[n * n // 2 :], rng)
    faces += [faces[i] for i in rng.integers(0, len(faces), 12)]
    faces += [faces[i][::-1] for i in rng.integers(0, len(faces), 6)]
    result = []
    for i in rng.permutation(len(faces)):
        face, first = faces[i], int(rng.integers(len(faces[i])))
        face = face[first:] + face[:first]
        result.append(face[::-1] if rng.random() < 0.5 else face)
    return surface(bent(points, rng), result, rng)


def holes(rng, n=12, part=0.55):
    """With many faces left out, so that the front touches itself at vertices."""
    points, faces = sheet(n, n)
    faces = faces[: n * n // 2] + halves(faces[n * n // 2 :], rng)
    return surface(bent(points, rng), [face for face in faces if rng.random() < part], rng)


def cube_walls(rng, n=(3, 3, 3), part=0.7):
    """Walls between cubes: up to four at an edge, and twelve at a vertex."""
    points, boxes = cubes(n)
    walls = {frozenset(face): face for box in boxes for face in box_faces(box)}
    faces = [face for face in walls.values() if rng.random() < part]
    return surface(bent(points, rng), faces, rng)


def fan(rng, n=100):
    """A polygon with triangles on every other side that have a common corner, and others between
    any two of those: more open edges at a vertex than a walk looks at."""
    u = np.pi * np.arange(2 * n) / n
    points = np.concatenate([[[0, 0, 1]], np.stack([np.cos(u), np.sin(u), 0 * u], 1)])
    faces = [list(range(1, 2 * n + 1))]
    faces += [[0, 2 * i + 2, 2 * i + 1] for i in range(n)]
    faces += [[0, 2 * i + 1, 2 * int(j) + 2] for i, j in enumerate(rng.permutation(n)) if i != j]
    return surface(points, faces, rng, 0.001)


def book(rng, pages=80):
    """Triangles at a common side, more than a walk looks at."""
    angles = np.linspace(0, 2 * np.pi, pages, endpoint=False)
    points = [(0, 0, 0), (0, 0, 1)] + [(np.cos(u), np.sin(u), 0.5) for u in angles]
    faces = [[0, 1, 2 + i] if i % 3 else [1, 0, 2 + i] for i in range(pages)]
    return surface(points, faces, rng, 0.01)


def degenerate(rng, n=8):
    """Cells with corners twice, without an area, and at the same place."""
    points, faces = sheet(n, n)
    faces = faces[: n * n // 2] + halves(faces[n * n // 2 :], rng)
    for i in range(0, len(faces), 9):
        faces[i] = [*faces[i][:-1], faces[i][0]]
    points = bent(points, rng)
    points[20:24] = points[20]
    points[30:42, 1] = points[30, 1]
    points[30:42, 2] = 0
    return surface(points, faces, rng, 0)


def soup(rng, count=40, points=60, most=7):
    """Polygons of random points."""
    cells = []
    for _ in range(count):
        face = [int(p) for p in rng.permutation(points)[: rng.integers(3, most + 1)]]
        cells.append((c.VTK_POLYGON if rng.random() < 0.3 else kind_of(face), face))
    return grid_of(rng.random((points, 3)), cells, rng)


def tiny(rng, kind="tetrahedron"):
    """A few faces that are as large as the box."""
    faces = {"one": [[0, 1, 2]], "lens": [[0, 1, 2], [2, 1, 0]],
             "tetrahedron": [[0, 1, 3], [1, 2, 3], [2, 0, 3], [0, 2, 1]],
             "pillow": [[0, 1, 2, 3], [3, 2, 1, 0], [0, 1, 2]]}[kind]
    points = [(0, 0, 0), (1, 0, 0), (1, 1, 0.2), (0, 1, 1)][: 1 + max(map(max, faces))]
    return surface(points, faces, rng, 0)


def clustered(rng, n=14):
    """Closed surfaces that are as small as a cell of all grids, and a few large faces."""
    points, faces = torus(n, n)
    count = len(points)
    large, others = sheet(2, 2)
    faces = halves(faces, rng) + [[p + count for p in face] for face in others]
    points = np.concatenate([points / 20000 + 0.501, large])
    return surface(points, [*faces, [0, 1, count + 8]], rng, 0, np.float64)


def colliding(rng, fewer=0):
    """Four surfaces, each in a cell of the smallest grid, that are connected by long faces. Two and
    two are in one bucket together, or would be if their numbers had so many bits fewer."""
    points, faces = sheet(3, 3)
    points = points * 21845
    ring, quads = torus(10, 6)
    bits = (len(points) + 4 * len(ring)).bit_length() - fewer

    def together(n, one):
        """Two cells that are in one bucket of 2^n, but not in one of 2^(n + 1)."""
        others = ((x, y, 30) for x in range(10, 240) for y in range(10, 240))
        return one, next(cell for cell in others if mix(n, *cell) == mix(n, *one)
                         and mix(n + 1, *cell) != mix(n + 1, *one))

    for i, cell in enumerate((*together(bits, (10, 10, 10)), *together(bits, (20, 99, 10)))):
        first = len(points)
        points = np.concatenate([points, 25 * ring + 256 * np.array(cell) + 128])
        faces += halves([[p + first for p in quad] for quad in quads[1:]], rng)
        if i > 0:
            (a, b), (d, e) = quads[0][:2], quads[0][2:]
            faces.append([b + first, a + first, e + first - len(ring), d + first - len(ring)])
    return surface(points, faces, rng, 0, np.float64)


def one_place(rng):
    points, faces = sheet(3, 3)
    return surface(0 * points + 0.5, halves(faces), rng, 0)


def odd_places(rng, n=6):
    """Coordinates that are not finite, huge and tiny."""
    points, faces = sheet(n, n)
    points = bent(points, rng)
    for i, value in enumerate([np.nan, np.inf, -np.inf, -0.0, 1e300, 1e-310]):
        points[7 * i, i % 3] = value
    return surface(points, halves(faces, rng), rng, 0, np.float64)


# --------------------------------------------------------------------------------------------------
# Surfaces beside solids


def beside_solids(rng, n=(3, 3, 2), fins=4):
    """Hexahedra with faces at their boundary, some sheets that begin at their edges, and lines."""
    points, boxes = cubes(n)
    added = Points(points)
    cells = [(c.VTK_HEXAHEDRON, box) for box in boxes]
    faces = outer([face for box in boxes for face in box_faces(box)])
    cells += [(c.VTK_QUAD, face) for face in faces if rng.random() < 0.8]
    for y in range(n[1] + 1):
        at = lambda x, z, y=y: added.at((float(x), float(y), float(z)))
        for x in range(n[0]):
            for z in range(n[2], n[2] + fins):
                face = [at(x, z), at(x + 1, z), at(x + 1, z + 1), at(x, z + 1)]
                cells += cells_of([face] if y % 2 else halves([face], rng))
    cells += [(c.VTK_LINE, [0, 1]), (c.VTK_VERTEX, [5])]
    return grid_of(bent(np.array(added.points), rng), cells, rng)


def inside_solids(rng, n=(4, 3, 3)):
    """Hexahedra, and surfaces of triangles and quadrilaterals between them."""
    points, boxes = cubes(n)
    cells = [(c.VTK_HEXAHEDRON, box) for box in boxes]
    walls = {frozenset(face): face for box in boxes for face in box_faces(box)
             if all(points[p][0] == 2 or points[p][2] == 1 for p in face)}
    for face in walls.values():
        cells += cells_of([face] if rng.random() < 0.6 else halves([face], rng))
    return grid_of(bent(points, rng), cells, rng)
