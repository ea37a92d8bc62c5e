# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Streams, records and geometry of chunks of cells: sections 1 and 7 of
Documentation/cell-codec.md, in which names are the same.

Part of gtn_decoder, which is written from that text alone.
"""

from gtn_bytes import Bytes, require
from gtn_coding import Coded
from gtn_planes import PLANES, REPEATS, Planes
from gtn_vertices import F
from gtn_walk import apply_rule, key_spread

N1, N2, N3, D12, D13, D23, O, B1, B2, B3 = range(10)
SLOTS = 10
NAMED, FITTED = 1, 2
SEED_GROUP = 32

#: The common rules (7.2).
COMMON = [
    [256, 256, 256, -256, -256, -256, 256, 0, 0, 0],
    [256, 256, 0, -256, 0, 0, 0, 0, 0, 0],
    [256, 0, 256, 0, -256, 0, 0, 0, 0, 0],
    [0, 256, 256, 0, 0, -256, 0, 0, 0, 0],
    [512, 0, 0, 0, 0, 0, 0, -256, 0, 0],
    [0, 512, 0, 0, 0, 0, 0, 0, -256, 0],
    [0, 0, 512, 0, 0, 0, 0, 0, 0, -256],
    [171, 171, 170, -85, -85, -86, 0, 0, 0, 0],
    [256, 128, 128, -128, -128, 0, 0, 0, 0, 0],
    [128, 128, 0, 0, 0, 0, 0, 0, 0, 0],
    [64, 0, 0, 64, 64, 64, 0, 0, 0, 0],
    [86, 0, 0, 85, 85, 0, 0, 0, 0, 0],
    [128, 0, 0, 128, 0, 0, 0, 0, 0, 0],
    [0, 0, 256, 0, 0, 0, 0, 0, 0, 0],
    [0, 256, 0, 0, 0, 0, 0, 0, 0, 0],
    [256, 0, 0, 0, 0, 0, 0, 0, 0, 0]]


def mask_of(slots):
    return sum(1 << i for i, slot in enumerate(slots) if slot is not None)


NEEDED = [mask_of([weight or None for weight in rule]) for rule in COMMON]


def first_common(mask):
    """The first common rule that a record with this mask can be used with."""
    return next(rule for rule, needed in enumerate(NEEDED) if needed & ~mask == 0)


class CellRecord:
    """The record of an own vertex (7.1): ten slots, each a vertex or None."""

    def __init__(self, slots=None):
        self.slots = [None] * SLOTS if slots is None else slots
        self.is_seed = self.slots[N1] is None
        self.mask = mask_of(self.slots)

    @classmethod
    def of(cls, **slots):
        """Of slots by name."""
        result = [None] * SLOTS
        for name, vertex in slots.items():
            result[globals()[name]] = vertex
        return cls(result)


class CellGeometry:
    """The geometry stream (7.2). used: the used rule of each own vertex, in order."""

    def __init__(self, stream, domains):
        self.domains = domains
        self.used = []
        self.last = (0, 0, 0)
        self.spreads = [20] * 3
        stream = Bytes(stream)
        modes = stream.number("B")
        self.mode, planes = modes & 3, modes >> 2
        require(self.mode <= FITTED and planes in (0, PLANES, REPEATS), "mode of a geometry")
        self.rules = list(COMMON)
        self.fitted = {}
        if self.mode == FITTED:
            before = 0
            count = stream.number("B")
            require(count <= 64, "number of fitted rules")
            for _ in range(count):
                mask = stream.number("H")
                require(before < mask < 1 << SLOTS and mask & 1, "mask of a fitted rule")
                before = mask
                self.fitted[mask] = len(self.rules)
                self.rules.append(
                    [stream.number("h") if mask >> i & 1 else 0 for i in range(SLOTS)])
        self.coded = Coded(stream)
        self.planes = Planes(self.coded, domains, planes == REPEATS) if planes else None

    def _rule(self, mask):
        if self.mode == NAMED:
            node = 1
            for _ in range(4):
                node = 2 * node + self.coded.decide("Named", mask, node)
            rule = node - 16
            require(NEEDED[rule] & ~mask == 0, "rule for slots that are not there")
            return rule
        return self.fitted[mask] if mask in self.fitted else first_common(mask)

    def vertex(self, record, keys):
        """Keys of the next own vertex. keys: those of all vertices met before."""
        rule, group = 0, SEED_GROUP
        if not record.is_seed:
            rule = self._rule(record.mask)
            group = min(rule, 31)
        self.used.append(rule)
        if self.planes:
            self.planes.meet_until(len(keys))
            if self.planes.can_code(record):
                self.last = self.planes.vertex(record, group, self._place(rule, record, keys), keys)
                return self.last
        grade = 0
        key = []
        for i, domain in enumerate(self.domains):
            if record.is_seed:
                p, spread = self.last[i], domain.bits
            else:
                known = [None if v is None else keys[v][i] for v in record.slots]
                p = domain.from_number(self._apply(rule, domain, known))
                spread = record_spread(known)
                if spread is None:
                    spread = self.spreads[i]
                self.spreads[i] = spread
            d, grade = self.coded.residual((i, group, grade), spread)
            key.append(domain.add(p, d))
        self.last = tuple(key)
        return self.last

    def _place(self, rule, record, keys):
        """The three predicted numbers."""
        return [self._apply(rule, domain, [None if v is None else keys[v][i] for v in record.slots])
                for i, domain in enumerate(self.domains)]

    def _apply(self, rule, domain, known):
        numbers = [0.0 if key is None else domain.to_number(key) for key in known]
        return apply_rule(self.rules[rule], numbers)

    def predict(self, record, used, domain, keys):
        """Number, spread (None: the running one) and group of a value (7.3), or nothing."""
        if record.is_seed:
            return None
        known = [None if v is None else keys[v] for v in record.slots]
        return self._apply(used, domain, known), record_spread(known), min(1 + used, 16)

    def predict_number(self, record, used, numbers):
        """The number alone, from numbers of the vertices, or nothing."""
        if record.is_seed:
            return None
        return apply_rule(
            self.rules[used], [0.0 if v is None else numbers[v] for v in record.slots])


def predicted(record, places):
    """The predicted place of a vertex with this record (4.5)."""
    rule = COMMON[first_common(record.mask)]
    result = []
    for axis in range(3):
        total = F(0)
        for weight, v in zip(rule, record.slots):
            if weight:
                total += F(weight) * places[v][axis]
        result.append(total * F(1 / 256))
    return tuple(result)


def record_spread(known):
    """Of the keys in the slots, or None if there is just one."""
    there = [key for key in known[: O + 1] if key is not None]
    for key in known[B1:]:
        if len(there) < 2 and key is not None:
            there.append(key)
    return key_spread(there) if len(there) > 1 else None


def mix(n, a, b, c):
    """The place in a table of 2^n of this context (section 1)."""
    return (a * 0x9E3779B1 + b * 0x85EBCA6B + c * 0xC2B2AE35) % (1 << 32) >> 32 - n


class CellCoded(Coded):
    """The entropy-coded part of a connectivity stream (section 1)."""

    def __init__(self, stream):
        self.memories = {}
        super().__init__(stream)

    def last(self, memory, skip=None):
        """One of the last two symbols of a memory, or None."""
        for i, symbol in enumerate(self.memories.get(memory, ())):
            if symbol is not None and not (skip and skip(symbol)):
                if self.decide("LastTwo", memory, i):
                    return symbol
        return None

    def keep(self, memory, symbol):
        two = self.memories.setdefault(memory, [None, None])
        if two[0] is None:
            two[0] = symbol
        elif two[1] == symbol:
            two.reverse()
        elif two[0] != symbol:
            two[1] = symbol

    def remembered(self, memory, bits, *models):
        """What is in a memory, or else a number of so many bits, which is kept."""
        symbol = self.last(memory)
        if symbol is None:
            symbol = self.tree(bits, *models)
        self.keep(memory, symbol)
        return symbol
