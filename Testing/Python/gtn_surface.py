# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The walk over surfaces: sections 9.2 to 9.5 of Documentation/cell-codec.md, in which names are
the same.

Part of gtn_decoder, which is written from that text alone.
"""

import numpy as np

from gtn_bytes import require
from gtn_edges import BORDER, Around, Edge, EdgeFront, End, Polygon, link
from gtn_nodes import flat_corners
from gtn_records import B1, B2, B3, D12, D13, D23, N1, N2, SLOTS, CellRecord, O, mix, predicted
from gtn_vertices import F, clamp, minus, square

MOST_CORNERS = 32767
TRIANGLE = 5  # a type
MODELS = "surface"  # before the names of all models


def kind_of(n):
    return clamp(n, 3, 5)


def linked(end):
    return 0 if end is None or end.degree == 0 else kind_of(end.degree) - 2


def grade(end):
    if end is None or end.angle >= 15:
        return 4
    return 0 if end.angle < 4 else 1 if end.angle == 4 else 2 if end.angle < 8 else 3


class Step:
    """A polygon that is being made: the vertices of its corners, or None, and the edges that are
    glued to its sides, or None. met: number of vertices that were met before."""

    def __init__(self, k, gate, met):
        self.k, self.gate, self.met = k, gate, met
        self.corners, self.glued = [None] * k, [None] * k
        self.opened = [None] * k
        self.vertices = set()
        if gate is not None:
            self.put(0, gate.begin)
            self.put(1, gate.end)
            self.glued[0] = gate

    def put(self, corner, vertex):
        require(vertex not in self.vertices, "cell with a vertex twice")
        self.vertices.add(vertex)
        self.corners[corner] = vertex

    def corner(self, c):
        return self.corners[c % self.k]

    def glued_to(self, side):
        return self.glued[side % self.k]

    def record(self, c, a=None, b=None):
        """The record of a corner (9.4), with A and B of 9.3."""
        k, gate = self.k, self.gate
        slots = [None] * SLOTS
        known = []
        for neighbor in sorted(((c - 1) % k, (c + 1) % k)):
            if self.corners[neighbor] is None:
                continue
            if neighbor == (c - 1) % k:
                edge = self.glued_to(c - 2)
                below = None if edge is None else edge.past_end
            else:
                edge = self.glued_to(c + 1)
                below = None if edge is None else edge.past_begin
            known.append((self.corners[neighbor], below))
        for i, (vertex, below) in enumerate(known):
            slots[N1 + i], slots[B1 + i] = vertex, below
        if k == 3 and slots[B1] == slots[B2]:
            slots[D12] = slots[B1]
            slots[B1] = slots[B2] = None
        elif k == 4 if slots[N2] is not None else slots[B1] is not None:
            slots[D12] = self.corner(c - 2)
        if gate is not None:
            slots[D13], slots[D23] = b, a
            if c == 2:
                slots[O] = gate.far_end
                slots[B3] = gate.far_begin if k == 3 else gate.past_begin
            elif c == k - 1:
                slots[O], slots[B3] = gate.far_begin, gate.past_end
        return CellRecord(slots)


class SurfaceWalk:
    """Makes cells in a mesh (CellMesh)."""

    def __init__(self, mesh, uniform):
        self.mesh, self.coded, self.uniform = mesh, mesh.coded, uniform
        self.front = EdgeFront(mesh.places)
        self.around = Around(mesh)
        self.first_met = len(mesh.keys)
        while mesh.cells_left() > 0:
            gate = self.front.oldest()
            if gate is not None:
                self.grow(gate)
            elif self.decide("MoreSeeds"):
                self.seed()
            else:
                break

    def decide(self, *model):
        return self.coded.decide(MODELS, *model)

    # ----- Seeds and gates (9.2)

    def seed(self):
        mesh = self.mesh
        step = Step(self.size(0, None, None), None, len(mesh.keys))
        for c in range(step.k):
            if not self.decide("SeedNew"):
                step.put(c, self.coded.index(len(mesh.keys)))
            elif self.decide("SeedShared"):
                step.put(c, mesh.meet_shared(self.coded.index(len(mesh.shared_keys))))
            else:
                step.put(c, mesh.meet_own(step.record(c)))
        self.finish(step)

    def grow(self, gate):
        mesh, front = self.mesh, self.front
        p = gate.behind.size
        back, ahead = End(front, gate, False), End(front, gate, True)
        seen = mesh.users[gate.begin] & mesh.users[gate.end] != 0
        if self.decide("Interface" if seen else "Border", kind_of(p), back.angle, ahead.angle):
            before, after = gate.link(False), gate.link(True)
            front.close(gate)
            link(before, BORDER)
            link(BORDER, after)
            return
        step = Step(self.size(p, back, ahead), gate, len(mesh.keys))
        self.other_corners(step, back, ahead)
        self.finish(step)

    def size(self, p, back, ahead):
        where = (kind_of(p), linked(back), linked(ahead), grade(back), grade(ahead))
        if self.uniform or self.decide("IsTriangle", *where):
            k = 3
        elif self.decide("IsQuad", *where):
            k = 4
        else:
            k = 5 + self.coded.tree(4, MODELS, "Size", min(p, 15))
            if k == 20:
                k = self.coded.large(MODELS, "LargeSize")
        require(3 <= k <= min(MOST_CORNERS, self.mesh.corners_left()), "size of a polygon")
        return k

    # ----- Corners (9.3)

    def other_corners(self, step, back, ahead):
        low, high = 1, step.k
        while low + 1 < high and self.follows(step, ahead, back, low > 1):
            step.put(low + 1, ahead.vertex)
            step.glued[low] = ahead.edge
            ahead = End(self.front, ahead.edge, True)
            low += 1
        while low + 1 < high and self.follows(step, back, ahead, high < step.k):
            step.put(high - 1, back.vertex)
            step.glued[high - 1] = back.edge
            back = End(self.front, back.edge, False)
            high -= 1

        def beyond(end):
            is_near = end.angle < 8 and end.vertex not in step.vertices
            return end.vertex if is_near else None

        for c in range(low + 1, high):
            a = beyond(ahead) if c == low + 1 else None
            b = beyond(back) if c == high - 1 else None
            ends = int(low > 1) + 2 * int(high < step.k)
            step.put(c, self.other_corner(step, c, ends, a, b))

    def follows(self, step, end, other, further):
        if end.angle >= 15 or end.vertex in step.vertices:
            return 0
        return self.decide(
            "IsNext", kind_of(step.k), int(further), end.angle, end.cells, grade(other))

    def other_corner(self, step, c, ends, a, b):
        mesh, decide = self.mesh, self.decide
        record = step.record(c, a, b)
        place = predicted(record, mesh.places)
        e = square(minus(place, mesh.places[record.slots[N1]]))
        if decide("New", kind_of(step.k), ends):
            if decide("Shared", self.shared_among(step.corners[:2]), self.shared_among((a, b))):
                index = mesh.name_near(place, F(4) * e, (MODELS, "SharedRank"))
                return mesh.meet_shared(index)
            return mesh.meet_own(record)
        lists = self.candidates(step, place, F(8) * e)
        f = decide("OnFront")
        if decide("Listed", f):
            chosen = lists[0] if f else lists[1]
            for i, (_, v) in enumerate(chosen[:15]):
                if decide("Rank", f, min(i, 5)):
                    return v
            require(False, "no candidate was chosen")
        return self.coded.index(len(mesh.keys))

    def shared_among(self, vertices):
        return sum(v is not None and self.mesh.users[v] != 0 for v in vertices)

    def candidates(self, step, place, limit):
        """Pairs of a squared distance and a vertex, ascending: on the front, and others."""
        lists = [], []
        for v in self.around.find(place, np.sqrt(limit)):
            distance = square(minus(self.mesh.places[v], place))
            if distance < limit and v not in step.vertices:
                lists[0 if self.front.has(v) else 1].append((distance, v))
        return sorted(lists[0]), sorted(lists[1])

    # ----- The end of a step (9.5)

    def finish(self, step):
        mesh, gate = self.mesh, step.gate
        cell = mesh.cells_made()
        kind, turn = self.type_and_turn(step)
        parent = None if gate is None else gate.behind.cell
        mesh.make_cell(kind, flat_corners(kind, turn, step.corners), None, parent)
        if gate is not None:
            self.glue(step)
        for edge in step.glued:
            if edge is not None:
                self.front.close(edge)
        behind = Polygon(cell, [mesh.places[v] for v in step.corners], kind)
        self.open_edges(step, behind, turn)
        for i in range(step.k):
            self.link_at(step, i, (i + 1) % step.k)
        for v in step.corners:
            self.front.cells[v] = self.front.cells.get(v, 0) + 1

    def type_and_turn(self, step):
        if self.uniform:
            return TRIANGLE, 0
        coded, k, gate = self.coded, step.k, step.gate
        p, parent_kind, parent_frame = 0, 0, 0
        if gate is not None:
            p, parent_kind, parent_frame = gate.behind.size, gate.behind.kind, gate.frame
        memory = (MODELS, "Types", mix(8, min(k, 5), parent_kind, 1))
        kind = coded.remembered(memory, 8, MODELS, "TypeTree")
        if k <= 4:
            lengths = [square(minus(self.mesh.places[step.corner(i + 1)], self.mesh.places[v]))
                       for i, v in enumerate(step.corners)]
            s = lengths.index(max(lengths))
            turn = coded.tree(3, MODELS, "Turns", mix(10, kind, p + 32 * s, parent_frame))
        else:
            memory = (MODELS, "LongTurns", mix(10, k, p, parent_frame))
            turn = coded.last(memory)
            if turn is None:
                turn = coded.index(2 * k)
            coded.keep(memory, turn)
        return kind, turn

    def glue(self, step):
        """Glues further edges of the front to sides."""
        for i, begin in enumerate(step.corners):
            end = step.corner(i + 1)
            if step.glued[i] is None and begin < step.met and end < step.met:
                found = (edge for edge in self.front.beginning_at(begin) if edge.end == end)
                step.glued[i] = next(found, None)

    def open_edges(self, step, behind, turn):
        k, r = step.k, turn // 2
        for i, end in enumerate(step.corners):
            if step.glued[i] is not None:
                continue
            begin = step.corner(i + 1)
            frame = 2 * ((r - i) % k) + 1 if turn % 2 else 2 * ((i - r) % k)
            edge = Edge(begin, end, behind, frame)
            edge.past_begin, edge.past_end = step.corner(i + 2), step.corner(i - 1)
            before, after = step.glued_to(i + 2), step.glued_to(i - 2)
            edge.far_begin = None if before is None else before.past_begin
            edge.far_end = None if after is None else after.past_end
            self.front.open(edge)
            step.opened[i] = edge
            if max(begin, end) >= self.first_met:
                self.mesh.edge_log.append((end, begin))

    def link_at(self, step, i, j):
        """Links what there is at corner j, between the sides i and j."""
        g, h = step.glued[i], step.glued[j]
        a, b = step.opened[i], step.opened[j]
        if g is not None and h is not None:
            if g.after is not h:
                link(h.link(False), g.link(True))
        elif g is not None:
            link(b, g.link(True))
        elif h is not None:
            link(h.link(False), a)
        else:
            vertex = step.corners[j]
            others = self.front.beginning_at(vertex) if vertex < step.met else []
            x = next((edge for edge in others if edge not in step.opened), None)
            if x is None:
                link(b, a)
            else:
                y = x.link(False)
                link(b, x)
                link(y, a)
