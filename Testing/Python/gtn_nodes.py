# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Nodes of nonlinear cells, and surface cells that are marked at the border of a walk: sections 5
and 4.7 of Documentation/cell-codec.md.

Part of gtn_decoder, which is written from that text alone.
"""

from gtn_container import require
from gtn_records import CellRecord, mix
from gtn_shapes import NODES, PIXEL
from gtn_vertices import F, minus, square

FLAT_KINDS = {3: (5, 22, 34, 7), 4: (8, 9, 23, 28, 30, 7)}
POLYGON = 7


class Nodes:
    """Decodes the nodes of cells."""

    def __init__(self, mesh):
        self.mesh = mesh
        self.of_host = {}

    def of(self, kind, corners):
        """The nodes of a cell with these corners."""
        result = []
        for host in NODES[kind][1]:
            result.append(self._node([corners[c] for c in host]))
        return result

    def _node(self, host):
        mesh, decide = self.mesh, self.mesh.coded.decide
        key = tuple(sorted(host))
        known = self.of_host.get(key)
        if known is not None and decide("IsHosts", len(host) - 2):
            return known
        if not decide("NodeNew", len(host) - 2, int(known is not None)):
            return mesh.coded.index(len(mesh.keys))
        if decide("NodeShared", sum(mesh.users[v] != 0 for v in host)):
            node = mesh.meet_shared(self._name(host))
        else:
            slots = dict(zip(("N1", "D12", "D13", "D23"), host))
            node = mesh.meet_own(CellRecord.of(**slots))
        mesh.edge_log.extend((v, node) for v in host)
        self.of_host[key] = node
        return node

    def _name(self, host):
        """The shared index of a node."""
        places = [self.mesh.places[v] for v in host]
        mean = []
        for axis in range(3):
            total = F(0)
            for place in places:
                total += place[axis]
            mean.append(total / F(len(host)))
        return self.mesh.name_near(tuple(mean), square(minus(places[0], mean)), "NodeSharedRank")


def flat_corners(kind, turn, f):
    """The corners of a cell of this type and turn over a cycle of vertices (4.7)."""
    k = len(f)
    require(kind in FLAT_KINDS.get(k, (POLYGON,)) and turn < 2 * k, "type or turn of a face")
    r = turn // 2
    corners = [f[(r + (k - i if turn % 2 else i)) % k] for i in range(k)]
    if kind == PIXEL:
        corners[2], corners[3] = corners[3], corners[2]
    return corners


def decode_marks(mesh, walk):
    """Surface cells at the faces that a walk closed as a border."""
    decide = mesh.coded.decide
    last = [0] * 6
    for face in walk.closed:
        n = walk.front.normal(face)
        axis = max(range(3), key=lambda i: (abs(n[i]), -i))
        d = 2 * axis + int(n[axis] < 0)
        users = -1
        for v in face.corners:
            users &= mesh.users[v]
        marked = decide("IsMarked", d, last[d], int(users != 0))
        last[d] = (2 * last[d] + marked) % 4
        if not marked:
            continue
        require(mesh.cells_left() > 0, "mark behind the last cell")
        k = len(face)
        kind = mesh.coded.remembered(("MarkTypes", min(k, 255)), 8, "MarkType")
        behind = mesh.kinds[face.cell]
        turn = mesh.coded.remembered(("Turns", mix(10, kind, behind, face.frame)), 8, "Turn")
        mesh.make_cell(kind, flat_corners(kind, turn, face.corners), None, face.cell)
