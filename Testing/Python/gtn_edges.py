# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The front of a walk over surfaces: section 9.1 of Documentation/cell-codec.md, in which names are
the same.

Part of gtn_decoder, which is written from that text alone.
"""

import math
from collections import OrderedDict
from itertools import islice

import numpy as np

from gtn_front import normal_of
from gtn_records import mix
from gtn_vertices import F, clamp, cross, dot, minus

MOST_AROUND = 64
MOST_CELLS = 7
NO_LINK, AT_BORDER = 15, 16  # angles
GRIDS = 8

#: What a link may name instead of an edge or None.
BORDER = "border"


class Polygon:
    """What open edges know of the cell behind them: number of the cell, places of its corners in
    the order of the walk, type."""

    def __init__(self, cell, places, kind):
        self.cell, self.size, self.kind = cell, len(places), kind
        self.normal = normal_of(places)


class Edge:
    """An open edge, or one that was. before, after: links as they were set, see link()."""

    def __init__(self, begin, end, behind, frame):
        self.begin, self.end, self.behind, self.frame = begin, end, behind, frame
        self.past_begin = self.past_end = self.far_begin = self.far_end = None
        self.before = self.after = None
        self.is_open = True
        self.direction = None

    def link(self, ahead):
        """The link after the edge or the one before it: an edge, BORDER or None."""
        link = self.after if ahead else self.before
        return None if isinstance(link, Edge) and not link.is_open else link


def link(a, b):
    """Linking (a, b)."""
    if isinstance(a, Edge):
        a.after = b
    if isinstance(b, Edge):
        b.before = a


class EdgeFront:
    """The open edges, oldest first."""

    def __init__(self, places):
        self.places = places  # of all vertices that were met
        self.edges = OrderedDict()
        self.by_begin = {}  # edges that begin there, closed ones as well
        self.uses = {}  # number of open edges that begin or end at a vertex
        self.cells = {}  # number of polygons of the walk that have a vertex

    def oldest(self):
        return next(iter(self.edges), None)

    def open(self, edge):
        self.edges[edge] = True
        self.by_begin.setdefault(edge.begin, []).append(edge)
        self._use(edge, 1)

    def close(self, edge):
        edge.is_open = False
        del self.edges[edge]
        self._use(edge, -1)

    def _use(self, edge, change):
        for v in (edge.begin, edge.end):
            self.uses[v] = self.uses.get(v, 0) + change

    def has(self, vertex):
        """Whether an open edge begins or ends there."""
        return self.uses.get(vertex, 0) > 0

    def beginning_at(self, vertex):
        """The latest open edges that begin at a vertex, the latest first."""
        edges = [edge for edge in self.by_begin.get(vertex, ()) if edge.is_open]
        self.by_begin[vertex] = edges
        return list(islice(reversed(edges), MOST_AROUND))

    def direction(self, edge):
        if edge.direction is None:
            d = minus(self.places[edge.end], self.places[edge.begin])
            length = np.sqrt(dot(d, d))
            edge.direction = tuple(x / length for x in d) if length > 0 else (F(0), F(0), F(0))
        return edge.direction

    def angle(self, a, b, normal):
        """Of an edge and one that comes after it."""
        u, v = self.direction(a), self.direction(b)
        c = dot(u, v)
        if dot(cross(u, v), normal) > 0:
            x = (F(1) + c) * F(4) + F(0.5)
        else:
            x = F(8.5) + (F(1) - c) * F(3)
        return (math.floor(x) if x < 14 else 14) if x > 0 else 0


class End:
    """An end of an open edge. edge: that the link leads to, or None; vertex: where that one leads
    to, or None."""

    def __init__(self, front, edge, ahead):
        there = edge.link(ahead)
        self.edge, self.vertex, self.degree = None, None, 0
        self.angle = AT_BORDER if there is BORDER else NO_LINK
        if isinstance(there, Edge):
            self.edge = there
            self.vertex = there.end if ahead else there.begin
            self.degree = there.behind.size
            pair = (edge, there) if ahead else (there, edge)
            self.angle = front.angle(*pair, edge.behind.normal)
        here = edge.end if ahead else edge.begin
        self.cells = min(front.cells.get(here, 0), MOST_CELLS)


class Around:
    """Finds the vertices around a place."""

    def __init__(self, mesh):
        self.mesh = mesh
        vertices = mesh.chunk.own_points + len(mesh.shared_keys)
        self.bits = clamp(vertices.bit_length(), 4, 20)
        self.grids = [{} for _ in range(GRIDS)]
        self.added = 0

    @staticmethod
    def _cell(place, j):
        return tuple(math.floor(min(max(c, F(0)), F(255))) >> j for c in place)

    def _bucket(self, j, cell):
        return self.grids[j].setdefault(mix(self.bits, *cell), [])

    def _add_met(self):
        for vertex in range(self.added, len(self.mesh.places)):
            for j in range(GRIDS):
                self._bucket(j, self._cell(self.mesh.places[vertex], j)).append(vertex)
        self.added = len(self.mesh.places)

    def find(self, place, radius):
        """around(place, radius)."""
        self._add_met()
        j = next((j for j in range(GRIDS) if radius <= F(2.0 ** j / 2)), GRIDS - 1)
        r = min(radius, F(2.0 ** j / 2))
        low = self._cell([x - r for x in place], j)
        high = self._cell([x + r for x in place], j)
        found = set()
        for x in range(low[0], high[0] + 1):
            for y in range(low[1], high[1] + 1):
                for z in range(low[2], high[2] + 1):
                    found.update(self._bucket(j, (x, y, z))[-MOST_AROUND:])
        return found
