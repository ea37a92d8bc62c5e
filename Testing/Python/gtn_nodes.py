# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Nodes of nonlinear cells, and surface cells that are marked at the border of a walk: sections 5
and 4.7 of Documentation/cell-codec.md.

Part of gtn_decoder, which is written from that text alone.
"""

from gtn_bytes import require
from gtn_lattice import MAX_ORDER, Node, nodes_of, order_of, shape_of
from gtn_records import N1, CellRecord, mix, predicted
from gtn_shapes import NODES, PIXEL
from gtn_vertices import F, minus, square

FLAT_KINDS = {3: (5, 22, 34, 69, 76, 7), 4: (8, 9, 23, 28, 30, 70, 77, 7)}
POLYGON = 7


def fixed_nodes(kind):
    """Number of corners, and nodes, of a type of the table of section 5."""
    corners, hosts = NODES[kind]
    return corners, [
        Node(corners + i, [(c, 1) for c in host], dict(zip(("N1", "D12", "D13", "D23"), host)), True)
        for i, host in enumerate(hosts)]


def nodes_of_size(kind, size):
    """Those of a cell with so many points, or None."""
    if kind in NODES:
        corners, hosts = NODES[kind]
        return fixed_nodes(kind) if corners + len(hosts) == size else None
    order = order_of(kind, size)
    return nodes_of(shape_of(kind), order) if order else None


class Nodes:
    """Decodes the nodes of cells."""

    def __init__(self, mesh):
        self.mesh = mesh
        self.of_host = {}
        self.orders = {}

    def of_type(self, kind, corners):
        """All points of a cell with these corners."""
        if kind in NODES:
            return self.of(fixed_nodes(kind), corners)
        shape = shape_of(kind)
        if shape is None:
            return corners
        if not self.mesh.coded.decide("SameOrder", kind):
            self.orders[kind] = self.mesh.coded.large("Order")
        order = self.orders.get(kind, 2)
        require(1 <= order <= MAX_ORDER, "order of a cell")
        return self.of(nodes_of(shape, order), corners)

    def of(self, nodes, corners):
        count, nodes = nodes
        require(count + len(nodes) <= self.mesh.corners_left(), "points of a cell")
        points = [*corners, *[None] * len(nodes)]
        for node in nodes:
            points[node.number] = self._node(node, points)
        return points

    def _node(self, node, points):
        mesh, decide = self.mesh, self.mesh.coded.decide
        host = [(points[c], weight) for c, weight in node.host]
        key = tuple(sorted(host))
        known = self.of_host.get(key) if host else None
        if known is not None and decide("IsHosts", node.kind):
            return known
        if not decide("NodeNew", node.kind, int(known is not None)):
            return mesh.coded.index(len(mesh.keys))
        record = CellRecord.of(**{name: points[i] for name, i in node.slots.items()})
        there = [v for v in record.slots if v is not None]
        if decide("NodeShared", min(4, sum(mesh.users[v] != 0 for v in there))):
            vertex = mesh.meet_shared(self._name(node, host, record))
        else:
            vertex = mesh.meet_own(record)
        near = [v for v, _ in host] if node.between else record.slots[:2]
        mesh.edge_log.extend((v, vertex) for v in near if v is not None)
        if host:
            self.of_host[key] = vertex
        return vertex

    def _name(self, node, host, record):
        """The shared index of a node."""
        place = predicted(record, self.mesh.places)
        if node.between:
            place = []
            for axis in range(3):
                total = F(0)
                for v, weight in host:
                    total += F(weight) * self.mesh.places[v][axis]
                place.append(total / F(sum(weight for _, weight in host)))
        limit = square(minus(self.mesh.places[record.slots[N1]], place))
        return self.mesh.name_near(tuple(place), limit, "NodeSharedRank")


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
