# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The walk of a chunk of a `.gtn` file: sections 8 and 9 of Documentation/format.md, in which names
are the same.

Part of gtn_decoder, which is written from that text alone.
"""

import math
from collections import OrderedDict

import numpy as np

from gtn_bytes import Bytes, require
from gtn_coding import Coded
from gtn_frames import Frames
from gtn_vertices import INF, F, Vertices, clamp, cross, dot, minus, square

ANGLE, PLAIN, FLIPS = 1, 2, 4


class Link:
    """Where the link of a side leads to: side number `side` of `face`, or, without a face, the
    border, which names `border` (8.4)."""

    def __init__(self, face, side, border, tets):
        self.face, self.side, self.border, self.tets = face, side, border, tets

    def far(self):
        return self.border if self.face is None else self.face.corners[self.side]

    def beside(self, step):
        """The link of a side of the face that this leads to, `step` after the one here."""
        return self.face.links[(self.side + step) % 3]


class Face:
    """An open face, or one that was (8.4). links: of its sides."""

    def __init__(self, corners, apex, tet):
        self.corners, self.apex, self.tet = corners, apex, tet
        self.links = [None] * 3
        self.is_open = True


def to_side(face, side):
    """A link to a side, for join()."""
    return Link(face, side % 3, None, 0)


def to_border(vertex):
    return Link(None, None, vertex, 0)


def join(p, q, tets):
    """Joins what two links lead to."""
    tets = min(tets, 7)
    for here, there in ((p, q), (q, p)):
        if here.face is not None:
            here.face.links[here.side] = Link(there.face, there.side, there.border, tets)


def turn(link, forward, most, use):
    """Goes from face to face around a vertex, until `use` of a vertex and a side is true."""
    for _ in range(most):
        if link.face is None or not link.face.is_open:
            break
        step = 2 if forward else 1
        if use(link.far(), to_side(link.face, link.side + step)):
            break
        link = link.beside(step)
    return link


class SeedRecord:
    """The record of a vertex that is met in a seed."""

    is_seed = True


class GateRecord:
    """The record of a vertex that is met on a gate (8.7)."""

    is_seed = False

    def __init__(self, known, edge_grade, candidates):
        self.known = known
        self.edge_grade = edge_grade
        self.candidates = candidates


def apply_rule(rule, numbers):
    """9.3: numbers of K[0] to K[6]."""
    total = 0.0
    for weight, x in zip(rule, numbers):
        if weight:
            total += float(weight) * x
    return total * 0.00390625


def key_spread(keys):
    return (max(keys) - min(keys)).bit_length()


class Geometry:
    """The geometry stream (section 9). used: the used rule of each own vertex, in order."""

    def __init__(self, stream, domains):
        self.domains = domains
        self.used = []
        self.last = (0, 0, 0)
        stream = Bytes(stream)
        head = stream.number("B")
        has_frame, count = head >> 7, head & 127
        require(1 <= count <= 16, "number of rules")
        self.rules = [[stream.number("h") for _ in range(7)] for _ in range(count)]
        weights = [stream.number("h") for _ in range(5)] if has_frame else None
        self.coded = Coded(stream)
        self.frames = Frames(self.coded, domains, weights, count) if has_frame else None

    def vertex(self, record, keys):
        """Keys of the next own vertex (9.2). keys: those of all vertices met before."""
        coded = self.coded
        rule = 0
        if record.is_seed:
            group = 16
        elif len(self.rules) == 1:
            group = record.candidates
        else:
            node = 1
            for _ in range(4):
                node = 2 * node + coded.decide("Rule", record.edge_grade, record.candidates, node)
            rule = group = node - 16
            require(rule < len(self.rules), "rule")
        if self.frames and rule == len(self.rules) - 1 and not record.is_seed:
            self.last = self.frames.vertex(record, keys)
            self.used.append(rule)
            return self.last
        grade = 0
        key = []
        for i, domain in enumerate(self.domains):
            if record.is_seed:
                p, spread = self.last[i], domain.bits
            else:
                known = [keys[v][i] for v in record.known]
                numbers = [domain.to_number(k) for k in known]
                p = domain.from_number(apply_rule(self.rules[rule], numbers))
                spread = key_spread(known[:4])
            d, grade = coded.residual((i, group, grade), spread)
            key.append(domain.add(p, d))
        self.last = tuple(key)
        self.used.append(rule)
        return self.last

    def predict(self, record, used, domain, keys):
        """Number, spread and group of a value by the mode gate (10.4), or nothing."""
        if record.is_seed:
            return None
        known = [keys[v] for v in record.known]
        numbers = [domain.to_number(key) for key in known]
        return apply_rule(self.rules[used], numbers), key_spread(known[:4]), 1 + used

    def predict_number(self, record, used, numbers):
        """The number alone, from numbers of the vertices, or nothing."""
        if record.is_seed:
            return None
        return apply_rule(self.rules[used], [numbers[v] for v in record.known])


class Walk(Vertices):
    """Decodes a chunk. What it gives, as in 8.1, besides its vertices:

    tets         four vertices each
    parents      of the tetrahedra, or None
    """

    def __init__(self, chunk, stream, geometry, domains, shared_keys, shared_users):
        """chunk: its entry in TABL; geometry: a Geometry; lists of the shared points."""
        stream = Bytes(stream)
        self.flags = stream.number("B")
        require(self.flags <= 7, "flags of a walk")
        self.angle = bool(self.flags & ANGLE)
        self.coded = Coded(stream)
        self.decide, self.index = self.coded.decide, self.coded.index
        super().__init__(chunk, geometry, domains, shared_keys, shared_users)
        self.tets, self.parents = [], []
        self.front = OrderedDict()  # the open faces, oldest first; values mean nothing

        with np.errstate(all="ignore"):
            while len(self.tets) < chunk.tets:
                if self.front and not self.flags & PLAIN:
                    self.grow(next(iter(self.front)))
                else:
                    self.seed()
        self.check_all_met()
        if self.flags & FLIPS:
            flips = []
            for i, (a, b, c, d) in enumerate(self.tets):
                parent = self.parents[i]
                flips.append(self.decide("Flip", 0 if parent is None else flips[parent]))
                if flips[i]:
                    self.tets[i] = (a, b, d, c)

    # ----- The front (8.4)

    def open_face(self, corners, apex, tet):
        face = Face(corners, apex, tet)
        self.front[face] = True
        return face

    def close_face(self, face):
        del self.front[face]
        face.is_open = False

    # ----- Steps (8.5, 8.6)

    def seed(self):
        v = []
        for _ in range(4):
            if not self.decide("SeedNew"):
                v.append(self.index(len(self.keys)))
            elif self.decide("SeedShared"):
                v.append(self.meet_shared(self.index(len(self.shared_keys))))
            else:
                v.append(self.meet_own(SeedRecord()))
        tet = len(self.tets)
        self.tets.append(tuple(v))
        self.parents.append(None)
        if len(set(v)) < 4 or self.flags & PLAIN:
            return
        faces = []
        for i, j, k, apex in ((0, 2, 1, 3), (0, 1, 3, 2), (1, 2, 3, 0), (2, 0, 3, 1)):
            faces.append(self.open_face((v[i], v[j], v[k]), v[apex], tet))
        for i, j in ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)):
            self.edge_log.append((v[i], v[j]))
            p, q = [
                to_side(face, side)
                for face in faces
                for side in range(3)
                if {v[i], v[j]} == set(face.corners) - {face.corners[side]}
            ]
            join(p, q, 1)

    def grow(self, face):
        self.close_face(face)
        gate = Gate(self, face)
        c = gate.c
        seen = gate.is_interface()
        if seen and self.decide("Interface", *gate.interface_indices()):
            return self.border(gate)
        gate.propose()
        if gate.best_id is not None and self.decide("Hit", *gate.hit_indices()):
            return self.attach(gate, gate.best_id)
        if not seen and self.decide("Border", *gate.border_indices()):
            return self.border(gate)
        if self.decide("New", *gate.new_indices()):
            count = sum(self.shared[v] is not None for v in c)
            apex = int(self.shared[face.apex] is not None)
            if self.decide("Shared", count, apex):
                v = self.meet_shared(self.name_shared(gate))
            else:
                v = self.meet_own(gate.record())
            return self.attach(gate, v, True)
        for j, v in enumerate(gate.others):
            if self.decide("Next", j):
                return self.attach(gate, v)
        ring = gate.ring()
        if self.decide("RingListed"):
            v = self.pick(gate, ring)
        else:
            v = self.index(len(self.keys))
        require(v not in c, "tetrahedron with a corner twice")
        return self.attach(gate, v)

    def border(self, gate):
        for vertex, link in zip(gate.c, gate.links):
            join(link, to_border(vertex), link.tets)

    def pick(self, gate, ring):
        ranked = sorted((gate.sphere(self.places[v]), v) for v in ring)
        for i, (_, v) in enumerate(ranked[:15]):
            if self.decide("RingPick", min(i, 5)):
                return v
        require(False, "nothing picked")

    def attach(self, gate, v, is_new=False):
        """8.8."""
        c = gate.c
        tet = len(self.tets)
        self.tets.append((*c, v))
        self.parents.append(gate.face.tet)
        glued = [not is_new and vertex == v for vertex in gate.ids]
        apart = [not glued[(k + 1) % 3] and not glued[(k + 2) % 3] for k in range(3)]
        touching = [gate.touching(k, v) if apart[k] and not is_new else None for k in range(3)]

        left, right = [None] * 3, [None] * 3
        for i in (2, 0, 1):
            link = gate.links[i]
            if glued[i]:
                left[(i + 2) % 3], right[(i + 1) % 3] = link.beside(2), link.beside(1)
                self.close_face(link.face)
            else:
                face = self.open_face((c[(i + 1) % 3], c[(i + 2) % 3], v), c[i], tet)
                join(to_side(face, 2), link, link.tets + 1)
                left[(i + 2) % 3], right[(i + 1) % 3] = to_side(face, 0), to_side(face, 1)

        for k, p, q in zip(range(3), left, right):
            if not apart[k]:
                if p.face is None or p.face.is_open:
                    join(p, q, p.tets + q.tets + 1)
            elif touching[k] is not None:
                side, forward = touching[k]
                there = side.face.links[side.side]
                if not forward:
                    p, q = q, p
                join(p, side, there.tets + 1)
                join(q, there, there.tets + 1)
            else:
                self.edge_log.append((c[k], v))
                join(p, q, 1)

    # ----- Shared vertices by their place (8.13)

    def name_shared(self, gate):
        """The shared index that is named next."""
        for i, (_, index) in enumerate(self.search_at(gate)):
            if self.decide("SharedRank", i):
                return index
        return self.index(len(self.shared_keys))

    def search_at(self, gate):
        """Hits near a gate."""
        a, b, c = gate.corner_places
        longest = max(square(minus(b, a)), square(minus(c, a)), square(minus(c, b)))
        third = F(1) / F(3)
        m = tuple((a[i] + b[i] + c[i]) * third for i in range(3))
        reach = F(3 if self.angle else 1.25)

        def rank(place, distance):
            if not self.angle:
                return gate.sphere(place)
            return distance if dot(minus(place, gate.a), gate.normal) > 0 else INF

        return self.search(m, reach * reach * longest, rank)


class Gate:
    """A face on which the walk grows: proposals (8.7), measures (8.10), indices of models (8.11).

    c, links, ids, ranks: corners, and those of the sides; others: other candidates.
    """

    def __init__(self, walk, face):
        self.walk, self.face = walk, face
        self.c, self.links = face.corners, tuple(face.links)
        self.far = [link.far() for link in self.links]
        self.corner_places = [walk.places[v] for v in self.c]
        self.a, b, c = self.corner_places
        u, v = minus(b, self.a), minus(c, self.a)
        self.normal = n = cross(u, v)
        self.nn = dot(n, n)

        w = minus(v, u)
        uu, vv = dot(u, u), dot(v, v)
        sides = uu * vv * dot(w, w)
        inverse = F(1) / self.nn
        p, q = cross(v, n), cross(n, u)
        self.o = tuple((uu * p[i] + vv * q[i]) * inverse for i in range(3))
        self.unit = self.nn / np.sqrt(sides)
        self.r = sides * inverse

        self.border_edges = sum(link.face is None for link in self.links)
        t = [min(2, link.tets - 1) for link in self.links]
        self.edge_grade = 9 * t[0] + 3 * t[1] + t[2]

    # ----- Measures

    def sphere(self, d):
        g = minus(d, self.a)
        height = dot(g, self.normal)
        return (dot(g, g) - dot(g, self.o)) / height if height > 0 else INF

    def angle(self, d, i):
        s, e = self.corner_places[(i + 1) % 3], self.corner_places[(i + 2) % 3]
        g = minus(d, s)
        height = dot(g, self.normal)
        if not height > 0:
            return INF
        edge = minus(e, s)
        inward = dot(g, cross(self.normal, edge))
        inward2 = inward * inward
        r = inward2 / (inward2 + height * height * dot(edge, edge))
        return r if 0 > inward else F(0) - r

    def is_coplanar(self, d, i):
        g = minus(d, self.corner_places[(i + 1) % 3])
        height = dot(g, self.normal)
        return height * height < F(0.01) * (self.nn * dot(g, g))

    # ----- Proposals

    def propose(self):
        places = self.walk.places
        self.ids, self.ranks = [None] * 3, [INF] * 3
        for i, link in enumerate(self.links):
            if link.face is not None and self.far[i] != self.c[i]:
                place = places[self.far[i]]
                self.ids[i] = self.far[i]
                self.ranks[i] = self.angle(place, i) if self.walk.angle else self.sphere(place)

        best = 0
        if self.ranks[1] < self.ranks[0]:
            best = 1
        if self.ranks[2] < self.ranks[best]:
            best = 2
        self.best_id, self.best_rank = self.ids[best], INF
        self.best_count = self.ids.count(self.best_id)
        self.others = []
        self.second_rank = INF
        rest = [(best + 1) % 3, (best + 2) % 3]
        if self.ranks[rest[1]] < self.ranks[rest[0]]:
            rest.reverse()
        for i in rest:
            if self.ids[i] != self.best_id:
                self.second_rank = min(self.second_rank, self.ranks[i])
                if self.ids[i] is not None and self.ids[i] not in self.others:
                    self.others.append(self.ids[i])
        self.candidates = 0
        self.best_tets = 0
        if self.best_id is not None:
            self.best_rank = self.ranks[best]
            self.best_tets = self.links[best].tets
            self.candidates = 1 + len(self.others)

        coplanar = sum(
            bool(self.is_coplanar(places[self.far[i]], i))
            for i in range(3)
            if self.links[i].face is None
        )
        self.border_grade = self.border_edges * (self.border_edges + 1) // 2 + coplanar

    def record(self):
        return GateRecord([*self.c, self.face.apex, *self.far], self.edge_grade, self.candidates)

    def is_interface(self):
        users = [self.walk.users[v] for v in self.c]
        return users[0] & users[1] & users[2] != 0

    # ----- Indices of models

    def interface_indices(self):
        users = [self.walk.users[v] for v in (*self.c, self.face.apex)]
        near = int(users[0] & users[1] & users[2] & users[3] != 0)
        return self.border_edges, self.edge_grade, near

    def hit_indices(self):
        if not self.walk.angle:
            return self.sphere_grade(self.best_rank), self.best_count, self.radius()
        return self.first(), self.best_tets, self.best_count

    def border_indices(self):
        if not self.walk.angle:
            return self.border_grade, self.radius()
        return self.border_grade, self.first(), self.best_tets

    def new_indices(self):
        if not self.walk.angle:
            rank = self.ring_rank()
            return self.sphere_grade(rank), int(rank < self.best_rank), self.radius()
        second = 17 if self.candidates < 2 else self.angle_grade(self.second_rank)
        return self.first(), second, self.edge_grade

    def sphere_grade(self, rank):
        if rank == INF:
            return 32
        t = rank * self.unit
        g = F(16) + F(16) * (t / (F(1) + abs(t)))
        return math.floor(g) if g < 31 else 31

    def radius(self):
        if self.nn == 0:
            return 31
        return clamp(math.frexp(self.r)[1] - 1 + 10, 0, 31)

    def angle_grade(self, rank):
        if rank == INF:
            return 16
        g = F(8) + F(8) * rank
        return math.floor(g) if g < 15 else 15

    def first(self):
        return 17 if self.best_id is None else self.angle_grade(self.best_rank)

    # ----- Turning (8.4, 8.8) and rings (8.12)

    def turn_both_ways(self, k, use):
        """Around corner k. use(vertex, side, whether forward)"""
        forward, back = self.links[(k + 1) % 3], self.links[(k + 2) % 3]
        end = turn(forward, True, 32, lambda *there: use(*there, True))
        if end.face is None:
            turn(back, False, 32, lambda *there: use(*there, False))

    def touching(self, k, v):
        """Where the front touches itself in the edge from corner k to v: a side and whether it was
        found forward, or None."""
        found = []

        def look(vertex, side, forward):
            if vertex == v:
                found.append((side, forward))
            return bool(found)

        self.turn_both_ways(k, look)
        return found[0] if found else None

    def ring_rank(self):
        rank = INF
        for link in self.links:
            if link.face is None:
                continue
            for beside in (link.beside(1), link.beside(2)):
                v = beside.far()
                if beside.face is not None and v not in self.ids and v not in self.c:
                    rank = min(rank, self.sphere(self.walk.places[v]))
        return rank

    def ring(self):
        ring = set()

        def add(vertex, *_):
            ring.add(vertex)

        for k in range(3):
            self.turn_both_ways(k, add)
        return ring.difference(self.c, self.ids)
