# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The fast profile of `.gtn` files: sections 6.5, 8.14, 9.5 and 10.12 of Documentation/format.md.

Part of gtn_decoder, which is written from that text alone.
"""

import numpy as np
import zstandard

from gtn_bounds import BoundedValues
from gtn_bytes import Bytes, FormatError, require
from gtn_coding import FLOAT32

MAX_VERTICES = 65535
NONE, REPEAT, CHANGE = 0, 1, 2
NEW, FAR = 0, 1
REACH = 8
FACES = (1, 2, 3), (2, 0, 3), (0, 1, 3)


def symbols(stream, count):
    """Packed symbols (6.5)."""
    stored = stream.take(stream.varint())
    if len(stored) == count:
        return stored
    try:
        decompressor = zstandard.ZstdDecompressor().decompressobj()
        found = decompressor.decompress(stored)
    except zstandard.ZstdError as error:
        raise FormatError(str(error)) from None
    require(decompressor.eof and not decompressor.unused_data and len(found) == count, "symbols")
    return found


class Numbers:
    """Numbers by their lengths (6.5). Those above `bits` have no bits."""

    def __init__(self, stream, count, bits, longest=None):
        self.lengths = list(symbols(stream, count))
        require(all(n <= (longest or bits) for n in self.lengths), "length of a number")
        stored = stream.take(stream.varint())
        needed = sum(max(n - 1, 0) for n in self.lengths if n <= bits)
        require(needed <= 8 * len(stored), "bits of numbers")
        self.bits = int.from_bytes(stored, "little")
        self.lengths.reverse()

    def number(self, n):
        low = max(n - 1, 0)
        value = self.bits & ((1 << low) - 1)
        self.bits >>= low
        return value | (1 << low if n > 0 else 0)

    def take(self):
        return self.number(self.lengths.pop())


def signed(x):
    return -(x + 1 >> 1) if x & 1 else x >> 1


class Tree:
    """Decodes the mesh of a chunk (8.14). What it gives is as of Walk, and the gates of vertices."""

    records, edge_log = (), ()

    def __init__(self, chunk, stream, geometry, domains, shared_keys):
        shared = len(shared_keys)
        self.count = chunk.own_points + shared
        require(self.count <= MAX_VERTICES, "vertices of a tree")
        stream = Bytes(stream)
        require(stream.number("B") == 8, "flags of a tree")
        flags = stream.number("B")
        require(flags <= 1, "flags of a tree")
        self.decode(stream, chunk.tets)
        self.name_shared(stream, shared)
        if flags:
            flips = symbols(stream, (chunk.tets + 7) // 8)
            for i, (a, b, c, d) in enumerate(self.tets):
                if flips[i // 8] >> i % 8 & 1:
                    self.tets[i] = [a, b, d, c]
        self.decode_points(geometry, domains, shared_keys)

    def decode_points(self, geometry, domains, shared_keys):
        """Coordinates (9.5)."""
        stream = Bytes(geometry)
        keys = []
        for i, domain in enumerate(domains):
            known = [None if s is None else shared_keys[s][i] for s in self.shared]
            decode_vertices(stream, domain, self, known)
            keys.append(known)
        self.keys = list(zip(*keys))

    def decode(self, stream, count):
        roots = stream.varint()
        require(1 <= roots <= count, "roots")
        masks = symbols(stream, (count + 1) // 2)
        masks = [m >> 3 * k & (7 if k == 0 else 31) for m in masks for k in (0, 1)]
        require(all(m < 8 for m in masks) and (count % 2 == 0 or masks.pop() == 0), "masks")
        classes = symbols(stream, count - roots)
        require(sum(bin(m).count("1") for m in masks) == len(classes), "masks")
        require(all(c < 2 + 3 * REACH for c in classes), "class")
        far = Numbers(stream, classes.count(FAR), 16)
        corners = Numbers(stream, 4 * roots, 17)
        classes = iter(classes)
        self.tets, self.parents, self.gates = [], [], []
        for head in range(count):
            if head == len(self.tets):
                require(roots > 0, "roots")
                roots -= 1
                self.tets.append([self.corner_of_root(corners.take()) for _ in range(4)])
                self.parents.append(None)
            for face in range(3):
                if masks[head] >> face & 1:
                    self.attach(head, face, next(classes), far)
        require(len(self.gates) == self.count, "vertices of a tree")

    def corner_of_root(self, number):
        met = len(self.gates)
        require(number <= met, "corner of a root")
        if number == 0:
            self.gates.append([max(met - 1, 0)] * 4)
            return met
        return met - number

    def attach(self, head, face, kind, far):
        here, parent = len(self.tets), self.tets[head]
        gate = [parent[k] for k in FACES[face]]
        met = len(self.gates)
        if kind == NEW:
            apex = met
            self.gates.append(gate + [parent[face]])
        elif kind == FAR:
            apex = met - 1 - far.take()
        else:
            way, distance = divmod(kind - 2, REACH)
            other = (here, head, head)[way] + (-1, 1, -1)[way] * (distance + 1)
            require(0 <= other < here, "tetrahedron of a symbol")
            apex = self.tets[other][3]
        require(apex >= 0, "vertex of a tree")
        self.tets.append(gate + [apex])
        self.parents.append(head)

    def name_shared(self, stream, count):
        self.shared = [None] * self.count
        numbers = Numbers(stream, 2 * count, 18)
        vertex, index = 0, -1
        for _ in range(count):
            vertex += numbers.take()
            index += 1 + signed(numbers.take())
            require(vertex < self.count and 0 <= index < count, "shared vertex")
            require(index not in self.shared, "shared vertex that was named before")
            self.shared[vertex] = index
            vertex += 1


def type_of(domain):
    is_plain = domain.palette is None and domain.scale is None
    return np.float32 if domain.kind == FLOAT32 and is_plain else np.float64


class Steps:
    """The keys of a component with a bound of errors (10.12)."""

    def __init__(self, stream, count, domain, snap):
        self.steps = Numbers(stream, count, 48)
        self.special = Numbers(stream, self.steps.lengths.count(0), domain.bits)
        self.values = BoundedValues(None, domain, snap)
        self.last = 0

    def key(self, predicted):
        number = self.steps.take()
        if number == 0:
            self.last ^= self.special.take()
            return self.last
        return self.values.key(predicted, signed(number - 1))


def has_steps(stream, domain):
    """Whether a component has steps in place of residuals (10.12)."""
    if domain.bound is None:
        return False
    is_exact = stream.number("B")
    require(is_exact <= 1, "flags of values")
    return is_exact == 0


def decode_vertices(stream, domain, tree, now, before=None, temporal=NONE):
    """Sets the keys of own vertices, which are None in `now` (10.12)."""
    is_rounded = has_steps(stream, domain)
    copies = stream.number("B")
    require(copies <= (0 if is_rounded else 1), "flags of values")
    weights = [stream.number("h") for _ in range(3)]
    weights.append(256 - sum(weights))
    require(-32768 <= weights[3] < 32768, "weights")
    real = type_of(domain)
    weights = [real(w) * real(1 / 256) for w in weights]
    longest = domain.bits + 4 * copies
    own = [v for v, key in enumerate(now) if key is None]
    if is_rounded:
        steps = Steps(stream, len(own), domain, False)
    else:
        residuals = Numbers(stream, len(own), domain.bits, longest)
    if own and own[0] == 0:
        now[0] = domain.from_number(0.0) if copies == 0 else 0

    def number(v):
        value = real(domain.to_number(now[v]))
        return value - real(domain.to_number(before[v])) if temporal == CHANGE else value

    with np.errstate(all="ignore"):
        for v in own:
            gate = tree.gates[v]
            n = 0 if is_rounded else residuals.lengths.pop()
            if n > domain.bits:
                now[v] = domain.add(now[gate[n - domain.bits - 1]], 0)
                continue
            if temporal == REPEAT:
                p = before[v]
            else:
                a, b, c, d = (w * number(u) for w, u in zip(weights, gate)) if v > 0 else 4 * [real(0)]
                predicted = ((a + b) + c) + d
                if temporal == CHANGE:
                    predicted = real(domain.to_number(before[v])) + predicted
                p = domain.from_number(float(predicted))
            now[v] = steps.key(p) if is_rounded else domain.add(p, signed(residuals.number(n)))


def decode_items(stream, domain, count, parents=None, before=None, temporal=NONE):
    """Keys on a block, or with parents on cells (10.12)."""
    is_rounded = has_steps(stream, domain)
    if is_rounded:
        steps = Steps(stream, count, domain, parents is None)
    else:
        residuals = Numbers(stream, count, domain.bits)
    real = type_of(domain)
    now = []

    def number(key):
        return real(domain.to_number(key))

    with np.errstate(all="ignore"):
        for i in range(count):
            start = i - 1 if parents is None or parents[i] is None else parents[i]
            if temporal == REPEAT or (temporal == CHANGE and i == 0):
                p = before[i]
            elif i == 0:
                p = domain.from_number(0.0)
            elif temporal == CHANGE:
                change = number(now[start]) - number(before[start])
                p = domain.from_number(float(number(before[i]) + change))
            else:
                p = now[start]
            now.append(steps.key(p) if is_rounded else domain.add(p, signed(residuals.take())))
    return now
