# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Arrays of `.gtn` files: section 10 of Documentation/format.md.

Part of gtn_decoder, which is written from that text alone.
"""

import math
import sys

from gtn_bounds import BoundedValues, signed
from gtn_bytes import Bytes, require
from gtn_cells import TURNS, CellMesh, split
from gtn_coding import (
    FLOAT32, FLOAT64, MAX_FLOAT32, UINT8, Coded, Domain, RunningSpread, divide)
from gtn_fast import Tree, decode_items, decode_vertices
from gtn_quadratic import (
    Lists, PlainPredictor, Predictor, decode_component, decode_places, find_cell_neighbors,
    find_cell_places, find_neighbors)
from gtn_records import CellGeometry
from gtn_shapes import TETRA
from gtn_templates import TEMPLATES, TemplateMesh
from gtn_walk import Geometry, Walk, key_spread

PREVIOUS, GATE, FIT, QUADRATIC, PLAIN_QUADRATIC, FAST = 0, 1, 2, 3, 4, 5
QUADRATICS = {QUADRATIC: Predictor, PLAIN_QUADRATIC: PlainPredictor}
NONE, REPEAT, CHANGE = 0, 1, 2
PROGRESSION = 3
TREE = 8


class ArrayStream:
    """Modes and coded part of a stream of values (10.1)."""

    def __init__(self, stream, spatial_modes, has_before):
        stream = Bytes(stream)
        self.spatial, self.temporal = stream.number("B"), stream.number("B")
        require(self.spatial in spatial_modes, "spatial mode")
        require(self.temporal <= CHANGE, "temporal mode")
        require(self.temporal == NONE or has_before, "temporal mode without a step before")
        require(self.spatial not in QUADRATICS or self.temporal != REPEAT, "modes")
        self.stream = stream
        self.coded = None if self.spatial == FAST else Coded(stream)

    def component(self, domain, snap=False):
        """Gets ready for the next component. snap: whether values with errors are on a lattice."""
        self.coded.new_models()
        self.bounded = None
        if domain.bound is not None and not self.coded.raw(1):
            self.bounded = BoundedValues(self.coded, domain, snap)
        self.running = RunningSpread()
        self.domain = domain
        self.null = domain.from_number(0.0)

    def predict(self, number):
        """What value() takes for a predicted number."""
        return float(number) if self.bounded else self.domain.from_number(number)

    def guess(self, number, error, group, place):
        """A key of which a number and, if it is known, its error are predicted (10.10)."""
        if self.spatial == PLAIN_QUADRATIC:
            return self.plain(float(number) if self.bounded else self.domain.from_number(number))
        if self.bounded:
            return self.bounded.value(float(number), place, (), error)
        p, spread = self.domain.from_number(number), None
        if error is not None:
            width = error_in_keys(self.domain, number, error)
            bits = width.bit_length()
            group = 3 if bits >= 2 and width >> (bits - 2) & 1 else 2
            spread = bits + 2
        return self.value(p, group, spread)

    def value(self, prediction, group=0, spread=None, place=None, around=()):
        """A key (10.2). No spread: the running one. place, around: those of the value and of
        others for values with errors (10.7)."""
        if self.spatial == PLAIN_QUADRATIC:
            return self.plain(prediction)
        if self.bounded:
            return self.bounded.value(prediction, place, around)
        if spread is None:
            spread = self.running.spread()
        d, _ = self.coded.residual(group, spread)
        self.running.update(d)
        return self.domain.add(prediction, d)

    def plain(self, prediction):
        """A key in the mode plain quadratic (10.11). prediction: a key, or a number for values with
        errors."""
        spread = self.running.spread()
        length, _ = self.coded.length(("plain", min(spread, 15)), spread)
        if self.bounded and length > 46:
            require(length == 64, "number of steps")
            return self.bounded.plain_special()
        rest = self.coded.raw(length)
        magnitude = (1 << length - 1) + (rest >> 1) if length > 0 else 0
        d = signed(-magnitude if rest & 1 else magnitude)
        self.running.update(d)
        if self.bounded:
            return self.bounded.key(prediction, d)
        return self.domain.add(prediction, d)


def decode_list(stream, domains, count, before=None, parents=None, lists=None):
    """Keys of each component of `count` values on a block (10.3) or, with parents, on cells
    (10.5). before: the same at the step before, if the array has a before. lists: gives those of
    the mode quadratic, if it is allowed."""
    if stream is None:
        require(count == 0, "no stream for values")
        return [[] for _ in domains]
    modes = (PREVIOUS, FAST) if parents is None else (PREVIOUS, GATE, FAST)
    modes += (*QUADRATICS,) if lists else ()
    stream = ArrayStream(stream, modes, before is not None)
    if stream.spatial == FAST:
        return [
            decode_items(stream.stream, domain, count, parents, before and before[c], stream.temporal)
            for c, domain in enumerate(domains)]
    result = []
    for c, domain in enumerate(domains):
        stream.component(domain, parents is None)
        if stream.spatial in QUADRATICS:
            changes = stream.temporal == CHANGE
            result.append(decode_places(
                stream, QUADRATICS[stream.spatial], lists(), domain, parents, count,
                before[c] if changes else None))
            continue
        number = domain.to_number
        now = []
        for i in range(count):
            start = i - 1 if i > 0 else None
            if stream.spatial == GATE and parents[i] is not None:
                start = parents[i]
            near = stream.null if start is None else now[start]
            p = near
            if stream.temporal == REPEAT:
                p = before[c][i]
            elif stream.temporal == CHANGE and start is not None:
                change = number(near) - number(before[c][start])
                p = stream.predict(number(before[c][i]) + change)
            around = () if i == 0 else (i - 1, start)
            now.append(stream.value(p, place=i, around=around))
        result.append(now)
    return result


class ChunkMesh:
    """The decoded mesh of a chunk, and what predicts values on it.

    shared_points: global numbers of its shared points; own: its own vertices, in order.
    """

    def __init__(self, container, number, domains, shared, shared_keys, shapes):
        """shared: pairs of a global point number and chunks that use it, by shared index; shapes:
        those of the file (Shapes)."""
        chunk = container.table.chunks[number]
        self.shared_points = [point for point, _ in shared]
        neighbors = sorted({c for _, chunks in shared for c in chunks if c != number})
        places = {c: min(i, 31) for i, c in enumerate(neighbors)}
        users = []
        for _, chunks in shared:
            mask = 0
            for c in chunks:
                if c != number:
                    mask |= 1 << places[c]
            users.append(mask)

        self.domains = domains
        geometry, connectivity = map(container.stream, (chunk.geometry, chunk.connectivity))
        self.is_walk = chunk.cells is None
        self.is_tree = len(connectivity) > 0 and connectivity[0] == (
            TREE if self.is_walk else TEMPLATES)
        if self.is_tree and not self.is_walk:
            self.walk = TemplateMesh(chunk, connectivity, geometry, domains, shared_keys)
            tets = [tet for _, tet in self.tets()]
            require(len(tets) == chunk.tets, "tetrahedra of a chunk of cells")
        elif self.is_tree:
            self.walk = Tree(chunk, connectivity, geometry, domains, shared_keys)
        elif self.is_walk:
            self.geometry = Geometry(geometry, domains)
            self.walk = Walk(chunk, connectivity, self.geometry, domains, shared_keys, users)
        else:
            self.geometry = CellGeometry(geometry, domains)
            self.walk = CellMesh(
                chunk, connectivity, self.geometry, domains, shared_keys, users, shapes)
            tets = [tet for _, tet in self.tets()]
            require(len(tets) == chunk.tets, "tetrahedra of a chunk of cells")
        self.own = [v for v, index in enumerate(self.walk.shared) if index is None]
        self._weights = None
        self._quadratic = self._cell_lists = None

    def cells(self):
        """Type, vertices and, of polyhedra, faces of each cell."""
        walk = self.walk
        if self.is_walk:
            return [(TETRA, tet, None) for tet in walk.tets]
        return list(zip(walk.kinds, walk.corners, walk.faces))

    def tets(self):
        """The cell and the vertices of each tetrahedron."""
        if self.is_walk:
            return list(enumerate(self.walk.tets))
        order = [tuple(d.plain(k) for d, k in zip(self.domains, key)) for key in self.walk.keys]
        return [(i, tet) for i, cell in enumerate(self.cells())
                for tet in split(*cell, order.__getitem__, self.place)]

    def place(self, vertex):
        key = self.walk.keys[vertex]
        return tuple(float(d.to_value(k)) for d, k in zip(self.domains, key))

    def restore_corners(self, stream, keeps):
        """Sets original_cells, as cells() with corners as they were in the input. stream: None if
        there is none; keeps: whether the file keeps corners."""
        self.original_cells = self.cells()
        if not keeps:
            return
        if not self.is_walk:
            walk = self.walk
            self.original_cells = list(zip(walk.kinds, *walk.original_corners(stream)))
            return
        parents = self.walk.parents
        turns = decode_list(stream, [Domain(UINT8)], len(parents), None, parents)[0]
        require(all(r < len(TURNS) for r in turns), "corners")
        self.original_cells = [
            (kind, [tet[k] for k in TURNS[r]], None)
            for (kind, tet, _), r in zip(self.original_cells, turns)]

    def decode_points(self, stream, domains, shared_now, before=None):
        """Keys of each component on all vertices (10.4). shared_now: keys on the shared points;
        before: what this gave at the step before, if the array has a before."""
        walk = self.walk
        require(stream is not None, "no stream for values")
        modes = (FAST,) if self.is_tree else (PREVIOUS, GATE, FIT, *QUADRATICS)
        stream = ArrayStream(stream, modes, before is not None)
        result = []
        for c, domain in enumerate(domains):
            now = [None if index is None else shared_now[c][index] for index in walk.shared]
            if stream.spatial == FAST:
                decode_vertices(
                    stream.stream, domain, walk, now, before and before[c], stream.temporal)
                result.append(now)
                continue
            stream.component(domain)
            if stream.spatial in QUADRATICS:
                changes = stream.temporal == CHANGE
                predictor = QUADRATICS[stream.spatial](self._lists(), len(now), self._other)
                decode_component(
                    stream, predictor, domain, self.own, now, before[c] if changes else None)
            else:
                self._decode_component(stream, domain, now, before and before[c])
            result.append(now)
        return result

    def _decode_component(self, stream, domain, now, before):
        number = domain.to_number
        prev = prev_before = stream.null
        # The keys whose numbers predictions use.
        seen, seen_before = now, before
        is_predicted = stream.spatial != PREVIOUS and stream.temporal != REPEAT
        if stream.bounded and is_predicted:
            finite = stream.bounded.finite
            seen = [None if key is None else finite(key) for key in now]
            if stream.temporal == CHANGE:
                seen_before = [finite(key) for key in before]
        for i, v in enumerate(self.own):
            p, group, spread, around = prev, 0, None, ()
            if stream.temporal == REPEAT:
                p = before[v]
            elif stream.spatial == PREVIOUS:
                if stream.temporal == CHANGE:
                    change = number(prev) - number(prev_before)
                    p = stream.predict(number(before[v]) + change)
                    prev_before = before[v]
            else:
                predict = self._predict_gate if stream.spatial == GATE else self._predict_fit
                predicted = predict(i, domain, seen)
                around = self._around(i, stream.spatial) if stream.bounded else ()
                if predicted is not None:
                    predicted, spread, group = predicted
                    p = stream.predict(predicted)
                    if stream.temporal == CHANGE:
                        change = predicted - predict(i, domain, seen_before)[0]
                        p = stream.predict(number(seen_before[v]) + change)
                        spread = None
            now[v] = prev = stream.value(p, group, spread, v, around)
            if seen is not now:
                seen[v] = finite(prev)

    def _around(self, i, spatial):
        """The vertices whose steps tell about those of own vertex number i (10.7)."""
        if spatial == FIT:
            return self._neighbors(i)[0]
        record = self.walk.records[i]
        if not self.is_walk:
            return [v for v in record.slots if v is not None]
        return [] if record.is_seed else record.known[:4]

    def _predict_gate(self, i, domain, keys):
        return self.geometry.predict(self.walk.records[i], self.geometry.used[i], domain, keys)

    def _predict_fit(self, i, domain, keys):
        neighbors, weights = self._neighbors(i)
        m = len(neighbors)
        if m == 0:
            return None
        predicted = 0.0
        for u, w in zip(neighbors, weights):
            predicted += w * domain.to_number(keys[u])
        group = 0 if m < 4 else 1 if m < 6 else 2 if m < 8 else 3 if m < 11 else 4
        return predicted, key_spread([keys[u] for u in neighbors]), group

    def _lists(self):
        """Those of the own vertices for the mode quadratic."""
        if self._quadratic is None:
            places = self._places()
            lists = find_neighbors(self.walk.edge_log, self.own, places)
            is_shared = [index is not None for index in self.walk.shared]
            self._quadratic = Lists(lists, self.own, places, is_shared)
        return self._quadratic

    def cell_lists(self):
        """Those of the cells."""
        if self._cell_lists is None:
            cells = self.walk.tets if self.is_walk else self.walk.corners
            places = find_cell_places(cells, self._places())
            self._cell_lists = Lists(
                find_cell_neighbors(cells, places), range(len(cells)), places)
        return self._cell_lists

    def _other(self, i, numbers):
        return self.geometry.predict_number(self.walk.records[i], self.geometry.used[i], numbers)

    def _places(self):
        return [[domain.to_value(k) for domain, k in zip(self.domains, key)]
                for key in self.walk.keys]

    def _neighbors(self, i):
        """Neighbors of own vertex number i, and their weights (10.6)."""
        if self._weights is None:
            walk = self.walk
            found = {v: [] for v in self.own}
            for pair in walk.edge_log:
                a, b = max(pair), min(pair)
                if a in found:
                    found[a].append(b)
                elif b in found:
                    found[b].append(a)
            places = self._places()
            self._weights = [
                (found[v], fit_weights(places[v], [places[u] for u in found[v]]))
                for v in self.own
            ]
        return self._weights[i]


def error_in_keys(domain, number, error):
    """How far the key is that is off by an error, away from zero (10.10)."""
    off = number - error if number < 0 else number + error
    return abs(domain.from_number(off) - domain.from_number(number))


def fit_weights(c, q):
    """Weights of neighbors at the places q around c (10.6)."""
    m = len(q)
    if m == 0:
        return []
    offsets = [(a[0] - c[0], a[1] - c[1], a[2] - c[2]) for a in q]
    mean = 0.0
    for x, y, z in offsets:
        mean += x * x + y * y + z * z
    mean = mean / m
    scale = divide(1.0, math.sqrt(mean))
    if not math.isfinite(scale):
        return [1.0 / m] * m

    offsets = [(x * scale, y * scale, z * scale) for x, y, z in offsets]
    weights = []
    A = ax = ay = az = xx = xy = xz = yy = yz = zz = 0.0
    for x, y, z in offsets:
        h = divide(1.0, x * x + y * y + z * z + 1e-6)
        hx, hy, hz = h * x, h * y, h * z
        A += h
        ax += hx
        ay += hy
        az += hz
        xx += hx * x
        xy += hx * y
        xz += hx * z
        yy += hy * y
        yz += hy * z
        zz += hz * z
        weights.append(h)
    bx = by = bz = 0.0
    if m >= 4:
        ridge = 1e-4 * (A + xx + yy + zz)
        xx += ridge
        yy += ridge
        zz += ridge
        cxx = yy * zz - yz * yz
        cxy = xz * yz - xy * zz
        cxz = xy * yz - xz * yy
        cyy = xx * zz - xz * xz
        cyz = xy * xz - xx * yz
        czz = xx * yy - xy * xy
        inverse = divide(1.0, xx * cxx + xy * cxy + xz * cxz)
        bx = (cxx * ax + cxy * ay + cxz * az) * inverse
        by = (cxy * ax + cyy * ay + cyz * az) * inverse
        bz = (cxz * ax + cyz * ay + czz * az) * inverse
    whole = divide(1.0, A - (bx * ax + by * ay + bz * az))
    return [
        h * whole * (1 - (bx * x + by * y + bz * z)) for h, (x, y, z) in zip(weights, offsets)
    ]


def decode_palette(stream, domain, count):
    """The keys of a palette (5.2)."""
    if stream[0] != PROGRESSION or domain.kind not in (FLOAT32, FLOAT64):
        return decode_list(stream, [domain], count)[0]
    stream = Bytes(stream[1:])
    origin, step = stream.number("d"), stream.number("d")
    largest = MAX_FLOAT32 if domain.kind == FLOAT32 else sys.float_info.max
    last = origin + (count - 1) * step
    require(step > 0 and abs(origin) <= largest and abs(last) <= largest, "progression")
    return [domain.from_number(origin + i * step) for i in range(count)]
