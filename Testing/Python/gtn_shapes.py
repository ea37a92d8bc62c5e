# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Shapes and forms of cells, and the nodes and edges of types of cells: sections 2, 5 and 6.1 of
Documentation/cell-codec.md.

Part of gtn_decoder, which is written from that text alone.
"""

from collections import deque
from functools import lru_cache

from gtn_bytes import Bytes, require

TETRA, POLYHEDRON = 10, 42
MAX_FACES = MAX_CORNERS = 255
MAX_FORMS = 4096
MAX_SIDES = 1 << 18


def faces_of(text):
    return [tuple(map(int, face.split())) for face in text.split(",")]


TETRAHEDRON = faces_of("0 1 3, 1 2 3, 2 0 3, 0 2 1")
PYRAMID = faces_of("0 3 2 1, 0 1 4, 1 2 4, 2 3 4, 3 0 4")
WEDGE = faces_of("0 1 2, 3 5 4, 0 3 4 1, 1 4 5 2, 2 5 3 0")
VOXEL = faces_of("0 4 6 2, 1 3 7 5, 0 1 5 4, 2 6 7 3, 0 2 3 1, 4 5 7 6")
HEXAHEDRON = faces_of("0 4 7 3, 1 2 6 5, 0 1 5 4, 3 7 6 2, 0 3 2 1, 4 5 6 7")
PENTAGONAL_PRISM = faces_of(
    "0 4 3 2 1, 5 6 7 8 9, 0 1 6 5, 1 2 7 6, 2 3 8 7, 3 4 9 8, 4 0 5 9")
HEXAGONAL_PRISM = faces_of(
    "0 5 4 3 2 1, 6 7 8 9 10 11, 0 1 7 6, 1 2 8 7, 2 3 9 8, 3 4 10 9, 4 5 11 10, 5 0 6 11")

#: The surface of each type that has one (2.1).
SURFACES = {
    10: TETRAHEDRON, 24: TETRAHEDRON, 71: TETRAHEDRON, 78: TETRAHEDRON, 14: PYRAMID, 27: PYRAMID, 37: PYRAMID,
    13: WEDGE, 26: WEDGE, 31: WEDGE, 32: WEDGE, 73: WEDGE, 80: WEDGE, 11: VOXEL, 12: HEXAHEDRON,
    25: HEXAHEDRON, 29: HEXAHEDRON, 33: HEXAHEDRON, 72: HEXAHEDRON, 79: HEXAHEDRON, 15: PENTAGONAL_PRISM, 16: HEXAGONAL_PRISM}

#: The surface of types that have one for their edges only (6.1), or for their tetrahedra.
OTHER_SURFACES = {
    55: TETRAHEDRON, 64: TETRAHEDRON, 65: WEDGE, 66: PYRAMID, 74: PYRAMID, 81: PYRAMID,
    56: HEXAHEDRON, 67: HEXAHEDRON}

#: The corners of the cycle of types of dimension 2 that do not have all of them in it (6.1).
CYCLES = {22: 3, 34: 3, 61: 3, 69: 3, 76: 3, 23: 4, 28: 4, 30: 4, 62: 4, 70: 4, 77: 4}
FLAT = {5, 7, 8, 9, 22, 23, 28, 30, 34, 36, 52, 53, 54, 61, 62, 63, 69, 70, 76, 77}
PIXEL, STRIP, QUADRATIC_POLYGON = 8, 6, 36


def make_nodes():
    """Number of corners and hosts of the nodes of each type that has nodes (section 5)."""
    nodes = {}

    def add(kind, corners, like, hosts):
        nodes[kind] = (corners, (nodes[like][1] if like else []) + (faces_of(hosts)))

    add(21, 2, None, "0 1")
    add(22, 3, None, "0 1, 1 2, 2 0")
    add(34, 3, 22, "0 1 2")
    add(23, 4, None, "0 1, 1 2, 2 3, 3 0")
    add(28, 4, 23, "0 1 2 3")
    add(30, 4, None, "0 1, 2 3")
    add(24, 4, None, "0 1, 1 2, 2 0, 0 3, 1 3, 2 3")
    add(25, 8, None, "0 1, 1 2, 2 3, 3 0, 4 5, 5 6, 6 7, 7 4, 0 4, 1 5, 2 6, 3 7")
    add(33, 8, 25, "0 4 7 3, 1 2 6 5, 0 1 5 4, 3 7 6 2")
    add(29, 8, 33, "0 1 2 3, 4 5 6 7, 0 2 5 7")
    add(31, 6, None, "0 1, 1 2, 2 0, 3 4, 4 5, 5 3")
    add(26, 6, 31, "0 3, 1 4, 2 5")
    add(32, 6, 26, "0 1 4 3, 1 2 5 4, 2 0 3 5")
    add(27, 5, None, "0 1, 1 2, 2 3, 3 0, 0 4, 1 4, 2 4, 3 4")
    add(37, 5, 27, "0 1 2 3, 0 1 4, 1 2 4, 2 3 4, 3 0 4, 0 2 4")
    return nodes


NODES = make_nodes()


def first_size(kind):
    """The number of points of a cell of this type before there was one (section 6)."""
    if kind not in SURFACES or kind > 37:
        return 0
    if kind in NODES:
        corners, hosts = NODES[kind]
        return corners + len(hosts)
    return corners_of(SURFACES[kind])


def corners_of(surface):
    return 1 + max(max(face) for face in surface)


# ----- Edges of cells (6.1)


@lru_cache(maxsize=None)
def outline(kind, size):
    """The faces of the surface of a cell with so many points, or its cycle, or nothing."""
    surface = SURFACES.get(kind) or OTHER_SURFACES.get(kind)
    if surface is not None:
        return tuple(surface) if size >= corners_of(surface) else ()
    if kind not in FLAT or size < 3:
        return ()
    m = min(size, CYCLES.get(kind, size // 2 if kind == QUADRATIC_POLYGON else size))
    return ((0, 1, 3, 2),) if kind == PIXEL and m == 4 else (tuple(range(m)),)


@lru_cache(maxsize=None)
def edges_of(kind, size):
    """The edges of a cell with so many points, as ascending pairs."""
    if size > 64:
        return edges_of(kind, 64) + tuple((i - 1, i) for i in range(64, size))
    faces = outline(kind, size)
    edges = {(min(a, b), max(a, b)) for face in faces for a, b in zip(face, face[1:] + face[:1])}
    m = corners_of(faces) if faces else 0
    for i in range(max(m, 1), size):
        edges.add((i - 1, i))
        if kind == STRIP and i >= 2:
            edges.add((i - 2, i))
    return tuple(sorted((a, b) for a, b in edges if a != b))


class Network:
    """How the corners of a cell or of a form are connected: its neighbors, and its quadrilaterals,
    for records (7.1)."""

    def __init__(self, corners, edges, quadrilaterals):
        self.neighbors = [[] for _ in range(corners)]
        for a, b in edges:
            self.neighbors[a].append(b)
            self.neighbors[b].append(a)
        for around in self.neighbors:
            around.sort()
        # Of each corner: the two beside it in a quadrilateral, and the opposite one.
        self.quadrilaterals = [[] for _ in range(corners)]
        for q in quadrilaterals:
            for i, c in enumerate(q):
                self.quadrilaterals[c].append((q[i - 1], q[(i + 1) % 4], q[(i + 2) % 4]))
        self.beyond = [self._find_beyond(c) for c in range(corners)]

    def _find_beyond(self, c):
        """The corner O of the record (7.1), known or not."""
        if len(self.neighbors[c]) != 3 or len(self.quadrilaterals[c]) != 3:
            return None
        first, second, third = [opposite for _, _, opposite in self.quadrilaterals[c]]
        for o in self.neighbors[first]:
            if (o not in self.neighbors[c] and o in self.neighbors[second]
                    and o in self.neighbors[third]):
                return o
        return None


@lru_cache(maxsize=None)
def network_of(kind, size):
    """Of a cell in a list."""
    quadrilaterals = [face for face in outline(kind, size) if len(face) == 4]
    return Network(size, edges_of(kind, size), quadrilaterals)


# ----- Surfaces and forms (2)


def directed(surface):
    """Face and place of a in it, for each pair (a, b) of neighboring corners."""
    result = {}
    for f, face in enumerate(surface):
        for p, a in enumerate(face):
            pair = (a, face[(p + 1) % len(face)])
            require(pair not in result, "surface with a pair of corners twice")
            result[pair] = (f, p)
    return result


def check_closed(surface):
    """Of a surface whose faces were reached from each other; corners are 0, 1, ..."""
    require(len(surface) <= MAX_FACES, "surface with too many faces")
    corners = {c for face in surface for c in face}
    require(len(corners) <= MAX_CORNERS and corners == set(range(len(corners))), "corners")
    require(all(len(face) >= 3 and len(set(face)) == len(face) for face in surface), "face")
    pairs = directed(surface)
    require(all((b, a) in pairs for a, b in pairs), "surface that is not closed")


def turned(face, first):
    return tuple(face[first:]) + tuple(face[:first])


class View:
    """A surface seen from a gate, which begins with the corner at a place (2).

    faces: of the form; corners: the surface's corner for each one of the form; placed: for each
    face of the form the surface's face, and the place in it of the corner that is first.
    """

    def __init__(self, surface, gate, start):
        at = directed(surface)
        k = len(surface[gate])
        self.corners = [surface[gate][(start - i) % k] for i in range(k)]
        number = {corner: i for i, corner in enumerate(self.corners)}
        self.faces, self.placed = [tuple(range(k))], [(gate, start)]
        met = {gate}
        queue = deque((self.corners[i], self.corners[(i + 1) % k]) for i in range(k))
        while queue:
            f, p = at[queue.popleft()]
            if f in met:
                continue
            met.add(f)
            cycle = turned(surface[f], p)
            for corner in cycle:
                if corner not in number:
                    number[corner] = len(self.corners)
                    self.corners.append(corner)
            queue.extend((b, a) for a, b in zip(cycle, cycle[1:] + cycle[:1]))
            self.faces.append(tuple(number[corner] for corner in cycle))
            self.placed.append((f, p))
        self.is_whole = len(met) == len(surface)

    def code(self):
        return code_of(self.faces)


def code_of(faces):
    """The code of the form with these faces."""
    code = [len(faces[0])]
    for face in faces[1:]:
        code += [len(face), *face[2:]]
    return bytes(code)


def surface_of(faces):
    """All faces of a form counterclockwise."""
    return [faces[0][::-1], *faces[1:]]


def decode_code(code):
    """The faces of the form with this code."""
    code = Bytes(code)
    k = code.number("B")
    require(k >= 3, "gate")
    faces = [tuple(range(k))]
    corners = k
    has_face = {((i + 1) % k, i) for i in range(k)}
    queue = deque((i, (i + 1) % k) for i in range(k))
    while queue:
        a, b = queue.popleft()
        if (a, b) in has_face:
            continue
        size = code.number("B")
        require(size >= 3, "face")
        face = [a, b]
        for _ in range(size - 2):
            face.append(code.number("B"))
            require(face[-1] <= corners, "corner")
            corners = max(corners, face[-1] + 1)
        faces.append(tuple(face))
        pairs = list(zip(face, face[1:] + face[:1]))
        has_face.update(pairs)
        queue.extend((b, a) for a, b in pairs)
    code.end()
    check_closed(surface_of(faces))
    return faces


class Form:
    """A form, by its faces, with all that follows from them.

    number: in the table, or that of inline forms; shape: likewise. Sides are pairs of a face and a
    place in it; edges are pairs of twins.
    """

    def __init__(self, faces, number, shape):
        self.faces, self.number, self.shape = faces, number, shape
        self.code = code_of(faces)
        self.corners = 1 + max(max(face) for face in faces)
        by_edge = {}  # in the order of the smaller sides
        for f, face in enumerate(faces):
            for p, a in enumerate(face):
                edge = frozenset((a, face[(p + 1) % len(face)]))
                by_edge.setdefault(edge, []).append((f, p))
        self.edges = [tuple(sides) for sides in by_edge.values()]
        self.twins = {}
        for s, t in self.edges:
            self.twins[s], self.twins[t] = t, s
        self.network = Network(
            self.corners, [tuple(edge) for edge in by_edge],
            [face for face in faces if len(face) == 4])
        sizes = sorted(map(len, faces))
        families = [[3] * 4, [3] * 4 + [4], [3] * 2 + [4] * 3, [4] * 6]
        self.family = families.index(sizes) if sizes in families else 4

    def ends(self, side):
        f, p = side
        face = self.faces[f]
        return face[p], face[(p + 1) % len(face)]

    def below(self, face, corner):
        """The corner below a corner of a face, or None."""
        outside = [c for c in self.network.neighbors[corner] if c not in self.faces[face]]
        return outside[0] if len(outside) == 1 else None


class Shapes:
    """The table of shapes and its forms."""

    def __init__(self, data):
        self.forms = []
        self.by_code = {}
        sides = 0
        data = Bytes(data)
        codes = [data.raw_string() for _ in range(data.varint())]
        data.end()
        for shape, code in enumerate(codes):
            surface = surface_of(decode_code(code))
            of_shape = {}
            for f, face in enumerate(surface):
                for start in range(len(face)):
                    view = View(surface, f, start)
                    of_shape[view.code()] = view.faces
                require(len(self.forms) + len(of_shape) <= MAX_FORMS, "too many forms")
            sides += len(of_shape) * sum(map(len, surface))
            require(sides <= MAX_SIDES, "too many sides of forms")
            for code in sorted(of_shape, key=lambda code: (len(code), code)):
                require(code not in self.by_code, "a form of two shapes")
                form = Form(of_shape[code], len(self.forms), shape)
                self.by_code[code] = form
                self.forms.append(form)


@lru_cache(maxsize=None)
def view_of_type(kind, frame):
    """The view that a frame of a type stands for (2.1), or None."""
    surface = SURFACES.get(kind)
    if surface is None:
        return None
    mirrored, start, f = frame & 1, frame >> 1 & 7, frame >> 4
    if f >= len(surface) or start >= len(surface[f]):
        return None
    if not mirrored:
        return View(surface, f, start)
    view = View([face[::-1] for face in surface], f, len(surface[f]) - 1 - start)
    view.placed = [(g, len(surface[g]) - 1 - p) for g, p in view.placed]
    return view
