# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Chunks of cells of any type: sections 1 and 8 of Documentation/cell-codec.md, and the tetrahedra
of cells, section 15.3 of Documentation/format.md.

Part of gtn_decoder, which is written from that text alone.
"""

import numpy as np

from gtn_bytes import Bytes, require
from gtn_cell_list import CellList
from gtn_grow import CellWalk
from gtn_hull import hull_faces
from gtn_nodes import Nodes, decode_marks
from gtn_records import CellCoded
from gtn_shapes import (
    OTHER_SURFACES, POLYHEDRON, SURFACES, TETRA, TETRAHEDRON, corners_of)
from gtn_surface import SurfaceWalk
from gtn_vertices import Vertices

CONVEX_POINT_SET = 41

WALK, MARKS, POLYGONS, HEXAHEDRA, UNIFORM = 1, 2, 4, 8, 16

#: The code of the form of all cells of a walk over hexahedra.
HEXAHEDRON = bytes([4, 4, 4, 5, 4, 6, 4, 4, 7, 6, 4, 5, 7, 4, 6, 7])

#: E(r) of section 4 of format.md.
TURNS = [
    (0, 1, 2, 3), (0, 2, 3, 1), (0, 3, 1, 2), (1, 0, 3, 2),
    (1, 3, 2, 0), (1, 2, 0, 3), (2, 3, 0, 1), (2, 0, 1, 3),
    (2, 1, 3, 0), (3, 2, 1, 0), (3, 1, 0, 2), (3, 0, 2, 1)]


class CellMesh(Vertices):
    """Decodes a chunk of cells. What it gives, besides its vertices:

    kinds        types of the cells
    corners      vertices of each cell
    faces        of each polyhedron, a list of vertices each, else None
    parents      of the cells, or None
    flags        of the stream
    """

    def __init__(self, chunk, stream, geometry, domains, shared_keys, shared_users, shapes):
        """chunk: its entry in TABL, with those of CELL; shapes: the file's (Shapes)."""
        counts = chunk.cells
        points = chunk.own_points + len(shared_keys)
        require(points <= counts.corners + counts.face_values, "points of a chunk")
        stream = Bytes(stream)
        self.flags = flags = stream.number("B")
        require(flags < 32, "flags of a chunk of cells")
        require(flags & WALK or not flags & (MARKS | HEXAHEDRA), "flags of no walk")
        require(flags & POLYGONS or not flags & UNIFORM, "flags of no walk over surfaces")
        self.coded = CellCoded(stream)
        super().__init__(chunk, geometry, domains, shared_keys, shared_users)
        self.counts, self.shapes = counts, shapes
        self.nodes = Nodes(self)
        self.kinds, self.corners, self.faces, self.parents = [], [], [], []
        self._corners = self._face_values = 0
        with np.errstate(all="ignore"):
            if flags & WALK:
                only = None
                if flags & HEXAHEDRA:
                    only = shapes.by_code.get(HEXAHEDRON)
                    require(only is not None, "walk over hexahedra without their form")
                walk = CellWalk(self, only)
            if flags & MARKS:
                decode_marks(self, walk)
            if flags & POLYGONS:
                SurfaceWalk(self, bool(flags & UNIFORM))
            CellList(self)
        require(self.corners_left() == 0 and self.face_values_left() == 0, "number of corners")
        require(self.kinds.count(POLYHEDRON) == counts.polyhedra, "number of polyhedra")
        self.check_all_met()

    def cells_made(self):
        return len(self.kinds)

    def cells_left(self):
        return self.counts.cells - len(self.kinds)

    def corners_left(self):
        return self.counts.corners - self._corners

    def face_values_left(self):
        return self.counts.face_values - self._face_values

    def make_cell(self, kind, corners, faces, parent):
        """A cell whose nodes, if it has some, are decoded now."""
        self.add_cell(kind, self.nodes.of_type(kind, corners), faces, parent)

    def add_cell(self, kind, corners, faces, parent):
        self.kinds.append(kind)
        self.corners.append(corners)
        self.faces.append(faces)
        self.parents.append(parent)
        self._corners += len(corners)
        self._face_values += sum(1 + len(face) for face in faces or ())
        require(self.corners_left() >= 0 and self.face_values_left() >= 0, "too many corners")

    def name_near(self, place, limit, models):
        """The index of a shared vertex around a place (section 1)."""
        hits = self.search(place, limit, lambda _, distance: distance)
        for i, (_, index) in enumerate(hits):
            if self.coded.decide(models, i):
                return index
        return self.coded.index(len(self.shared_keys))

    def original_corners(self, stream):
        """Corners and faces of all cells as they were in the input (8)."""
        if stream is None:
            return self.corners, self.faces
        return OriginalCorners(self, stream).result()


class OriginalCorners:
    def __init__(self, mesh, stream):
        self.mesh = mesh
        self.coded = CellCoded(Bytes(stream))
        self.e = {"corners": 1, "faces": 1}

    def result(self):
        corners, faces = list(self.mesh.corners), list(self.mesh.faces)
        r = 0
        for i, kind in enumerate(self.mesh.kinds):
            if kind == TETRA and len(corners[i]) == 4:
                r = self.coded.tree(4, "Rotation", r)
                require(r < 12, "rotation of a tetrahedron")
                corners[i] = [corners[i][k] for k in TURNS[r]]
            elif kind == POLYHEDRON:
                corners[i] = [corners[i][k] for k in self._permutation("corners", len(corners[i]))]
                order = self._permutation("faces", len(faces[i]))
                faces[i] = [self._turned(faces[i][k]) for k in order]
        return corners, faces

    def _permutation(self, which, n):
        following = 0
        result = []
        for _ in range(n):
            e = self.e[which] = self.coded.decide("IsNext", which, self.e[which])
            old = following if e else self.coded.index(n)
            require(old < n and old not in result, "no permutation")
            result.append(old)
            following = old + 1
        return result

    def _turned(self, face):
        first = 0
        if len(face) > 1 and self.coded.decide("Turned"):
            first = self.coded.index(len(face))
        return face[first:] + face[:first]


# ----- Tetrahedra of cells (15.3 of format.md)


def faces_of_cell(kind, corners, faces, place):
    """The faces by which a cell is divided."""
    if kind == POLYHEDRON:
        return faces
    if kind == CONVEX_POINT_SET:
        return [[corners[c] for c in face] for face in hull_faces([place(v) for v in corners])]
    surface = SURFACES.get(kind) or OTHER_SURFACES.get(kind)
    if surface is None or len(corners) < corners_of(surface):
        return []
    return [[corners[c] for c in face] for face in surface]


def split(kind, corners, faces, order, place):
    """The tetrahedra of a cell. order: of points by their coordinates, plain keys; place: the
    coordinates of a point."""
    surface = SURFACES.get(kind) or OTHER_SURFACES.get(kind)
    if surface is TETRAHEDRON:
        return [tuple(corners[:4])] if len(corners) >= 4 else []
    faces = faces_of_cell(kind, corners, faces, place)
    shells = [0] * len(faces)
    if kind == POLYHEDRON:
        faces, shells = align(faces)
    points = [p for face in faces for p in face]
    if not points:
        return []
    apex = min(points, key=order)  # the first one of the least
    tets = []
    volumes = [0.0] * (1 + max(shells))
    for face, shell in zip(faces, shells):
        if apex in face or len(face) < 3:
            continue
        first = min(range(len(face)), key=lambda i: order(face[i]))
        face = face[first:] + face[:first]
        for q, r in zip(face[1:], face[2:]):
            if len({apex, face[0], q, r}) == 4:
                tets.append((shell, (apex, face[0], q, r)))
                volumes[shell] += sixfold_volume(*(place(v) for v in tets[-1][1]))
    return [(a, b, d, c) if volumes[shell] < 0 else (a, b, c, d) for shell, (a, b, c, d) in tets]


def align(faces):
    """The faces of a polyhedron, those of each shell in the same direction, and their shells."""
    sides = {}
    for f, face in enumerate(faces):
        for a, b in zip(face, face[1:] + face[:1]):
            sides.setdefault(frozenset((a, b)), []).append((f, a))
    shells = [None] * len(faces)
    turned = [False] * len(faces)
    for start in range(len(faces)):
        if shells[start] is not None:
            continue
        shells[start] = max((s for s in shells if s is not None), default=-1) + 1
        reached = [start]
        for f in reached:
            for a, b in zip(faces[f], faces[f][1:] + faces[f][:1]):
                users = sides[frozenset((a, b))]
                if len(users) != 2:
                    continue
                for g, first in users:
                    if shells[g] is None:
                        shells[g] = shells[start]
                        turned[g] = turned[f] != (first == a)
                        reached.append(g)
    return [face[::-1] if turn else face for face, turn in zip(faces, turned)], shells


def sixfold_volume(apex, *others):
    a, b, c = (tuple(float(x) - float(y) for x, y in zip(other, apex)) for other in others)
    x = b[1] * c[2] - b[2] * c[1]
    y = b[2] * c[0] - b[0] * c[2]
    z = b[0] * c[1] - b[1] * c[0]
    return a[0] * x + a[1] * y + a[2] * z
