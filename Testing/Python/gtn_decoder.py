#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""A decoder of `.gtn` files written from Documentation/format.md alone, to prove that this text
suffices. It is slow (thousands of tetrahedra a second), and checks all that it reads.

Here are numbering and arrays: sections 4 and 10. As a program it prints what a file holds:

    gtn_decoder.py FILE...
"""

import math
import sys

import numpy as np

from gtn_coding import FLOAT32, FLOAT64, UINT8, UINT32, Coded, Domain, RunningSpread, divide
from gtn_container import (
    CELLS, KEEP_CELLS, KEEP_CORNERS, KEEP_POINTS, POINTS, Bytes, Container, FormatError, require)
from gtn_tree import SimplerMesh, decode_merges, open_level
from gtn_walk import Geometry, Walk, apply_rule, key_spread

PREVIOUS, GATE, FIT = 0, 1, 2
NONE, REPEAT, CHANGE = 0, 1, 2

TYPES = {1: "<i1", 2: "<u1", 3: "<i2", 4: "<u2", 5: "<i4", 6: "<u4", 7: "<i8", 8: "<u8",
         FLOAT32: "<f4", FLOAT64: "<f8"}

# E(r) of section 4.
CORNERS = [
    (0, 1, 2, 3), (0, 2, 3, 1), (0, 3, 1, 2), (1, 0, 3, 2),
    (1, 3, 2, 0), (1, 2, 0, 3), (2, 3, 0, 1), (2, 0, 1, 3),
    (2, 1, 3, 0), (3, 2, 1, 0), (3, 1, 0, 2), (3, 0, 2, 1)]


class ArrayStream:
    """Modes and coded part of a stream of values (10.1)."""

    def __init__(self, stream, spatial_modes, has_before):
        stream = Bytes(stream)
        self.spatial, self.temporal = stream.number("B"), stream.number("B")
        require(self.spatial in spatial_modes, "spatial mode")
        require(self.temporal <= CHANGE, "temporal mode")
        require(self.temporal == NONE or has_before, "temporal mode without a step before")
        self.coded = Coded(stream)

    def component(self, domain):
        """Gets ready for the next component."""
        self.coded.new_models()
        self.running = RunningSpread()
        self.domain = domain
        self.null = domain.from_number(0.0)

    def value(self, prediction, group=0, spread=None):
        """A key (10.2). No spread: the running one."""
        if spread is None:
            spread = self.running.spread()
        d, _ = self.coded.residual(group, spread)
        self.running.update(d)
        return self.domain.add(prediction, d)


def decode_list(stream, domains, count, before=None, parents=None):
    """Keys of each component of `count` values on a block (10.3) or, with parents, on tetrahedra
    (10.5). before: the same at the step before, if the array has a before."""
    if stream is None:
        require(count == 0, "no stream for values")
        return [[] for _ in domains]
    modes = (PREVIOUS,) if parents is None else (PREVIOUS, GATE)
    stream = ArrayStream(stream, modes, before is not None)
    result = []
    for c, domain in enumerate(domains):
        stream.component(domain)
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
                p = domain.from_number(number(before[c][i]) + change)
            now.append(stream.value(p))
        result.append(now)
    return result


class ChunkMesh:
    """The decoded mesh of a chunk, and what predicts values on it.

    shared_points: global numbers of its shared points; own: its own vertices, in order.
    """

    def __init__(self, container, number, domains, shared, shared_keys):
        """shared: pairs of a global point number and chunks that use it, by shared index."""
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
        self.geometry = Geometry(container.stream(chunk.geometry), domains)
        connectivity = container.stream(chunk.connectivity)
        self.walk = Walk(chunk, connectivity, self.geometry, domains, shared_keys, users)
        self.own = [v for v, index in enumerate(self.walk.shared) if index is None]
        self._weights = None

    def decode_points(self, stream, domains, shared_now, before=None):
        """Keys of each component on all vertices (10.4). shared_now: keys on the shared points;
        before: what this gave at the step before, if the array has a before."""
        walk = self.walk
        require(stream is not None, "no stream for values")
        stream = ArrayStream(stream, (PREVIOUS, GATE, FIT), before is not None)
        result = []
        for c, domain in enumerate(domains):
            now = [None if index is None else shared_now[c][index] for index in walk.shared]
            stream.component(domain)
            self._decode_component(stream, domain, now, before and before[c])
            result.append(now)
        return result

    def _decode_component(self, stream, domain, now, before):
        number = domain.to_number
        prev = prev_before = stream.null
        for i, v in enumerate(self.own):
            p, group, spread = prev, 0, None
            if stream.temporal == REPEAT:
                p = before[v]
            elif stream.spatial == PREVIOUS:
                if stream.temporal == CHANGE:
                    change = number(prev) - number(prev_before)
                    p = domain.from_number(number(before[v]) + change)
                    prev_before = before[v]
            else:
                predict = self._predict_gate if stream.spatial == GATE else self._predict_fit
                predicted = predict(i, domain, now)
                if predicted is not None:
                    predicted, spread, group = predicted
                    p = domain.from_number(predicted)
                    if stream.temporal == CHANGE:
                        change = predicted - predict(i, domain, before)[0]
                        p = domain.from_number(number(before[v]) + change)
                        spread = None
            now[v] = prev = stream.value(p, group, spread)

    def _predict_gate(self, i, domain, keys):
        record, used = self.walk.records[i], self.geometry.used[i]
        if record.is_seed:
            return None
        known = [keys[v] for v in record.known]
        numbers = [domain.to_number(key) for key in known]
        predicted = apply_rule(self.geometry.rules[used], numbers)
        return predicted, key_spread(known[:4]), 1 + used

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
            places = [
                [domain.to_value(k) for domain, k in zip(self.domains, key)] for key in walk.keys
            ]
            self._weights = [
                (found[v], fit_weights(places[v], [places[u] for u in found[v]]))
                for v in self.own
            ]
        return self._weights[i]


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


class Decoder:
    """A file with its whole mesh; arrays are decoded when they are asked for.

    All that is given out is in the file's own order (section 4) or, with restore, in the original
    one as far as the file keeps it.
    """

    def __init__(self, data):
        self.container = Container(data)
        self.meta, self.table = self.container.meta, self.container.table
        self.steps = self.container.steps
        coordinate_type = self.meta.coordinate_type
        self.domains = [self._domain(coordinate_type, palette) for palette in self.table.palettes]
        self._values = {}

        self.block_points = []  # global number of the first point of each block
        users = []  # chunks that use each of the shared points
        for block in self.table.blocks:
            self.block_points.append(len(users))
            for group in block.groups:
                users += [group.chunks] * group.points
        first_own = len(users)

        coordinates = self._decode_blocks([b.coordinates for b in self.table.blocks], self.domains)
        shared_of = [[] for _ in self.table.chunks]
        for point, chunks in enumerate(users):
            for chunk in chunks:
                shared_of[chunk].append((point, chunks))
        self.chunks = []
        self.first_own = []
        for number, shared in enumerate(shared_of):
            keys = [tuple(axis[point] for axis in coordinates) for point, _ in shared]
            self.chunks.append(ChunkMesh(self.container, number, self.domains, shared, keys))
            self.first_own.append(first_own)
            first_own += self.table.chunks[number].own_points

        unused = self._decode_unused(self.table.unused.coordinates, self.domains)
        for axis in range(3):
            for chunk in self.chunks:
                coordinates[axis] += [chunk.walk.keys[v][axis] for v in chunk.own]
            coordinates[axis] += unused[axis]
        self._coordinates = coordinates
        self._decode_original_order()
        self.merges = self._decode_merges()

    # ----- The mesh

    def points(self, restore=False):
        points = as_array(self.domains, self._coordinates)
        return self._restore(points, self.point_order) if restore else points

    def tets(self, restore=False):
        tets = []
        for chunk, first in zip(self.chunks, self.first_own):
            numbers = list(chunk.walk.shared)
            for i, v in enumerate(chunk.own):
                numbers[v] = first + i
            for v, index in enumerate(chunk.walk.shared):
                if index is not None:
                    numbers[v] = chunk.shared_points[index]
            tets += [[numbers[v] for v in tet] for tet in chunk.walk.tets]
        if restore:
            if self.corners is not None:
                tets = [[tet[k] for k in CORNERS[r]] for tet, r in zip(tets, self.corners)]
            if self.point_order is not None:
                tets = [[self.point_order[point] for point in tet] for tet in tets]
        tets = np.array(tets, np.int64).reshape(-1, 4)
        return self._restore(tets, self.cell_order) if restore else tets

    # ----- Arrays

    def array(self, step, number, restore=False):
        """Values (tuples, components) of an array at a step."""
        array = self.meta.arrays[number]
        values = self._decode_array(step, number)
        keys = [[] for _ in range(array.components)]
        for c, part in enumerate(keys):
            if array.where == POINTS:
                part += values.shared[c]
                for chunk, of_chunk in zip(self.chunks, values.chunks):
                    part += [of_chunk[c][v] for v in chunk.own]
                part += values.unused[c]
            else:
                for of_chunk in values.chunks:
                    part += of_chunk[c]
        result = as_array(values.domains, keys)
        order = self.point_order if array.where == POINTS else self.cell_order
        return self._restore(result, order) if restore else result

    def field_data(self, step):
        return self.container.field_data(self.steps[step])

    def _decode_array(self, s, number):
        """Keys of an array at step s and, before that, at those that it depends on."""
        if (s, number) not in self._values:
            step = self.steps[s]
            before = None if step.key else self._decode_array(s - 1, number)
            self._values[s, number] = self._decode_array_after(step, number, before)
        return self._values[s, number]

    def _decode_array_after(self, step, number, before):
        array, at = self.meta.arrays[number], step.arrays[number]
        values = ArrayValues()
        values.domains = [self._domain(array.type, palette) for palette in at.palettes]
        values.has_palette = any(palette is not None for palette in at.palettes)
        if values.has_palette or before is not None and before.has_palette:
            before = None
        if array.where == POINTS:
            old = before and before.shared
            values.shared = self._decode_blocks(at.blocks, values.domains, old)
            values.unused = self._decode_unused(at.unused, values.domains, before and before.unused)
        for i, (chunk, reference) in enumerate(zip(self.chunks, at.chunks)):
            stream = self._stream(reference)
            old = before and before.chunks[i]
            if array.where == POINTS:
                shared = [[keys[p] for p in chunk.shared_points] for keys in values.shared]
                decoded = chunk.decode_points(stream, values.domains, shared, old)
            else:
                parents = chunk.walk.parents
                decoded = decode_list(stream, values.domains, len(parents), old, parents)
            values.chunks.append(decoded)
        return values

    # ----- Parts

    def _stream(self, reference):
        return None if reference is None else self.container.stream(reference)

    def _domain(self, kind, palette):
        plain = Domain(kind)
        if palette is None:
            return plain
        keys = decode_list(self._stream(palette.stream), [plain], palette.entries)[0]
        require(all(a < b for a, b in zip(keys, keys[1:])), "palette does not ascend")
        return Domain(kind, keys)

    def _decode_blocks(self, references, domains, before=None):
        """Keys of each component on all shared points. before: the same at the step before."""
        result = [[] for _ in domains]
        for block, reference, first in zip(self.table.blocks, references, self.block_points):
            last = first + block.points
            old = before and [keys[first:last] for keys in before]
            decoded = decode_list(self._stream(reference), domains, block.points, old)
            for keys, more in zip(result, decoded):
                keys += more
        return result

    def _decode_unused(self, reference, domains, before=None):
        return decode_list(self._stream(reference), domains, self.meta.unused_points, before)

    # ----- Simpler meshes

    def after(self, n):
        """The mesh after n merges, in the file's own order."""
        require(0 <= n <= len(self.merges), "number of merges")
        return SimplerMesh(self, n)

    def level(self, number):
        """A base mesh, as a decoder of its own."""
        return open_level(self, number, Decoder)

    def _decode_merges(self):
        tree = self.container.tree
        if tree is None or tree.merges == 0:
            return []
        points = self.meta.points - self.meta.unused_points
        return decode_merges(self._stream(tree.stream), points, tree.merges)

    # ----- Original order

    def _decode_original_order(self):
        """Sets point_order, cell_order (original numbers) and corners, or None."""
        self.point_order = self.cell_order = self.corners = None
        numbers = [Domain(UINT32)]
        if self.meta.keep & KEEP_POINTS:
            shared = self._decode_blocks([b.original for b in self.table.blocks], numbers)
            order = list(shared[0])
            for chunk, entry in zip(self.chunks, self.table.chunks):
                known = [[shared[0][point] for point in chunk.shared_points]]
                keys = chunk.decode_points(self._stream(entry.original_points), numbers, known)[0]
                order += [keys[v] for v in chunk.own]
            order += self._decode_unused(self.table.unused.original, numbers)[0]
            self.point_order = permutation(order)
        if self.meta.keep & KEEP_CELLS:
            references = [entry.original_cells for entry in self.table.chunks]
            self.cell_order = permutation(self._decode_cells(references, numbers))
        if self.meta.keep & KEEP_CORNERS:
            references = [entry.corners for entry in self.table.chunks]
            self.corners = self._decode_cells(references, [Domain(UINT8)])
            require(all(r < 12 for r in self.corners), "corners")

    def _decode_cells(self, references, domains):
        result = []
        for chunk, reference in zip(self.chunks, references):
            parents = chunk.walk.parents
            result += decode_list(
                self._stream(reference), domains, len(parents), None, parents)[0]
        return result

    @staticmethod
    def _restore(values, order):
        if order is None:
            return values
        result = np.empty_like(values)
        result[order] = values
        return result


class ArrayValues:
    """Keys of an array at a step; of point arrays chunks have those of all vertices."""

    def __init__(self):
        self.domains = []
        self.has_palette = False
        self.shared = None
        self.unused = None
        self.chunks = []


def permutation(numbers):
    require(sorted(numbers) == list(range(len(numbers))), "original numbers are no permutation")
    return numbers


def as_array(domains, keys):
    """Keys of each component as an array (tuples, components) of numpy."""
    kind = np.dtype(TYPES[domains[0].kind])
    columns = [np.frombuffer(d.to_bytes(k), kind) for d, k in zip(domains, keys)]
    return np.ascontiguousarray(np.stack(columns, axis=1))


def main(names):
    for name in names:
        with open(name, "rb") as file:
            decoder = Decoder(file.read())
        decoder.container.verify_layout()
        meta = decoder.meta
        print(name, "points", meta.points, "tetrahedra", len(decoder.tets()),
              "chunks", len(decoder.chunks), "steps", len(decoder.steps))
        for s, step in enumerate(decoder.steps):
            for i, array in enumerate(meta.arrays):
                values = decoder.array(s, i, restore=True)
                where = "cells" if array.where == CELLS else "points"
                print("  time", step.time, where, repr(array.name), values.dtype, values.shape)
            for array in decoder.field_data(s):
                print("  time", step.time, "field data", repr(array.name))
        if decoder.container.tree is not None:
            print("  merges", len(decoder.merges), "base meshes after", decoder.container.tree.levels)
            print("  tetrahedra after all merges", len(decoder.after(len(decoder.merges)).tets))


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except (OSError, FormatError) as error:
        sys.exit("gtn_decoder.py: %s" % error)
