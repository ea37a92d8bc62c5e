# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The list of a chunk of cells: section 6 of Documentation/cell-codec.md, in which names are the
same.

Part of gtn_decoder, which is written from that text alone.
"""

from gtn_bytes import require
from gtn_nodes import nodes_of_size
from gtn_records import B1, D12, D13, D23, N1, N2, SLOTS, CellRecord, O
from gtn_shapes import POLYHEDRON, edges_of, first_size, network_of

RECENT = 256
WORD = (1 << 32) - 1
MOST_SEEN = 32


class CellList:
    """Makes the cells that a mesh (CellMesh) still has to have."""

    def __init__(self, mesh):
        self.mesh, self.coded, self.decide = mesh, mesh.coded, mesh.coded.decide
        self.follower = list(range(256))
        self.last_cells = {}  # of each type the last cell, and the one before
        self.choices = {}
        self.recent = []  # the latest first
        self.next_shared = 0
        self.face_count, self.face_size = 0, 0
        self.used_by = {}  # the last cell of the list at each vertex
        last = 0
        while mesh.cells_left() > 0:
            if self.decide("FollowsType", last):
                kind = self.follower[last]
            else:
                kind = self.coded.tree(8, "ListType")
            self.follower[last] = last = kind
            self._cell(kind)

    def _cell(self, kind):
        mesh = self.mesh
        met = len(mesh.keys)
        faces = None
        if kind == POLYHEDRON:
            faces = self._faces()
            pairs = [(a, b) for face in faces for a, b in zip(face, face[1:] + face[:1])
                     if a < b and b >= met]
            if self.decide("ListsFaces"):
                corners = list(dict.fromkeys(v for face in faces for v in face))
            else:
                corners = self._corners(kind)
        else:
            corners = self._corners(kind)
            pairs = [(corners[a], corners[b]) for a, b in edges_of(kind, len(corners))]
            pairs = [(a, b) for a, b in pairs if max(a, b) >= met and a != b]
        self.last_cells[kind] = (corners, self.last_cells.get(kind, (None, None))[0])
        mesh.edge_log += pairs
        seen = [self.used_by[v] for v in corners[:MOST_SEEN] if v in self.used_by]
        parent = max(seen, key=lambda cell: (seen.count(cell), cell), default=None)
        cell = mesh.cells_made()
        for v in corners:
            self.used_by[v] = cell
        mesh.add_cell(kind, corners, faces, parent)

    # ----- Sizes

    def _size(self, models, before, most, *same):
        """same: indices of the model Same."""
        is_same = self.decide("Same", *models, *same)
        size = before if is_same else self.coded.large("Number", *models)
        require(size <= most, "size")
        return size

    # ----- Cells except polyhedra

    def _corners(self, kind):
        last, before_last = self.last_cells.get(kind, (None, None))
        size = first_size(kind) if last is None else len(last)
        size = self._size(("Size", kind), size, self.mesh.corners_left())
        corners = []
        nodes = nodes_of_size(kind, size)
        coded = nodes[0] if nodes else size
        network = network_of(kind, min(size, 64))
        v = 0
        for i in range(coded):
            row = None
            if last is not None and i < len(last):
                step = 0
                if before_last is not None and i < len(before_last):
                    step = last[i] - before_last[i]
                row = (last[i] + step) & WORD
            record = lambda i=i: self._record(network, corners, i, last)
            vertex, v = self._name((kind, min(i, 15)), v, row, record)
            corners.append(vertex)
        return self.mesh.nodes.of(nodes, corners) if nodes else corners

    def _name(self, place, v, row, record):
        """The vertex of a corner, and the choice by which it was named. place: [type, q]; v: that
        of the corner before; record: gives the record of an own vertex."""
        mesh, decide, coded = self.mesh, self.decide, self.coded
        models = (*place, self.choices.get(place, 0), v)
        if decide("IsNewCorner", *models):
            if decide("IsShared", *models):
                vertex, choice = mesh.meet_shared(self._by_sequence()), 1
            else:
                vertex, choice = mesh.meet_own(record()), 0
        elif row is not None and row < len(mesh.keys) and decide("IsRow", *models):
            vertex, choice = row, 2
        elif decide("IsRecent", *models):
            recent = coded.tree(8, "Place", *place)
            require(recent < len(self.recent), "no recent vertex")
            vertex, choice = self.recent[recent], 3
        else:
            vertex, choice = coded.index(len(mesh.keys)), 4
        self.choices[place] = choice
        if vertex in self.recent:
            self.recent.remove(vertex)
        self.recent.insert(0, vertex)
        del self.recent[RECENT:]
        return vertex, choice

    def _by_sequence(self):
        index = self.next_shared
        if not self.decide("Follows"):
            back = self.decide("Back")
            distance = self.coded.large("Distance")
            index = (index - distance if back else index + distance) & WORD
        self.next_shared = (index + 1) & WORD
        return index

    def _record(self, network, corners, c, last):
        """The record of corner c (7.1), before which there are these corners."""
        slots = [None] * SLOTS
        if c >= 64:
            slots[N1], slots[B1] = corners[c - 1], corners[c - 2]
            return CellRecord(slots)
        known = [n for n in network.neighbors[c] if n < c][:3]
        for i, n in enumerate(known):
            slots[N1 + i] = corners[n]
        between = {(0, 1): D12, (0, 2): D13, (1, 2): D23}
        for a, b, opposite in network.quadrilaterals[c]:
            if a in known and b in known:
                place = between[tuple(sorted((known.index(a), known.index(b))))]
                slots[place] = corners[opposite] if opposite < c else None
        beyond = network.beyond[c]
        if beyond is not None and beyond < c:
            slots[O] = corners[beyond]
        if slots[N2] is None and last is not None and c < len(last):
            if slots[N1] is None:
                slots[N1] = last[c]
            else:
                slots[N2] = last[c]
                place = corners.index(slots[N1])
                slots[D12] = last[place] if place < len(last) else None
        return CellRecord(slots)

    # ----- Polyhedra

    def _faces(self):
        left = self.mesh.face_values_left()
        count = self.face_count = self._size(("Faces",), self.face_count, left)
        faces = []
        for i in range(count):
            last = self.face_size
            size = self.face_size = self._size(("FaceSize",), last, left, min(last, 15))
            require(size + count - i <= left, "face values")
            left -= 1 + size
            face = []
            v = 0
            for c in range(size):
                record = lambda: self._face_record(faces, face, size)
                vertex, v = self._name((POLYHEDRON, "faces", min(c, 15)), v, None, record)
                face.append(vertex)
            faces.append(face)
        return faces

    @staticmethod
    def _face_record(faces, face, size):
        slots = [None] * SLOTS
        if face:
            slots[N1] = face[-1]
            if size == 4 and len(face) == 3:
                slots[N2], slots[D12] = face[0], face[1]
            elif len(face) >= 2:
                slots[B1] = face[-2]
        elif any(faces):
            slots[N1] = faces[-1][-1] if faces[-1] else 0
        return CellRecord(slots)
