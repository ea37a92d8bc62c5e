# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The walk of a chunk of a `.gtn` file: sections 8 and 9 of Documentation/format.md, in which names
are the same.

Part of gtn_decoder, which is written from that text alone.
"""

import math
from collections import OrderedDict

from gtn_coding import Coded, divide
from gtn_container import Bytes, require

NONE = math.inf  # a vertex that is none, which is greater than all others
INF = math.inf

ANGLE, PLAIN, FLIPS = 1, 2, 4


def minus(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def dot(u, v):
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]


def cross(u, v):
    return (
        u[1] * v[2] - u[2] * v[1],
        u[2] * v[0] - u[0] * v[2],
        u[0] * v[1] - u[1] * v[0],
    )


def clamp(x, low, high):
    return max(low, min(x, high))


class Edge:
    """An edge of the front (8.4). open: number of open faces that have it, listed or not."""

    def __init__(self, a, b):
        self.ends = (a, b)
        self.faces = []
        self.tets = 0
        self.border_far = NONE
        self.open = 0

    def other_end(self, end):
        return self.ends[1] if self.ends[0] == end else self.ends[0]


class Face:
    """An open face (8.4)."""

    def __init__(self, corners, apex, tet, edges):
        self.corners = corners
        self.apex = apex
        self.tet = tet
        self.edges = edges

    def far(self, edge):
        return next(corner for corner in self.corners if corner not in edge.ends)

    def edge(self, a, b):
        return next(edge for edge in self.edges if a in edge.ends and b in edge.ends)

    def other_edge(self, edge, end):
        return next(other for other in self.edges if other is not edge and end in other.ends)


class Lattice:
    """Places of coordinates (8.2)."""

    def __init__(self, box):
        extent = 0.0
        for low, high in box:
            if high - low > extent:
                extent = high - low
        self.scale = divide(65535.0, extent)
        if not math.isfinite(self.scale):
            self.scale = 0.0
        self.low = [low for low, _ in box]

    def place(self, values):
        """A place, as binary64 numbers."""
        result = []
        for x, low in zip(values, self.low):
            x = (x - low) * self.scale
            result.append(0.0 if not x > 0 else 65535.0 if x >= 65535 else float(math.floor(x)))
        return tuple(result)


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
    """9.3: numbers of K[0] to K[6], None for those that are not there."""
    total = 0.0
    for k, weight in enumerate(rule):
        if weight:
            x = numbers[k]
            if x is None:
                j = k - 4
                x = numbers[j] + numbers[(j + 1) % 3] - numbers[(j + 2) % 3]
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
        count = stream.number("B")
        require(1 <= count <= 16, "number of rules")
        self.rules = [[stream.number("h") for _ in range(7)] for _ in range(count)]
        self.coded = Coded(stream)

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
        grade = 0
        key = []
        for i, domain in enumerate(self.domains):
            if record.is_seed:
                p, spread = self.last[i], domain.bits
            else:
                known = [None if v == NONE else keys[v][i] for v in record.known]
                numbers = [None if k is None else domain.to_number(k) for k in known]
                p = domain.from_number(apply_rule(self.rules[rule], numbers))
                spread = key_spread(known[:4])
            d, kind = coded.residual((i, group, grade), spread)
            key.append(domain.add(p, d))
            grade = 0 if kind < 0 else 1 if kind < 13 else 2 if kind < 17 else 3
        self.last = tuple(key)
        self.used.append(rule)
        return self.last


class Walk:
    """Decodes a chunk. What it gives, as in 8.1:

    keys         of the coordinates of each vertex
    shared       shared index of each vertex, or None if it is an own one
    tets         four vertices each
    parents      of the tetrahedra, or None
    records      of the own vertices, in order
    edge_log     pairs of vertices
    """

    def __init__(self, chunk, stream, geometry, domains, shared_keys, shared_users):
        """chunk: its entry in TABL; geometry: a Geometry; lists of the shared points."""
        stream = Bytes(stream)
        self.flags = stream.number("B")
        require(self.flags <= 7, "flags of a walk")
        self.angle = bool(self.flags & ANGLE)
        self.coded = Coded(stream)
        self.decide, self.index = self.coded.decide, self.coded.index
        self.chunk, self.geometry, self.domains = chunk, geometry, domains
        self.lattice = Lattice(chunk.box)
        self.shared_keys, self.shared_users = shared_keys, shared_users
        self.shared_places = [self.place_of(key) for key in shared_keys]
        self.shared_met = [False] * len(shared_keys)
        self.grid = self.make_grid()

        self.keys, self.places, self.shared, self.users = [], [], [], []
        self.tets, self.parents, self.records, self.edge_log = [], [], [], []
        self.front = OrderedDict()  # the open faces, oldest first; values mean nothing
        self.edges = {}  # by frozensets of their ends
        self.left = min(256, 8 + chunk.tets // 512)  # distant lists that may be made
        self.touched = set()  # edges that may have lost their last open face in this step

        while len(self.tets) < chunk.tets:
            if self.front and not self.flags & PLAIN:
                self.grow(next(iter(self.front)))
                self.remove_edges()
            else:
                self.seed()
        require(len(self.records) == chunk.own_points, "own points that were not met")
        require(all(self.shared_met), "shared points that were not met")
        if self.flags & FLIPS:
            flips = []
            for i, (a, b, c, d) in enumerate(self.tets):
                parent = self.parents[i]
                flips.append(self.decide("Flip", 0 if parent is None else flips[parent]))
                if flips[i]:
                    self.tets[i] = (a, b, d, c)

    # ----- Vertices

    def place_of(self, key):
        return self.lattice.place([domain.to_value(k) for domain, k in zip(self.domains, key)])

    def meet(self, key, place, shared, users):
        self.keys.append(key)
        self.places.append(place)
        self.shared.append(shared)
        self.users.append(users)
        return len(self.keys) - 1

    def meet_shared(self, index):
        require(not self.shared_met[index], "shared point that was met before")
        self.shared_met[index] = True
        key, users = self.shared_keys[index], self.shared_users[index]
        return self.meet(key, self.shared_places[index], index, users)

    def meet_own(self, record):
        require(len(self.records) < self.chunk.own_points, "too many own points")
        key = self.geometry.vertex(record, self.keys)
        self.records.append(record)
        return self.meet(key, self.place_of(key), None, 0)

    # ----- The front (8.4)

    def edge(self, a, b):
        """The edge between a and b, which is created if there is none."""
        ends = frozenset((a, b))
        if ends not in self.edges:
            self.edges[ends] = Edge(a, b)
            self.edge_log.append((a, b))
        return self.edges[ends]

    def open_face(self, *face):
        face = Face(*face)
        self.front[face] = True
        for edge in face.edges:
            edge.open += 1
            if len(edge.faces) < 4:
                edge.faces.append(face)

    def close_face(self, face):
        del self.front[face]
        for edge in face.edges:
            edge.open -= 1
            self.touched.add(edge)
            if face in edge.faces:
                edge.faces.remove(face)

    def remove_edges(self):
        for edge in self.touched:
            if edge.open == 0:
                del self.edges[frozenset(edge.ends)]
        self.touched.clear()

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
        e = {}
        for a, b in ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)):
            e[a, b] = e[b, a] = self.edge(v[a], v[b])
            e[a, b].tets = 1
        for a, b, c, apex in ((0, 2, 1, 3), (0, 1, 3, 2), (1, 2, 3, 0), (2, 0, 3, 1)):
            self.open_face((v[a], v[b], v[c]), v[apex], tet, (e[a, b], e[b, c], e[c, a]))

    def grow(self, face):
        self.close_face(face)
        gate = Gate(self, face)
        c, e = gate.c, gate.e
        if gate.best_id != NONE and self.decide("Hit", *gate.hit_indices()):
            return self.attach(gate, gate.best_id)
        if self.decide("Border", *gate.border_indices()):
            for i in range(3):
                e[i].border_far = c[(i + 2) % 3]
            return None
        if self.decide("New", *gate.new_indices()):
            count = sum(self.shared[v] is not None for v in c)
            apex = int(self.shared[face.apex] is not None)
            if self.decide("Shared", count, apex):
                v = self.meet_shared(self.name_shared(gate))
            else:
                v = self.meet_own(gate.record())
            return self.attach(gate, v)
        for j, v in enumerate(gate.others):
            if self.decide("Next", j):
                return self.attach(gate, v)
        ring = gate.ring()
        v = self.pick(gate, ring, "Ring")
        if v is None and self.left > 0:
            self.left -= 1
            v = self.pick(gate, gate.distant(ring), "Distant")
        if v is None:
            v = self.index(len(self.keys))
        require(v not in c, "tetrahedron with a corner twice")
        return self.attach(gate, v)

    def pick(self, gate, vertices, name):
        if not self.decide(name + "Listed"):
            return None
        ranked = sorted((gate.sphere(self.places[v]), v) for v in vertices)
        for i, (_, v) in enumerate(ranked[:15]):
            if self.decide(name + "Pick", min(i, 5)):
                return v
        require(False, "nothing picked")

    def attach(self, gate, v):
        """8.8."""
        c, e = gate.c, gate.e
        tet = len(self.tets)
        self.tets.append((c[0], c[1], c[2], v))
        self.parents.append(gate.face.tet)
        twins = [next((face for face in edge.faces if face.far(edge) == v), None) for edge in e]
        f = [self.edge(corner, v) for corner in c]
        for edge in (*e, *f):
            edge.tets += 1
        for twin in twins:
            if twin is not None:
                self.close_face(twin)
        for i in range(3):
            if twins[i] is None:
                j = (i + 1) % 3
                self.open_face((c[i], c[j], v), c[(i + 2) % 3], tet, (e[i], f[j], f[i]))

    # ----- Shared vertices by their place (8.13)

    def make_grid(self):
        count = len(self.shared_keys)
        self.depth = clamp((count.bit_length() - 4) // 2, 0, 6)
        grid = {}
        for index, place in enumerate(self.shared_places):
            grid.setdefault(self.cell(place), []).append(index)
        return grid

    def cell(self, place):
        return tuple(int(x) >> (16 - self.depth) for x in place)

    def name_shared(self, gate):
        """The shared index that is named next."""
        hits = self.search(gate)
        if not self.angle:
            hits = sorted((gate.sphere(self.shared_places[h]), h) for _, h in hits)
        for i, (_, index) in enumerate(hits):
            if self.decide("SharedRank", i):
                return index
        return self.index(len(self.shared_keys))

    def search(self, gate):
        """Hits as pairs of distance and index, in ascending order."""
        a, b, c = [tuple(int(x) for x in self.places[v]) for v in gate.c]
        s = tuple(a[i] + b[i] + c[i] for i in range(3))
        sides = minus(b, a), minus(c, a), minus(c, b)
        limit = (144 if self.angle else 36) * max(dot(side, side) for side in sides)
        x0, y0, z0 = self.cell([x // 3 for x in s])
        hits = []
        patience = 1024
        top = (1 << self.depth) - 1
        for ring in range(top + 1):
            reach = 3 * max(0, ring - 1) << (16 - self.depth)
            if reach * reach > limit or len(hits) == 8 and reach * reach > hits[-1][0]:
                break
            for z in range(max(0, z0 - ring), min(top, z0 + ring) + 1):
                for y in range(max(0, y0 - ring), min(top, y0 + ring) + 1):
                    inside = abs(z - z0) < ring and abs(y - y0) < ring
                    for x in range(x0 - ring, x0 + ring + 1, 2 * ring if inside else 1):
                        if x < 0 or x > top:
                            continue
                        entries = self.grid.get((x, y, z), [])
                        count = min(len(entries), patience - 1)
                        for index in entries[:count]:
                            self.look(gate, index, a, s, limit, hits)
                        patience -= count + 1
                        if patience == 0:
                            return hits
        return hits

    def look(self, gate, index, a, s, limit, hits):
        place = tuple(int(x) for x in self.shared_places[index])
        difference = tuple(3 * place[i] - s[i] for i in range(3))
        distance = dot(difference, difference)
        met = self.shared_met[index]
        if not met and distance <= limit and dot(minus(place, a), gate.normal) > 0:
            hits.append((distance, index))
            hits.sort()
            del hits[8:]


class Gate:
    """A face on which the walk grows: proposals (8.7), measures (8.10), indices of models (8.11).

    c, e, ids, faces, ranks: those of the three sides; others: other candidates.
    """

    def __init__(self, walk, face):
        self.walk, self.face = walk, face
        self.c, self.e = face.corners, face.edges
        places = [walk.places[v] for v in self.c]
        self.a = places[0]
        u, v = minus(places[1], places[0]), minus(places[2], places[0])
        self.normal = n = cross(u, v)
        self.nn = dot(n, n)

        w = minus(v, u)
        uu, vv = dot(u, u), dot(v, v)
        sides = uu * vv * dot(w, w)
        inverse = divide(1.0, self.nn)
        p, q = cross(v, n), cross(n, u)
        self.o = tuple((uu * p[i] + vv * q[i]) * inverse for i in range(3))
        self.unit = divide(self.nn, math.sqrt(sides))
        self.r = sides * inverse

        self.propose()

    # ----- Measures

    def sphere(self, d):
        g = minus(d, self.a)
        height = dot(g, self.normal)
        return (dot(g, g) - dot(g, self.o)) / height if height > 0 else INF

    def angle(self, d, i):
        s, e = self.walk.places[self.c[i]], self.walk.places[self.c[(i + 1) % 3]]
        g = minus(d, s)
        height = dot(g, self.normal)
        if not height > 0:
            return INF
        edge = minus(e, s)
        inward = dot(g, cross(self.normal, edge))
        square = inward * inward
        r = square / (square + height * height * dot(edge, edge))
        return r if inward < 0 else -r

    def is_coplanar(self, d, i):
        g = minus(d, self.walk.places[self.c[i]])
        height = dot(g, self.normal)
        return height * height < 0.01 * (self.nn * dot(g, g))

    # ----- Proposals

    def propose(self):
        places = self.walk.places
        self.ids, self.faces, self.ranks = [NONE] * 3, [None] * 3, [INF] * 3
        for i, edge in enumerate(self.e):
            for face in edge.faces:
                far = face.far(edge)
                if far == self.c[(i + 2) % 3]:
                    continue
                place = places[far]
                rank = self.angle(place, i) if self.walk.angle else self.sphere(place)
                if self.faces[i] is None or rank < self.ranks[i]:
                    self.ids[i], self.faces[i], self.ranks[i] = far, face, rank

        order = sorted(range(3), key=lambda i: (self.ranks[i], self.ids[i]))
        best = order[0]
        self.best_id, self.best_rank = self.ids[best], self.ranks[best]
        self.others = []
        self.second_rank = INF
        self.best_count = 3
        self.candidates = 0
        self.best_tets = 0
        if self.best_id != NONE:
            for i in order[1:]:
                if self.ids[i] != self.best_id:
                    self.second_rank = min(self.second_rank, self.ranks[i])
                    if self.ids[i] != NONE and self.ids[i] not in self.others:
                        self.others.append(self.ids[i])
            self.best_count = self.ids.count(self.best_id)
            self.candidates = 1 + len(self.others)
            self.best_tets = min(7, self.e[best].tets)

        borders = [i for i in range(3) if self.e[i].border_far != NONE]
        coplanar = sum(self.is_coplanar(places[self.e[i].border_far], i) for i in borders)
        self.border_grade = len(borders) * (len(borders) + 1) // 2 + coplanar
        t = [min(2, edge.tets - 1) for edge in self.e]
        self.edge_grade = 9 * t[0] + 3 * t[1] + t[2]
        users = [self.walk.users[v] for v in self.c]
        self.all_shared = int(users[0] & users[1] & users[2] != 0)

    def record(self):
        known = [*self.c, self.face.apex]
        for edge, vertex in zip(self.e, self.ids):
            known.append(edge.border_far if vertex == NONE else vertex)
        return GateRecord(known, self.edge_grade, self.candidates)

    # ----- Indices of models

    def hit_indices(self):
        if not self.walk.angle:
            return self.sphere_grade(self.best_rank), self.best_count, self.radius()
        return self.first(), self.best_tets, self.best_count

    def border_indices(self):
        if not self.walk.angle:
            return self.all_shared, self.border_grade, self.radius()
        return self.all_shared, self.border_grade, self.first(), self.best_tets

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
        g = 16 + 16 * (t / (1 + abs(t)))
        return math.floor(g) if g < 31 else 31

    def radius(self):
        if self.nn == 0:
            return 31
        return clamp(math.frexp(self.r)[1] - 1 - 6, 0, 31)

    def angle_grade(self, rank):
        if rank == INF:
            return 16
        g = 8 + 8 * rank
        return math.floor(g) if g < 15 else 15

    def first(self):
        return 17 if self.best_id == NONE else self.angle_grade(self.best_rank)

    # ----- Turning (8.12)

    def turn(self, x, edge, start, most, use):
        for _ in range(most):
            face = next((face for face in edge.faces[:2] if face is not start), None)
            if face is None:
                break
            edge = face.other_edge(edge, x)
            use(edge.other_end(x))
            start = face
        return edge

    def ring_rank(self):
        ranks = [INF]

        def look(v):
            if v not in self.ids:
                ranks.append(self.sphere(self.walk.places[v]))

        for i, face in enumerate(self.faces):
            if face is not None:
                for x in self.e[i].ends:
                    self.turn(x, face.edge(x, self.ids[i]), face, 2, look)
        return min(ranks)

    def ring(self):
        ring = set()
        for i in range(3):
            last = self.e[(i + 2) % 3]
            end = self.turn(self.c[i], self.e[i], None, 32, ring.add)
            if end is not last:
                self.turn(self.c[i], last, None, 32, ring.add)
        return ring.difference(self.c, self.ids)

    def distant(self, ring):
        corners = set()
        for face in self.walk.front:
            corners.update(face.corners)
        return corners.difference(ring, self.c, self.ids)
