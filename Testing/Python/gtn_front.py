# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The front of a walk over cells of any type: section 3 of Documentation/cell-codec.md.

Part of gtn_decoder, which is written from that text alone.
"""

import math
from collections import OrderedDict
from itertools import islice

import numpy as np

from gtn_vertices import F, cross, dot, minus

MOST_AROUND = 64
MOST_CELLS = 7
UNKNOWN_ANGLE = 16


class Side:
    """A side of a face, and its link: to another side, or to the border with a vertex or None."""

    def __init__(self, face, place):
        self.face, self.place = face, place
        self.there, self.border, self.cells = None, None, 0

    def begins(self):
        return self.face.corners[self.place]

    def ends(self):
        return self.face.corner(self.place + 1)

    def before(self):
        """The side before this one in the face."""
        return self.face.sides[self.place - 1]

    def leads_to(self):
        """The side of an open face that the link names, or None."""
        return self.there if self.there is not None and self.there.face.is_open else None


def join(a, b, cells):
    a.there, b.there = b, a
    a.border = b.border = None
    a.cells = b.cells = min(cells, MOST_CELLS)


def end(a, vertex, cells):
    a.there, a.border, a.cells = None, vertex, min(cells, MOST_CELLS)


class OpenFace:
    """An open face, or one that was.

    belows: a vertex or None of each corner; cell, form, number, kind, frame: of what is behind.
    """

    def __init__(self, corners, belows, cell, form, number, kind, frame):
        self.corners, self.belows = corners, belows
        self.cell, self.form, self.number, self.kind, self.frame = cell, form, number, kind, frame
        self.sides = [Side(self, i) for i in range(len(corners))]
        self.is_open = True
        self.normal = None

    def __len__(self):
        return len(self.corners)

    def corner(self, place):
        return self.corners[place % len(self.corners)]


def normal_of(places):
    """Of a face with corners at these places."""
    n = (F(0), F(0), F(0))
    for second, third in zip(places[1:], places[2:]):
        add = cross(minus(second, places[0]), minus(third, places[0]))
        n = (n[0] + add[0], n[1] + add[1], n[2] + add[2])
    length = np.sqrt(dot(n, n))
    if length > 0:
        return (n[0] / length, n[1] / length, n[2] / length)
    return (F(0), F(0), F(0))


class Front:
    """The open faces, oldest first."""

    def __init__(self, places):
        self.places = places  # of all vertices that were met
        self.faces = OrderedDict()
        self.by_vertex = {}  # sides that begin there, closed ones as well

    def oldest(self):
        return next(iter(self.faces), None)

    def open(self, face):
        self.faces[face] = True
        for side in face.sides:
            self.by_vertex.setdefault(side.begins(), []).append(side)

    def close(self, face):
        face.is_open = False
        del self.faces[face]

    def around(self, vertex):
        """The sides of open faces that begin at a vertex, the latest first."""
        sides = [side for side in self.by_vertex.get(vertex, ()) if side.face.is_open]
        self.by_vertex[vertex] = sides
        return list(islice(reversed(sides), MOST_AROUND))

    def normal(self, face):
        if face.normal is None:
            face.normal = normal_of([self.places[v] for v in face.corners])
        return face.normal

    def angle(self, s):
        """Of a side that leads to another one."""
        t = s.leads_to()
        n, m = self.normal(s.face), self.normal(t.face)
        if not dot(n, n) > F(0.5) or not dot(m, m) > F(0.5):
            return UNKNOWN_ANGLE
        cosine = dot(n, m)
        d = minus(self.places[t.face.corner(t.place + 2)], self.places[s.begins()])
        one, four = F(1), F(4)
        x = (one + cosine) * four if dot(d, n) > 0 else F(8) + (one - cosine) * four
        return (math.floor(x) if x < 15 else 15) if x > 0 else 0
