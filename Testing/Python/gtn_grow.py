# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The walk of a chunk of cells: sections 4.1 to 4.6 of Documentation/cell-codec.md, in which names
are the same.

Part of gtn_decoder, which is written from that text alone.
"""

from gtn_bytes import require
from gtn_forms import NO_SHAPE, begin
from gtn_front import Front, OpenFace, end, join
from gtn_records import B1, D12, D13, D23, N1, SLOTS, CellRecord, O, mix, predicted
from gtn_shapes import POLYHEDRON, TETRA, view_of_type
from gtn_vertices import F, clamp, dot, minus, square

NEAR_LIMITS = [F(limit) for limit in (0.01, 0.04, 0.1, 0.25, 0.6, 1.2)]


class Gate:
    """What a gate says about the sides around it (4.2)."""

    def __init__(self, walk, face):
        self.face = face
        self.k = k = len(face)
        self.least_angle, self.most_cells = 16, 0
        self.borders = self.coplanar = self.pattern = 0
        count = [0] * 4
        for s in face.sides:
            t = s.leads_to()
            kind = 0
            if t is not None:
                angle = walk.front.angle(s)
                kind = 0 if angle > 5 else min(len(t.face), 5) - 2
                self.least_angle = min(self.least_angle, angle)
            else:
                self.borders += 1
                if s.border is not None:
                    d = minus(walk.mesh.places[s.border], walk.mesh.places[s.begins()])
                    h = dot(d, walk.front.normal(face))
                    self.coplanar += bool(h * h < F(0.01) * dot(d, d))
            self.most_cells = max(self.most_cells, s.cells)
            if kind > 0:
                count[kind] = min(count[kind] + 1, 3)
            if k <= 4:
                self.pattern = 4 * self.pattern + kind
        if k > 4:
            self.pattern = 16 * count[1] + 4 * count[2] + count[3]
        self.b, self.m = min(self.borders, 4), min(self.most_cells, 4)
        self.degree = clamp(k, 3, 6)

    def hint(self, front, i):
        """Of a face of an inline form at side i of the gate (4.3)."""
        t = self.face.sides[i].leads_to()
        return len(t.face) if t is not None and front.angle(self.face.sides[i]) <= 5 else 0


class Step:
    """A cell that is being made: the vertex of each corner of its form, or None, and its glued
    faces with, for each, the front's sides by the places of the form's sides."""

    def __init__(self, form, gate=None):
        self.form, self.gate = form, gate
        self.vertices = [None] * form.corners
        self.glued = {}
        if gate is not None:
            self.vertices[: len(gate)] = gate.corners
            self.glued[0] = list(gate.sides)

    def known(self, corners):
        return [c for c in corners if self.vertices[c] is not None]

    def ends(self, side):
        return [self.vertices[c] for c in self.form.ends(side)]

    def front_side(self, side):
        """The front's side at a side of a glued face of the form."""
        f, p = side
        return self.glued[f][p]

    def put(self, corner, vertex):
        require(vertex not in self.vertices, "cell with a vertex twice")
        self.vertices[corner] = vertex

    def record(self, c):
        """The record of a corner (7.1)."""
        network, vertices = self.form.network, self.vertices
        slots = [None] * SLOTS
        known = self.known(network.neighbors[c])[:3]
        for i, n in enumerate(known):
            slots[N1 + i] = vertices[n]
            slots[B1 + i] = self._below(n, c)
        between = {(0, 1): D12, (0, 2): D13, (1, 2): D23}
        for a, b, opposite in network.quadrilaterals[c]:
            if a in known and b in known:
                place = between[tuple(sorted((known.index(a), known.index(b))))]
                slots[place] = vertices[opposite]
        if network.beyond[c] is not None:
            slots[O] = vertices[network.beyond[c]]
        if not known:
            rest = self.known(range(self.form.corners))
            slots[N1] = vertices[rest[-1]] if rest else None
        return CellRecord(slots)

    def _below(self, n, c):
        """Below a known corner n in the front, seen from c."""
        for f, sides in self.glued.items():
            if n in self.form.faces[f] and c not in self.form.faces[f]:
                face = sides[0].face
                return face.belows[face.corners.index(self.vertices[n])]
        return None


class CellWalk:
    """Makes cells in a mesh (CellMesh). closed: faces that were closed as a border; only: the form
    of all cells, or None."""

    def __init__(self, mesh, only=None):
        self.mesh, self.coded, self.only = mesh, mesh.coded, only
        self.usual = {}  # pairs of choices by their place in the table
        self.decide = mesh.coded.decide
        self.front = Front(mesh.places)
        self.closed = []
        while mesh.cells_left() > 0:
            face = self.front.oldest()
            if face is not None:
                self.grow(face)
            elif self.decide("MoreSeeds"):
                self.seed()
            else:
                break

    def seed(self):
        mesh = self.mesh
        step = Step(begin(self, None))
        for c in range(step.form.corners):
            if not self.decide("SeedNew"):
                step.put(c, self.coded.index(len(mesh.keys)))
            elif self.decide("SeedShared"):
                step.put(c, mesh.meet_shared(self.coded.index(len(mesh.shared_keys))))
            else:
                step.put(c, mesh.meet_own(step.record(c)))
        self.finish(step, self.type_and_frame(step.form, 0, 0), None, 0)

    def grow(self, face):
        mesh = self.mesh
        gate = Gate(self, face)
        users = -1
        for v in face.corners:
            users &= mesh.users[v]
        if users:
            border = self.decide("Interface", gate.b, gate.least_angle, gate.m)
        else:
            border = self.decide(
                "Border", gate.degree, gate.b, min(gate.coplanar, 3), gate.least_angle, gate.m)
        if border:
            self.front.close(face)
            self.closed.append(face)
            for i, side in enumerate(face.sides):
                t = side.leads_to()
                if t is not None:
                    end(t, face.corner(i + 2), t.cells)
            return
        form, kind_and_frame, choices = self.form_at(gate)
        step = Step(form, face)
        met = len(mesh.keys)
        self.glue(step)
        for c in range(step.form.corners):
            if step.vertices[c] is None:
                step.put(c, self.other_corner(step, c))
        usual = kind_and_frame is not None
        if not usual:
            kind_and_frame = self.type_and_frame(form, face.kind, face.frame)
        self.finish(step, kind_and_frame, face.cell, met)
        if not usual and form.shape != NO_SHAPE:
            choice = (form, *kind_and_frame)
            if choices[0] is None or choice == choices[1]:
                choices[1], choices[0] = choices[0], choice
            else:
                choices[1] = choice

    def form_at(self, gate):
        """The form of the next cell and, if it is usual, its type and frame; the two choices (4.2)."""
        face = gate.face
        pattern = gate.pattern if self.only is None else 0
        place = mix(12, face.form.number + (face.number << 16), pattern,
                    face.kind + (face.frame << 8))
        choices = self.usual.setdefault(place, [None, None])
        if choices[0] is not None and len(choices[0][0].faces[0]) == gate.k:
            if self.decide("Usual", place):
                form, kind, frame = choices[0]
                return form, (kind, frame), choices
        return begin(self, gate), None, choices

    # ----- Glued faces (4.4)

    def glue(self, step):
        form = step.form
        order = [0]
        for f in order:
            for p in range(len(form.faces[f])):
                other, place = form.twins[f, p]
                x = step.glued[f][p]
                y = x.leads_to()
                if other in step.glued or y is None or len(y.face) != len(form.faces[other]):
                    continue
                corners = form.faces[other]
                n = len(corners)
                pairs = [(corners[(place + j) % n], y.face.corner(y.place + 1 - j))
                         for j in range(n)]
                if not all(step.vertices[c] == v if step.vertices[c] is not None
                           else v not in step.vertices for c, v in pairs):
                    continue
                agree = len(step.known(corners)) - 2
                o = int(f != 0) + 2 * (len(order) > 1)
                if self.decide("Glue", form.family, clamp(n, 3, 6), self.front.angle(x),
                               min(y.cells, 4), min(agree, 3), o):
                    for c, v in pairs:
                        step.vertices[c] = v
                    sides = [None] * n
                    for j in range(n):
                        sides[(place + j) % n] = y.face.sides[(y.place - j) % n]
                    step.glued[other] = sides
                    order.append(other)

    # ----- Other corners (4.5)

    def other_corner(self, step, c):
        mesh, decide = self.mesh, self.decide
        record = step.record(c)
        place = predicted(record, mesh.places)
        e = square(minus(place, mesh.places[record.slots[N1]]))
        candidates = self.candidates(step, c, place)
        near = 7
        if candidates and len(step.glued) < 3:
            distance = candidates[0][0]
            near = next((i for i, limit in enumerate(NEAR_LIMITS) if distance < limit * e), 6)
        if decide("New", min(step.form.number, 63), min(c, 15), min(len(step.glued) - 1, 7), near):
            n = sum(v is not None and mesh.users[v] != 0 for v in record.slots[N1 : N1 + 3])
            m = min(4, sum(mesh.users[v] != 0 for v in step.gate.corners))
            if decide("Shared", n, m):
                return mesh.meet_shared(mesh.name_near(place, F(4) * e, "SharedRank"))
            return mesh.meet_own(record)
        if decide("Listed"):
            for i, (_, v) in enumerate(candidates[:15]):
                if decide("Rank", min(i, 5), near):
                    return v
            require(False, "no candidate was chosen")
        return self.coded.index(len(mesh.keys))

    def candidates(self, step, c, place):
        """Vertices that may be a corner, as pairs of a squared distance and a number, ascending."""
        found = set()
        for n in step.known(step.form.network.neighbors[c]):
            for side in self.front.around(step.vertices[n]):
                found.add(side.ends())
                before = side.before()
                if before.leads_to() is None:
                    found.add(before.begins())
        found.difference_update(step.vertices)
        places = self.mesh.places
        return sorted((square(minus(place, places[v])), v) for v in found)

    # ----- The end of a step (4.6)

    def type_and_frame(self, form, parent_kind, parent_frame):
        coded = self.coded
        kind = coded.remembered(("Types", mix(10, form.shape, parent_kind, 1)), 8, "TypeTree")
        place = mix(12, kind + 256 * form.number, parent_kind, parent_frame)
        return kind, coded.remembered(("Frames", place), 8, "FrameTree")

    def finish(self, step, kind_and_frame, parent, met):
        """met: number of vertices that were met before this cell."""
        form = step.form
        kind, frame = kind_and_frame
        cell = self.mesh.cells_made()
        faces = None
        view = None
        if kind == POLYHEDRON:
            require(frame <= 1, "frame of a polyhedron")
            corners = list(step.vertices)
            faces = [form.faces[0][::-1], *form.faces[1:]]
            faces = [[step.vertices[c] for c in (face[::-1] if frame else face)] for face in faces]
        else:
            view = view_of_type(kind, frame)
            require(view is not None and view.code() == form.code, "frame of another form")
            require(form.shape != NO_SHAPE, "inline form of a cell that is no polyhedron")
            corners = [None] * form.corners
            for vertex, c in zip(step.vertices, view.corners):
                corners[c] = vertex
        self.mesh.make_cell(kind, corners, faces, parent)
        touched = self.find_touched(step, met)
        opened = self.open_faces(step, cell, kind, frame, view)
        self.link(step, opened, touched)

    def find_touched(self, step, met):
        """The front's side at each edge of the form, by its smaller side, where it is touched."""
        touched = {}
        if step.gate is None:
            return touched
        glued = {sides[0].face for sides in step.glued.values()}
        for s, t in step.form.edges:
            if s[0] in step.glued or t[0] in step.glued:
                continue
            a, b = step.ends(s)
            if a >= met or b >= met:
                continue
            for side in self.front.around(a):
                if side.face in glued:
                    continue
                if side.ends() == b:
                    touched[s] = side
                elif side.before().begins() == b:
                    touched[s] = side.before()
        return touched

    def open_faces(self, step, cell, kind, frame, view):
        """Closes the glued faces and opens the others; gives the side of each side of the form."""
        form = step.form
        for sides in step.glued.values():
            self.front.close(sides[0].face)
        opened = {}
        for f, corners in enumerate(form.faces):
            if f in step.glued:
                continue
            face_frame = frame
            if kind not in (TETRA, POLYHEDRON):
                type_face, place = view.placed[f]
                face_frame = (8 * type_face + place) * 2 + frame % 2
            n = len(corners)
            order = list(range(n)) if f else list(range(n))[::-1]
            belows = [form.below(f, corners[i]) for i in order]
            face = OpenFace(
                [step.vertices[corners[i]] for i in order],
                [None if below is None else step.vertices[below] for below in belows],
                cell, form, f, kind, face_frame)
            self.front.open(face)
            for i in range(n):
                opened[f, i] = face.sides[i if f else (n - 2 - i) % n]
        return opened

    def link(self, step, opened, touched):
        for s, t in step.form.edges:
            if s in opened and t in opened:
                join(opened[s], opened[t], 1)
                if s not in touched:
                    self.mesh.edge_log.append(tuple(step.ends(s)))
            elif s in opened or t in opened:
                a, g = (opened[s], t) if s in opened else (opened[t], s)
                g = step.front_side(g)
                x = g.leads_to()
                if x is not None:
                    join(a, x, g.cells + 1)
                else:
                    end(a, g.border, g.cells + 1)
            else:
                g, h = step.front_side(s), step.front_side(t)
                x, y = g.leads_to(), h.leads_to()
                cells = g.cells + h.cells + 1
                if x is not None and y is not None:
                    join(x, y, cells)
                elif x is not None:
                    end(x, h.border, cells)
                elif y is not None:
                    end(y, g.border, cells)
        for s, p in touched.items():
            u, v = opened[s], opened[step.form.twins[s]]
            if u.begins() == p.begins():
                u, v = v, u
            q, border, n = p.leads_to(), p.border, p.cells
            join(p, u, n + 1)
            if q is not None:
                join(q, v, n + 1)
            else:
                end(v, border, n + 1)
