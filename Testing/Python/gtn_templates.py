# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Chunks of cells in the fast profile: section 10 of Documentation/cell-codec.md.

Part of gtn_decoder, which is written from that text alone.
"""

from gtn_bytes import Bytes, require
from gtn_cells import OriginalCorners
from gtn_fast import MAX_VERTICES, Numbers, Tree, signed, symbols
from gtn_shapes import POLYHEDRON

TEMPLATES = 32
MAX_CELLS, MAX_VALUES = 1 << 20, 1 << 24
ESCAPE = 255
NEW_PLACE, FAR_PLACE, NO_PLACE = 24, 32, 40
NEW, FAR, NEAR = 0, 1, 2


def varint(stream, most):
    number = stream.varint()
    require(number <= most, "number of a template")
    return number


class Template:
    """An entry of the dictionary (10.1)."""

    def __init__(self, stream):
        self.kind, flags, sizes = (stream.number("B") for _ in range(3))
        require(flags <= 3, "flags of a template")
        self.knows_sources, self.is_sized = bool(flags & 1), bool(flags & 2)
        self.head, self.sources = sizes & 15, sizes >> 4
        require(self.head <= 8 and self.sources <= 3, "sizes of a template")
        self.places = list(stream.take(self.head))
        self.news = self.fars = 0
        for place in self.places:
            self.news += place == NEW_PLACE + self.news
            self.fars += place == FAR_PLACE + self.fars
            require(self.knows(place, self.news), "place of a template")
        self.gates = [list(stream.take(4)) for _ in range(self.news)]
        for w, gate in enumerate(self.gates):
            require(all(self.knows(place, w) for place in gate), "gate of a template")
        self.rest = 0 if self.is_sized else varint(stream, MAX_VALUES)
        self.rest_gates = []
        if self.is_sized or self.rest > 0:
            count = stream.number("B")
            require(count <= 24, "gates of a template")
            self.rest_gates = [list(stream.take(4)) for _ in range(count)]
        for k, gate in enumerate(self.rest_gates):
            require(all(c == 255 or c < self.head + k for c in gate), "gate of a template")
        self.hidden, self.pattern = 0, None
        if self.kind == POLYHEDRON:
            require(not self.is_sized, "size of a polyhedron")
            self.hidden = varint(stream, self.rest)
            self.pattern = varint(stream, MAX_VALUES)

    def knows(self, place, news):
        return place < NEW_PLACE + news or FAR_PLACE <= place < FAR_PLACE + self.fars


class TemplateMesh(Tree):
    """Decodes the mesh of a chunk. What it gives is as of CellMesh, and the gates of vertices."""

    def __init__(self, chunk, stream, geometry, domains, shared_keys):
        counts, shared = chunk.cells, len(shared_keys)
        self.counts = counts
        self.count = chunk.own_points + shared
        values = counts.corners + counts.face_values
        require(1 <= counts.cells <= MAX_CELLS and values <= MAX_VALUES, "size of a chunk")
        require(1 <= self.count <= min(MAX_VERTICES, values), "vertices of templates")
        require(len(stream) > max(counts.cells // 256, values // 16384), "length of a stream")
        stream = Bytes(stream)
        require(stream.number("B") == TEMPLATES, "flags of templates")
        self.read_dictionary(stream)
        self.read_streams(stream)
        self.kinds, self.corners, self.faces, self.parents, self.gates = [], [], [], [], []
        self.start = [0xFFFFFFFF] * 3
        for i in range(counts.cells):
            self.make_cell(i)
        require(len(self.gates) == self.count, "vertices of templates")
        require(sum(map(len, self.corners)) == counts.corners, "corners of templates")
        found = sum(1 + len(face) for faces in self.faces for face in faces or ())
        require(found == counts.face_values, "faces of templates")
        require(self.kinds.count(POLYHEDRON) == counts.polyhedra, "number of polyhedra")
        self.name_shared(stream, shared)
        self.decode_points(geometry, domains, shared_keys)

    def read_dictionary(self, stream):
        cells = self.counts.cells
        size = varint(stream, 4096 + 64 * cells + 4 * self.counts.face_values)
        stream = Bytes(symbols(stream, size))
        self.templates = [Template(stream) for _ in range(varint(stream, cells))]
        self.patterns = []
        for _ in range(varint(stream, cells)):
            faces = []
            for _ in range(stream.varint()):
                size = stream.varint()
                require(size <= MAX_VALUES, "corners of a face")
                faces.append([varint(stream, MAX_VALUES) for _ in range(size)])
            self.patterns.append(faces)
        for template in self.templates:
            if template.pattern is not None:
                require(template.pattern < len(self.patterns), "pattern")
                points = template.head + template.rest
                faces = self.patterns[template.pattern]
                require(all(k < points for face in faces for k in face), "pattern")
        require(stream.left() == 0, "end of a dictionary")

    def read_streams(self, stream):
        def numbers(count, bits):
            if count == 0:
                return iter(())
            found = Numbers(stream, count, bits)
            return iter([found.take() for _ in range(count)])

        ids = list(symbols(stream, self.counts.cells))
        more = numbers(ids.count(ESCAPE), 21)
        self.ids = [n + next(more) if n == ESCAPE else n for n in ids]
        require(max(self.ids) < len(self.templates), "number of a template")
        used = [self.templates[n] for n in self.ids]
        unknown = sum(t.sources for t in used if not t.knows_sources)
        differences = symbols(stream, unknown)
        self.differences = iter(differences)
        self.distances = numbers(differences.count(ESCAPE), 21)
        self.head_fars = numbers(sum(t.fars for t in used), 16)
        sizes = list(numbers(sum(t.is_sized for t in used), 25))
        self.sizes = iter(sizes)
        rest = sum(t.rest for t in used) + sum(sizes)
        require(
            sum(t.head - t.hidden for t in used) + rest == self.counts.corners, "corners of cells")
        rests = symbols(stream, rest)
        self.rests = iter(rests)
        self.rest_fars = numbers(rests.count(FAR), 16)

    def meet(self, gate):
        self.gates.append(gate)
        return len(self.gates) - 1

    def known(self, vertex):
        require(0 <= vertex < len(self.gates), "vertex of templates")
        return vertex

    def make_cell(self, i):
        template = self.templates[self.ids[i]]
        self.find_sources(template, i)
        corners = self.make_head(template)
        points = corners + self.make_rest(template, corners)
        self.kinds.append(template.kind)
        self.corners.append(corners)
        faces = None
        if template.pattern is not None:
            faces = [[points[k] for k in face] for face in self.patterns[template.pattern]]
        self.faces.append(faces)
        self.parents.append(self.start[0] if template.sources > 0 else None)

    def find_sources(self, template, i):
        self.start = [(s + 1) % 2**32 for s in self.start]
        for s in range(0 if template.knows_sources else template.sources):
            d = next(self.differences)
            self.start[s] = (
                i - 1 - next(self.distances) if d == ESCAPE else self.start[s] + signed(d)) % 2**32
        require(all(s < i for s in self.start[:template.sources]), "source")
        self.near = [self.corners[s] if s < i else [] for s in self.start]

    def make_head(self, template):
        places = {NO_PLACE: 0}
        for s, near in enumerate(self.near):
            for c in range(8):
                places[8 * s + c] = near[c] if c < len(near) else 0
        met = len(self.gates)
        for k in range(template.fars):
            places[FAR_PLACE + k] = self.known(met - 1 - next(self.head_fars))
        for w, gate in enumerate(template.gates):
            places[NEW_PLACE + w] = self.meet([places[place] for place in gate])
        return [places[place] for place in template.places]

    def make_rest(self, template, corners):
        """Appends the corners, and gives the hidden ones."""
        rest = next(self.sizes) if template.is_sized else template.rest
        hidden = []
        for k in range(rest):
            symbol = next(self.rests)
            if symbol == NEW:
                vertex = self.meet(self.rest_gate(template, corners, k))
            elif symbol == FAR:
                vertex = self.known(len(self.gates) - 1 - next(self.rest_fars))
            else:
                s, c = divmod(symbol - NEAR, 32)
                require(s < template.sources and c < len(self.near[s]), "corner of a source")
                vertex = self.near[s][c]
            (corners if k < rest - template.hidden else hidden).append(vertex)
        return hidden

    def rest_gate(self, template, corners, k):
        before = max(len(self.gates) - 1, 0)
        if k < len(template.rest_gates):
            return [corners[c] if c < len(corners) else before for c in template.rest_gates[k]]
        a = corners[-1] if corners else before
        b = corners[-2] if len(corners) > 1 else a
        return [a, a, b, b]

    def original_corners(self, stream):
        """Corners and faces of all cells as they were in the input (8)."""
        if stream is None:
            return self.corners, self.faces
        return OriginalCorners(self, stream).result()
