# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Cells of any order: their points and nodes, section 5.1 of Documentation/cell-codec.md, and the
records of nodes, section 7.1.

Part of gtn_decoder, which is written from that text alone.
"""

from functools import lru_cache
from itertools import product

CURVE, TRIANGLE, QUADRILATERAL, TETRAHEDRON, HEXAHEDRON, WEDGE = range(6)
FIRST_TYPES = (68, 75)
MAX_ORDER = 16


def corners_of(text):
    return [tuple(map(int, (corner + "00")[:3])) for corner in text.split(", ")]


def parts_of(text):
    return [tuple(map(int, part.split())) for part in text.split(", ")] if text else []


#: Corners, edges and faces.
SHAPES = {
    CURVE: ("0, 1", "0 1", ""),
    TRIANGLE: ("00, 10, 01", "0 1, 1 2, 2 0", "0 1 2"),
    QUADRILATERAL: ("00, 10, 11, 01", "0 1, 1 2, 3 2, 0 3", "0 1 2 3"),
    TETRAHEDRON: ("000, 100, 010, 001", "0 1, 1 2, 2 0, 0 3, 1 3, 2 3",
                  "0 1 3, 2 3 1, 0 3 2, 0 2 1"),
    HEXAHEDRON: ("000, 100, 110, 010, 001, 101, 111, 011",
                 "0 1, 1 2, 3 2, 0 3, 4 5, 5 6, 7 6, 4 7, 0 4, 1 5, 2 6, 3 7",
                 "0 3 7 4, 1 2 6 5, 0 1 5 4, 3 2 6 7, 0 1 2 3, 4 5 6 7"),
    WEDGE: ("000, 100, 010, 001, 101, 011", "0 1, 1 2, 2 0, 3 4, 4 5, 5 3, 0 3, 1 4, 2 5",
            "0 1 2, 3 4 5, 0 1 4 3, 1 2 5 4, 2 0 3 5")}
SHAPES = {shape: (corners_of(a), parts_of(b), parts_of(c)) for shape, (a, b, c) in SHAPES.items()}


def shape_of(kind):
    """The shape of cells of a type that have an order, else None."""
    for first in FIRST_TYPES:
        if first <= kind <= first + WEDGE:
            return kind - first
    return None


def count_points(shape, o):
    return {CURVE: o + 1, TRIANGLE: (o + 1) * (o + 2) // 2, QUADRILATERAL: (o + 1) ** 2,
            TETRAHEDRON: (o + 1) * (o + 2) * (o + 3) // 6, HEXAHEDRON: (o + 1) ** 3,
            WEDGE: (o + 1) ** 2 * (o + 2) // 2}[shape]


def order_of(kind, points):
    """The order of a cell with so many points, or None."""
    shape = shape_of(kind)
    for o in range(1, MAX_ORDER + 1):
        if shape is not None and count_points(shape, o) == points:
            return o
    return None


def at(shape, part, o, u, v=0):
    """A point of the lattice of an edge or a face, in that of the cell."""
    corners = SHAPES[shape][0]
    begin, right, up = corners[part[0]], corners[part[1]], corners[part[-1]]
    return tuple(o * b + u * (r - b) + v * (w - b) for b, r, w in zip(begin, right, up))


def inside_of_face(part, o):
    end = (lambda v: o - v) if len(part) == 3 else (lambda v: o)
    return [(u, v) for v in range(1, o) for u in range(1, end(v))]


def end_of_row(shape, o, j, k):
    return {TETRAHEDRON: o - j - k, WEDGE: o - j}.get(shape, o)


def inside_of_cell(shape, o):
    if shape < TETRAHEDRON:
        return []
    return [(i, j, k) for k, j in product(range(1, o), repeat=2)
            for i in range(1, end_of_row(shape, o, j, k))]


def points_of(shape, o):
    """The coordinates of all points in the order of their numbers."""
    if o <= 0:
        return [(0, 0, 0)] if o == 0 else []
    corners, edges, faces = SHAPES[shape]
    points = [tuple(o * x for x in corner) for corner in corners]
    points += [at(shape, edge, o, u) for edge in edges for u in range(1, o)]
    for face in faces:
        if shape in (TRIANGLE, TETRAHEDRON):
            inner = [(u + 1, v + 1) for u, v, _ in points_of(TRIANGLE, o - 3)]
        else:
            inner = inside_of_face(face, o)
        points += [at(shape, face, o, u, v) for u, v in inner]
    if shape == TETRAHEDRON:
        points += [tuple(x + 1 for x in point) for point in points_of(shape, o - 4)]
    else:
        points += inside_of_cell(shape, o)
    return points


class Node:
    """number: of the point in the cell; host: pairs of a corner and a weight; slots: points of the
    record by the names of its slots; between: whether the node is between its corners."""

    def __init__(self, number, host, slots, between=False):
        self.number, self.host, self.slots, self.between = number, host, slots, between
        self.kind = len(host) - 2 if host else 3


def plane_slots(get, u, v, end):
    """Those of a point in a plane of rows, get(u, v) gives its points."""
    slots = {"N1": get(u, v - 1), "N2": get(u - 1, v), "N3": get(end, v),
             "D12": get(u - 1, v - 1), "D13": get(end, v - 1)}
    if v > 1:
        slots["B1"] = get(u, v - 2)
    if u > 1:
        slots["B2"] = get(u - 2, v)
    return slots


@lru_cache(maxsize=None)
def nodes_of(shape, o):
    """The number of corners and the nodes in the order in which they are decoded."""
    number = {point: i for i, point in enumerate(points_of(shape, o))}
    corners, edges, faces = SHAPES[shape]
    nodes = []
    for edge in edges:
        get = lambda u, edge=edge: number[at(shape, edge, o, u)]
        for u in range(1, o):
            host = list(zip(edge, (o - u, u)))
            slots = {"N1": get(u - 1)}
            slots.update({"D12": edge[1]} if u == 1 else {"B1": get(u - 2)})
            nodes.append(Node(get(u), host, slots, u == 1))
    for face in faces:
        get = lambda u, v, face=face: number[at(shape, face, o, u, v)]
        for u, v in inside_of_face(face, o):
            if len(face) == 3:
                weights, end = (o - u - v, u, v), o - v
            else:
                weights, end = ((o - u) * (o - v), u * (o - v), u * v, (o - u) * v), o
            slots = plane_slots(get, u, v, end)
            if len(face) == 3:
                slots["D23"] = get(0, v + 1)
            nodes.append(Node(get(u, v), list(zip(face, weights)), slots))
    inside = inside_of_cell(shape, o)
    if shape == WEDGE:
        inside = sorted(((k, i, j) for i, j, k in inside), key=lambda point: point[::-1])
    for a, b, c in inside:
        def get(x, y, z):
            return number[(y, z, x) if shape == WEDGE else (x, y, z)]
        end = o - b - c if shape == TETRAHEDRON else o
        slots = plane_slots(lambda x, z, b=b, get=get: get(x, b, z), a, c, end)
        slots["D23"] = get(a, b - 1, c - 1)
        slots["B3"] = get(a, b - 1, c)
        nodes.append(Node(get(a, b, c), [], slots))
    return len(corners), nodes
